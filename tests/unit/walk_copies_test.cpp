#include <catch2/catch.hpp>

#include <deque>

#include "make/random.h"
#include "walk/copies.h"

using namespace ravel;

namespace {

// What was coded, and where the vertices are.
struct Tape {
    struct Item {
        Context context;
        std::uint64_t value;
    };
    std::deque<Item> items;
    std::vector<Point3> places;
    const Point3& place(Id v) const { return places[v]; }
};
struct Writer : Tape {
    bool flag(Context context, bool truth) {
        items.push_back({context, truth});
        return truth;
    }
    std::uint64_t number(Context base, std::uint64_t truth) {
        items.push_back({base, truth});
        return truth;
    }
};
struct Reader : Tape {
    bool agrees = true;
    bool flag(Context context, bool) { return take(context) != 0; }
    std::uint64_t number(Context base, std::uint64_t) { return take(base); }

  private:
    std::uint64_t take(Context context) {
        if (items.empty() || items.front().context != context) {
            agrees = false;
            return 0;
        }
        const std::uint64_t value = items.front().value;
        items.pop_front();
        return value;
    }
};

struct New {
    Stencil stencil;
    Point3 place{};
    Id source = kNone;
};

// Vertices with random stencils; a third are copies of what is no copy.
std::vector<New> random_vertices(make::Random& random, std::size_t count, bool tets) {
    static constexpr Configuration kPolygon[] = {
        Configuration::seed,        Configuration::quad_third, Configuration::quad_fourth,
        Configuration::quad_corner, Configuration::triangle,   Configuration::polygon};
    std::vector<New> all;
    for (std::size_t v = 0; v < count; ++v) {
        New n;
        n.stencil.configuration = tets ? Configuration::tet : kPolygon[random.below(6)];
        if (v > 0 && !random.one_in(9))
            for (std::size_t i = 0; i < 4; ++i)
                n.stencil.at[i] =
                    static_cast<Id>(v - 1 - random.below(std::min<std::size_t>(v, 9)));
        for (double& x : n.place) x = static_cast<double>(random.below(30));
        if (v > 0 && random.one_in(3)) {
            const Id u = static_cast<Id>(random.below(v));
            n.source = all[u].source == kNone ? u : all[u].source;
            n.place = all[n.source].place;
        }
        all.push_back(n);
    }
    return all;
}

Writer written(const std::vector<New>& all, CellKind kind) {
    Writer out;
    Copies copies(kind, all.size());
    for (Id v = 0; v < all.size(); ++v) {
        CHECK(copies.next(out, v, all[v].stencil, all[v].source) == all[v].source);
        out.places.push_back(all[v].place);
    }
    return out;
}

Stencil third(Id b, Id a, Id beyond) {
    return stencil_of(Configuration::quad_third, {b, a, beyond});
}

}  // namespace

TEST_CASE("copies come back, whatever is copied") {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        make::Random random{seed};
        const CellKind kind = random.one_in(4) ? CellKind::tet : CellKind::polygon;
        const auto all = random_vertices(random, random.below(80), kind == CellKind::tet);
        Reader in;
        in.items = written(all, kind).items;
        Copies copies(kind, all.size());
        INFO("seed " << seed);
        for (Id v = 0; v < all.size(); ++v) {
            CHECK(copies.next(in, v, all[v].stencil, kNone) == all[v].source);
            in.places.push_back(all[v].place);
        }
        CHECK(in.agrees);
        CHECK(in.items.empty());
    }
}

TEST_CASE("a copy beside a copy is the first that is asked for") {
    // 0 and 1 are beside each other, and so are their copies 2 and 3.
    std::vector<New> all(4);
    all[1].stencil = third(0, kNone, kNone);
    all[1].place = {1, 0, 0};
    all[2].source = 0;
    all[3].stencil = third(2, kNone, kNone);
    all[3].source = 1;
    all[3].place = all[1].place;
    const Writer out = written(all, CellKind::polygon);
    REQUIRE(out.items.size() >= 2);
    const Tape::Item &copy = out.items[out.items.size() - 2], &near = out.items.back();
    CHECK(copy.context == surface::kCopy.at(1, 2));
    CHECK(near.context == surface::kCopyNear.at(0, 2, 0));
    CHECK(near.value == 1);
}

TEST_CASE("a source that is no earlier vertex, or a copy itself, is no source") {
    for (const std::uint64_t number : {2u, 4u, 1u, 0xFFFFFFFFu}) {
        Reader in;
        in.items = {{surface::kCopy.at(0, 0), 0},
                    {surface::kCopy.at(0, 0), 1},
                    {surface::kCopyOf.base, 0},
                    {surface::kCopy.at(1, 0), 1},
                    {surface::kCopyOf.base, number}};
        Copies copies(CellKind::polygon, 4);
        in.places.assign(4, Point3{});
        CHECK(copies.next(in, 0, {}, kNone) == kNone);
        CHECK(copies.next(in, 1, {}, kNone) == 0);
        CHECK(copies.next(in, 2, {}, kNone) == 2);
        CHECK(in.agrees);
        // Nothing that follows may look beyond what there is.
        in.items = {{surface::kCopy.at(1, 1), 0}};
        CHECK(copies.next(in, 3, third(2, kNone, kNone), kNone) == kNone);
    }
}
