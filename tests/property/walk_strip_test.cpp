// The strip that is read from a walk: certificate, and no reading has fewer links.
#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>

#include "decode/decoder.h"
#include "make/make_mesh.h"
#include "ravel/ravel.h"
#include "support/small_meshes.h"
#include "walk/read_strip.h"

using namespace ravel;

namespace {

Result<DecodedWalk> walk_of(const Mesh& mesh) {
    EncodeOptions options;
    options.level = 1;
    const auto packed = encode(mesh, options);
    REQUIRE(packed.ok());
    auto walk = decode_walk(packed->bytes, {});
    REQUIRE(walk.ok());
    REQUIRE(packed->strip.links == read_strip(walk->walked).links);
    return walk;
}

Id parent(const Walked& walked, Id c) {
    return walked.gate[c] == kNone ? kNone : walked.cell_of(walked.gate[c]);
}

// Is there a facet between the cells that is no step of the walk?
bool touch_beside_the_walk(const Walked& walked, Id a, Id b) {
    for (Id f = walked.begin(a); f < walked.end(a); ++f) {
        const Id g = walked.twin[f];
        if (g == kNone || walked.cell_of(g) != b) continue;
        if (walked.gate[a] != g && walked.gate[b] != f) return true;
    }
    return false;
}

// Empty, or what is wrong with the links as a strip.
std::string trouble(const Walked& walked, const std::vector<std::uint8_t>& link) {
    const Id cells = walked.cell_count();
    std::vector<Id> next(cells, kNone), start(cells, kNone), last(cells, kNone);
    for (Id c = 0; c < cells; ++c) {
        const Id up = parent(walked, c);
        if (up == kNone || link[c]) {
            if (up == kNone && link[c]) return "a component starts with a link";
            start[c] = c;
        } else {
            if (next[up] != kNone) return "a strip that branches";
            next[up] = c;
            start[c] = start[up];
        }
        last[start[c]] = c;
    }
    for (Id c = 0; c < cells; ++c) {
        if (start[c] != c || parent(walked, c) == kNone || last[c] == c) continue;
        if (!touch_beside_the_walk(walked, last[c], c)) return "a linked strip that does not close";
    }
    return {};
}

// Fewest links of any reading, by trying all: each cell goes on to one of its children or to none.
Index fewest_links(const Walked& walked) {
    const Id cells = walked.cell_count();
    std::vector<std::uint8_t> link(cells, 0);
    Index best = cells;
    const std::function<void(Id, std::vector<std::uint8_t>&)> choose =
        [&](Id c, std::vector<std::uint8_t>& taken) {
            if (c == cells) {
                if (!trouble(walked, link).empty()) return;
                best = std::min<Index>(best,
                                       static_cast<Index>(std::count(link.begin(), link.end(), 1)));
                return;
            }
            const Id up = parent(walked, c);
            link[c] = up != kNone;
            choose(c + 1, taken);
            if (up == kNone || taken[up]) return;
            link[c] = 0;
            taken[up] = 1;
            choose(c + 1, taken);
            taken[up] = 0;
        };
    std::vector<std::uint8_t> taken(cells, 0);
    choose(0, taken);
    return best;
}

}  // namespace

TEST_CASE("the strip of a walk takes every cell once, and its linked parts close") {
    for (const auto& [name, mesh, clean] : test::small_meshes()) {
        INFO(name);
        const auto walk = walk_of(mesh);
        const StripReading strip = read_strip(walk->walked);
        CHECK(trouble(walk->walked, strip.link) == "");
        CHECK(static_cast<Index>(std::count(strip.link.begin(), strip.link.end(), 1)) ==
              strip.links);
    }
    for (const char* recipe : {"torus:quads=3000", "tets:box=8x8x8,jitter=0.2", "tets:shell=6",
                               "polygons:mixed,size=30x30", "terrain:size=40x40,holes=5",
                               "soup:polygons=300", "soup:tets=300"}) {
        INFO(recipe);
        const auto mesh = make::make_mesh(recipe);
        REQUIRE(mesh.ok());
        const auto walk = walk_of(*mesh);
        CHECK(trouble(walk->walked, read_strip(walk->walked).link) == "");
    }
}

TEST_CASE("no reading of a walk has fewer links") {
    std::vector<Mesh> meshes{test::quad_grid(4, 4), test::quad_torus(3, 4), test::tet_box(1, 1, 2),
                             test::moebius_band(7), test::triangle_fan(9)};
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        meshes.push_back(test::with_holes(test::quad_grid(5, 4), 30, seed));
        meshes.push_back(test::with_holes(test::tet_box(2, 2, 1), 40, seed));
        meshes.push_back(test::random_soup(CellKind::polygon, 8, 14, seed));
    }
    for (const Mesh& mesh : meshes) {
        const auto walk = walk_of(mesh);
        if (walk->walked.cell_count() > 18) continue;
        CHECK(read_strip(walk->walked).links == fewest_links(walk->walked));
    }
}
