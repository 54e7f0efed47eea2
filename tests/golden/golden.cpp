// Prints one row per recipe and options: hashes of the file, of its sections before zstd, and of
// the decoded mesh. Two machines agree where their rows do.
//   ravel_golden            rows of sections and meshes: tests/golden/goldens.txt
//   ravel_golden --files    with the hash of the whole file, which zstd's version may change
#include <zstd.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "make/make_mesh.h"
#include "ravel/ravel.h"
#include "support/file_parts.h"
#include "support/quadratic_tets.h"

namespace {

using namespace ravel;

// FNV-1a, 64 bits: enough to tell rows apart, and a few lines.
class Hash {
  public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) {
            state_ ^= static_cast<std::uint64_t>(b);
            state_ *= 0x100000001B3u;
        }
    }
    void add(std::uint64_t number) {
        for (int i = 0; i < 8; ++i) {
            const std::byte byte{static_cast<unsigned char>(number >> (8 * i))};
            add({&byte, 1});
        }
    }
    void add(std::string_view text) {
        add(text.size());
        add(std::as_bytes(std::span(text.data(), text.size())));
    }
    void add(const std::vector<Index>& list) {
        add(list.size());
        for (const Index i : list) add(i);
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xCBF29CE484222325u;
};

void add(Hash& hash, const Array& array) {
    hash.add(static_cast<std::uint64_t>(array.scalar));
    hash.add(array.arity);
    hash.add(array.bytes.size());
    hash.add(array.bytes);
}

std::uint64_t hash_of(const Decoded& decoded) {
    Hash hash;
    const Mesh& mesh = decoded.mesh;
    hash.add(static_cast<std::uint64_t>(mesh.kind));
    add(hash, mesh.positions);
    hash.add(mesh.corner_begin);
    hash.add(mesh.corners);
    for (const CompanionBlock& block : mesh.companions) {
        hash.add(block.vtk_type);
        hash.add(block.nodes_per_cell);
        hash.add(block.cell_count);
        hash.add(block.nodes);
        hash.add(block.hosts);
    }
    for (const Attribute& attribute : mesh.attributes) {
        hash.add(attribute.name);
        hash.add(static_cast<std::uint64_t>(attribute.place));
        add(hash, attribute.values);
        hash.add(attribute.index);
    }
    for (const TagName& name : mesh.tag_names) hash.add(name.name);
    for (const Note& note : mesh.notes) hash.add(note.text);
    for (const StripStep& step : decoded.steps) {
        hash.add(step.cell);
        hash.add(step.from);
        hash.add(step.exit);
        hash.add(step.entry);
        hash.add(std::uint64_t{step.link});
    }
    return hash.value();
}

struct Row {
    const char* name;
    EncodeOptions options;
};

std::vector<Row> option_rows() {
    std::vector<Row> rows{{"exact", {}},
                          {"bits=14", {}},
                          {"error=0.001,order", {}},
                          {"float32,budget=0", {}},
                          {"bits=9", {}}};
    rows[1].options.position_bits = 14;
    rows[2].options.max_error = 0.001;
    rows[2].options.keep_order = true;
    rows[3].options.float32 = true;
    rows[3].options.strip_budget = 0;
    rows[4].options.position_bits = 9;
    for (Row& row : rows) row.options.level = 3;
    return rows;
}

// Every class of mesh: kinds, borders, genus, soups, scalars, companions, attributes; and two large
// enough for what only shows in crowds.
constexpr const char* kRecipes[] = {"tiny:empty",
                                    "tiny:degrees-0-1-2",
                                    "tiny:pinch",
                                    "tiny:bow-tie",
                                    "tiny:flat-tet",
                                    "tiny:tets-on-one-face",
                                    "grid:size=20x15",
                                    "torus:quads=1500,bumps=0.3,seed=4",
                                    "sphere:subdivide=3,bumps=0.2,double",
                                    "moebius:size=60x4",
                                    "terrain:size=30x30,holes=3,double",
                                    "polygons:hex,size=20x20",
                                    "polygons:mixed,size=20x20,attributes",
                                    "torus:quads=600,copies=3",
                                    "torus:quads=1000,shuffle",
                                    "tets:box=6",
                                    "tets:box=8,jitter=0.2,seed=7",
                                    "tets:box=5x5x5,five,double",
                                    "tets:ball=6,jitter=0.2,seed=2",
                                    "tets:shell=6,double",
                                    "tets:box=10x4x4,round,bend=120,slide=0.5,double",
                                    "tets:box=4,shuffle,attributes,companions",
                                    "soup:polygons=300,seed=3,attributes",
                                    "soup:tets=300,seed=3,attributes,companions",
                                    "torus:quads=20000,bumps=0.2,seed=1",
                                    "tets:box=14,jitter=0.3,seed=5"};

