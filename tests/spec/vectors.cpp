//   ravel_vectors FOLDER           checks spec/vectors
//   ravel_vectors --write FOLDER   writes it anew
//   ravel_vectors --trace FILE     prints all that a reader does with a file
// Checked are the sections before zstd packs them, whose versions differ.
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "spec/context_names.h"
#include "spec/invalid_files.h"
#include "spec/trace.h"
#include "spec/valid_files.h"
#include "support/file_parts.h"

using namespace ravel;
namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return in ? text.str() : "";
}
void write(const fs::path& path, std::string_view text) {
    std::ofstream(path, std::ios::binary) << text;
}
Bytes bytes_of(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}
std::string text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool same_sections(const Bytes& a, const Bytes& b) {
    constexpr std::size_t kVersionAt = 4;
    const auto x = test::take_apart(a), y = test::take_apart(b);
    if (!x || !y || x->size() != y->size() || a[kVersionAt] != b[kVersionAt]) return false;
    for (std::size_t i = 0; i < x->size(); ++i)
        if ((*x)[i].id != (*y)[i].id || (*x)[i].raw != (*y)[i].raw) return false;
    return true;
}

struct Checker {
    fs::path folder;
    bool writes = false;
    int wrong = 0;
    std::set<fs::path> known{};

    void claim(bool holds, const std::string& what) {
        if (holds) return;
        std::fprintf(stderr, "%s\n", what.c_str());
        ++wrong;
    }
    void text(const fs::path& path, const std::string& want) {
        known.insert(path);
        if (writes) write(path, want);
        claim(read(path) == want, path.string() + " is not what the code says");
    }
};

// Between them the files ask for every context block there is.
void check_valid(Checker& check) {
    std::set<std::string> blocks;
    for (const test::ValidFile& file : test::valid_files()) {
        const fs::path path = check.folder / "valid" / (file.name + ".ravel");
        check.known.insert(path);
        if (check.writes && !same_sections(bytes_of(read(path)), file.bytes))
            write(path, text_of(file.bytes));
        const Bytes stored = bytes_of(read(path));
        check.claim(same_sections(stored, file.bytes), path.string() + " is not what encode packs");
        if (stored.empty()) continue;
        const test::Trace trace = test::trace_of(stored);
        blocks.insert(trace.blocks.begin(), trace.blocks.end());
        check.claim(trace.sound, path.string() + " does not decode");
        check.text(fs::path(path).replace_extension(".txt"), file.shows + "\n\n" + trace.text);
    }
    for (const auto& [stream, all] : {std::pair{"surface ", &test::surface_blocks()},
                                      {"tet ", &test::tet_blocks()},
                                      {"positions ", &test::position_blocks()}})
        for (const test::NamedBlock& block : *all)
            check.claim(blocks.contains(stream + std::string(block.name)),
                        std::string("no file asks for ") + stream + block.name);
}

void check_invalid(Checker& check) {
    for (const test::InvalidFile& file : test::invalid_files()) {
        const fs::path path = check.folder / "invalid" / (file.name + ".ravel");
        check.text(path, text_of(file.bytes));
        DecodeOptions options;
        options.steps = true;
        if (file.row == 54) options.memory_limit = 1000;
        const Result<Decoded> decoded = decode(file.bytes, options);
        check.claim(!decoded.ok() && decoded.error().code == file.code,
                    path.string() + ": expected " + name_of(file.code) + ", decode says " +
                        (decoded.ok() ? "nothing" : name_of(decoded.error().code)));
        check.text(fs::path(path).replace_extension(".txt"),
                   std::string(name_of(file.code)) + "\nrow " + std::to_string(file.row) + ": " +
                       file.says + "\n");
    }
}

// A file that nobody makes any more is of an older format.
void check_none_left(Checker& check) {
    for (const char* folder : {"valid", "invalid"})
        for (const auto& entry : fs::directory_iterator(check.folder / folder))
            check.claim(check.known.contains(entry.path()),
                        entry.path().string() + " is made by nobody: remove it");
}

}  // namespace

int main(int count, char** words) {
    if (count == 3 && std::strcmp(words[1], "--trace") == 0) {
        const Bytes file = bytes_of(read(words[2]));
        if (file.size() < 6) return 1;
        constexpr int kAll = std::numeric_limits<int>::max() - 1;
        const test::Trace trace = test::trace_of(file, {kAll, kAll, kAll});
        std::fputs(trace.text.c_str(), stdout);
        return trace.sound ? 0 : 1;
    }
    Checker check;
    check.writes = count == 3 && std::strcmp(words[1], "--write") == 0;
    if (count != (check.writes ? 3 : 2)) return 2;
    check.folder = words[count - 1];
    try {
        check_valid(check);
        check_invalid(check);
        check_none_left(check);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
    return check.wrong == 0 ? 0 : 1;
}
