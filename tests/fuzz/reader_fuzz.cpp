// Any bytes into the reader of one format, which `format` names (its file is made by the build). A
// mesh that comes out goes through the codec, and through the format's own writer and reader.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <span>
#include <string>
#include <string_view>

#include <unistd.h>

#include "fuzz/reader_format.h"
#include "io/file_bytes.h"
#include "io/mesh_io.h"
#include "ravel/ravel.h"

namespace {

using namespace ravel;

// Memory where there is such a place: a fuzzer writes some thousand files a second.
class Folder {
  public:
    Folder() {
        const std::filesystem::path memory = "/dev/shm";
        path_ = (std::filesystem::is_directory(memory) ? memory
                                                       : std::filesystem::temp_directory_path()) /
                ("ravel-fuzz-" + std::to_string(::getpid()));
        std::filesystem::create_directories(path_);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

void write(const std::string& path, std::string_view bytes) {
    if (!io::write_file(path, bytes)) std::abort();
}

// TetGen's meshes are several files: here they follow each other, apart by a form feed.
std::string lay_out(const Folder& folder, std::string_view bytes) {
    const std::string format = test::kFormat;
    if (format != "ele") {
        write(folder / ("in." + format), bytes);
        return folder / ("in." + format);
    }
    for (const char* ending : {"node", "ele", "face", "edge"}) {
        const std::size_t end = bytes.find('\f');
        const std::string path = folder / (std::string("in.") + ending);
        std::filesystem::remove(path);
        if (!bytes.empty()) write(path, bytes.substr(0, end));
        bytes = end == std::string_view::npos ? std::string_view{} : bytes.substr(end + 1);
    }
    return folder / "in.node";
}

void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::abort();
}

// One in eight, by the bytes alone: roundtrip_fuzz is for the codec, which takes most of the time and
// whose many branches would be what a fuzzer of readers goes after.
bool goes_through_the_codec(const std::uint8_t* data, std::size_t size) {
    return std::accumulate(data, data + size, 0u) % 8 == 0;
}

void through_the_codec(const Mesh& mesh) {
    EncodeOptions options;
    options.level = 1;
    const auto packed = encode(mesh, options);
    if (!packed) fail("encode refuses: " + packed.error().detail);
    const auto again = decode(packed->bytes);
    if (!again) fail("decode refuses: " + again.error().detail);
    const Comparison same = compare_meshes(mesh, again->mesh, packed->order, 0);
    if (!same.equal) fail("the codec changes the mesh: " + same.difference);
}

// What a format wrote it can read, with as many cells as there were. (Whether every bit comes back
// is for tests/roundtrip: a soup of a hostile file may have parts that formats have no words for.)
void through_the_writer(const Folder& folder, const Mesh& mesh, bool binary) {
    const std::string path = folder / (std::string("out.") + test::kFormat);
    for (const std::string& ending : io::endings_together(path))
        std::filesystem::remove(std::filesystem::path(path).replace_extension(ending));
    std::vector<std::string> left_out;
    if (!io::write_mesh(mesh, path, {.binary = binary}, &left_out)) return;
    const auto again = io::read_mesh(path);
    if (!again) fail("what was written can't be read: " + again.error().detail);
    if (left_out.empty() && again->cell_count() != mesh.cell_count())
        fail("cells are lost on the way through the format");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Folder folder;
    const std::string path = lay_out(folder, {reinterpret_cast<const char*>(data), size});
    const auto mesh = io::read_mesh(path);
    if (!mesh) {
        if (mesh.error().detail.empty()) fail("an error without words");
        return 0;
    }
    if (const Status status = check_mesh(*mesh); !status) fail("a broken mesh");
    if (mesh->corners.size() > 4000 || mesh->point_count() > 4000) return 0;
    if (goes_through_the_codec(data, size)) through_the_codec(*mesh);
    for (const bool binary : {false, true}) through_the_writer(folder, *mesh, binary);
    return 0;
}