// Points of edges, which are guessed and rounded in their own way.
constexpr const char* kQuadratic[] = {"tets:ball=5,jitter=0.2,seed=2", "tets:box=5,shuffle"};

// Attributes within a bound, and directions of length 1.
constexpr const char* kBounded[] = {"polygons:mixed,size=20x20,attributes",
                                    "tets:box=4,shuffle,attributes,companions"};

void add_directions(Mesh& mesh) {
    Attribute& a = mesh.attributes.emplace_back();
    a.name = "direction";
    a.place = Place::point;
    a.values = make_array(Scalar::f32, 3, mesh.point_count());
    for (Index p = 0; p < mesh.point_count(); ++p) {
        const double x = static_cast<double>(p % 31) - 15, y = static_cast<double>(p % 17) - 8;
        const double length = std::sqrt(x * x + y * y + 9);
        a.values.as<float>()[3 * p] = static_cast<float>(x / length);
        a.values.as<float>()[3 * p + 1] = static_cast<float>(y / length);
        a.values.as<float>()[3 * p + 2] = static_cast<float>(-3 / length);
    }
}

std::vector<Row> bounded_rows() {
    std::vector<Row> rows = option_rows();
    rows.resize(3);
    AttributeOptions bits, error, octahedral;
    bits.name = "temperature", bits.bits = 12;
    error.name = "velocity", error.max_error = 0.01;
    octahedral.name = "direction", octahedral.octahedral = 10;
    for (Row& row : rows) row.options.attributes = {bits, error, octahedral};
    return rows;
}

int print_row(const std::string& name, const Mesh& mesh, const Row& row, bool files) {
    const auto packed = encode(mesh, row.options);
    if (!packed) {  // a refusal is the same everywhere too
        std::printf("%s | %s | %s\n", name.c_str(), row.name, name_of(packed.error().code));
        return 0;
    }
    const auto parts = test::take_apart(packed->bytes);
    const auto decoded = decode(packed->bytes);
    if (!parts || !decoded) {
        std::fprintf(stderr, "%s %s: does not come back\n", name.c_str(), row.name);
        return 1;
    }
    Hash sections, file;
    for (const test::FilePart& part : *parts) {
        sections.add(static_cast<std::uint64_t>(part.id));
        sections.add(part.raw.size());
        sections.add(part.raw);
    }
    file.add(packed->bytes);
    std::printf("%s | %s | %016llx | %016llx", name.c_str(), row.name,
                static_cast<unsigned long long>(sections.value()),
                static_cast<unsigned long long>(hash_of(*decoded)));
    if (files) std::printf(" | %016llx", static_cast<unsigned long long>(file.value()));
    std::printf("\n");
    return 0;
}

// `change` makes of the recipe's mesh what is packed, and is told by `suffix`.
template <class Change>
int print_rows(std::span<const char* const> recipes, const char* suffix,
               const std::vector<Row>& rows, bool files, const Change& change) {
    for (const char* recipe : recipes) {
        auto mesh = make::make_mesh(recipe);
        if (!mesh) {
            std::fprintf(stderr, "%s: %s\n", recipe, mesh.error().detail.c_str());
            return 1;
        }
        change(*mesh);
        for (const Row& row : rows)
            if (print_row(std::string(recipe) + suffix, *mesh, row, files) != 0) return 1;
    }
    return 0;
}

}  // namespace

int main(int count, char** words) {
    const bool files = count == 2 && std::string_view(words[1]) == "--files";
    std::printf("# recipe | options | sections before zstd | decoded mesh; zstd %s, level 3\n",
                ZSTD_versionString());
    const int failed = print_rows(kRecipes, "", option_rows(), files, [](Mesh&) {}) +
                       print_rows(kQuadratic, ", quadratic", option_rows(), files,
                                  [](Mesh& mesh) { mesh = test::with_edge_nodes(mesh, 5); }) +
                       print_rows(kBounded, ", bounded", bounded_rows(), files, add_directions);
    return failed == 0 ? 0 : 1;
}
