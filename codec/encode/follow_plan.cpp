#include "encode/follow_plan.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "predict/leads.h"

namespace ravel {
namespace {

// About how many bits a vertex takes that is missed by so much: a coordinate that is met costs next
// to nothing.
float bits_of(const Point3& missed) {
    float bits = 0;
    for (const double x : missed) {
        const double size = std::min(0x1p60, std::abs(x) + 0.5);
        bits += size < 1 ? 0.1f
                         : 1 + static_cast<float>(std::bit_width(static_cast<std::uint64_t>(size)));
    }
    return bits;
}

// What a guess missed, told by the first three vertices of its stencil as `carried` tells it: along
// both sides, and across them. Where these span nothing, `across` is 0 and the other as it is.
struct Missed {
    Point3 by{};
    std::array<double, 2> along{};
    double height = 0, across = 0;  // height times across is in multiples of the sides' product
};

// What is known of each vertex: its course, and how far off its own guess is.
struct Walk {
    const WalkRecord& record;
    const std::vector<Point3>& places;
    std::vector<std::uint64_t> course;
    std::vector<Id> end;  // of its part
    std::vector<Missed> missed;
    std::vector<float> bits;  // of what its own guess missed

    // The sides of a vertex's frame.
    std::array<Point3, 2> sides(Id v) const {
        const auto& at = record.stencils[v].at;
        return {minus(places[at[1]], places[at[0]]), minus(places[at[2]], places[at[0]])};
    }
    // How far off v is if u leads it.
    Point3 off(Id u, Id v) const {
        const Missed &its = missed[u], &mine = missed[v];
        if (its.across == 0 || mine.across == 0) return minus(mine.by, its.by);
        const auto [c, d] = sides(v);
        const Point3 m = cross(c, d);
        const double z = its.height * mine.across;
        Point3 out;
        for (std::size_t k = 0; k < 3; ++k)
            out[k] = mine.by[k] - (its.along[0] * c[k] + its.along[1] * d[k] + z * m[k]);
        return out;
    }
    // What the rest of the part of v takes, from v on, if u leads v; or more than `least`.
    float taken(Id u, Id v, float least) const {
        const Id by = v - u;
        float sum = 0;
        bool leads = true;
        for (Id w = v; w < end[v] && sum < least; ++w) {
            if (record.copy_of[w] != kNone) continue;
            leads = leads && course[w - by] == course[w] && can_shift(record.stencils[w], by);
            sum += leads ? std::min(bits[w], bits_of(off(w - by, w))) : bits[w];
        }
        return sum;
    }
    void add(const Point3& by, Id v) {
        Missed out;
        out.by = by;
        const Stencil& stencil = record.stencils[v];
        const bool framed = stencil.configuration != Configuration::seed &&
                            *std::max_element(stencil.at.begin(), stencil.at.begin() + 3) != kNone;
        if (framed) {
            const auto [a, b] = sides(v);
            const Point3 n = cross(a, b);
            const double area = dot(n, n), root = std::sqrt(std::sqrt(area));
            if (area > 0) {
                out.along = {dot(cross(by, b), n) / area, dot(cross(a, by), n) / area};
                out.height = dot(by, n) / area * root;
                out.across = 1 / root;
            }
        }
        missed.push_back(out);
    }
};

Walk walk_of(const WalkRecord& record, const std::vector<Point3>& places,
             const PositionFormat& format) {
    const std::size_t size = record.stencils.size();
    Walk walk{record, places, {}, {}, {}, {}};
    walk.course.assign(size, 0);
    walk.end.assign(size, static_cast<Id>(size));
    Courses courses(size);
    Predictor predictor(format.weights, format.mirrored, format.leaders_move);
    Id begin = 0;
    bool was_seed = true;
    for (Id v = 0; v < size; ++v) {
        const Stencil& stencil = record.stencils[v];
        const Point3 missed = minus(places[v], predictor.guess(stencil, places));
        walk.add(missed, v);
        walk.bits.push_back(bits_of(missed));
        if (record.copy_of[v] != kNone) continue;
        courses.enter(stencil, v);
        walk.course[v] = courses.course();
        if (courses.in_seed() && !was_seed) {
            std::fill(walk.end.begin() + begin, walk.end.begin() + v, v);
            begin = v;
        }
        was_seed = courses.in_seed();
    }
    return walk;
}

}  // namespace

std::vector<std::uint8_t> plan_follows(const WalkRecord& record, const std::vector<Point3>& places,
                                       const PositionFormat& format) {
    constexpr float kPlaceBits = 5;  // of one that is not the first
    const Walk walk = walk_of(record, places, format);
    std::vector<std::uint8_t> leads(record.stencils.size(), 0);
    Courses courses(record.stencils.size());
    for (Id v = 0; v < leads.size(); ++v) {
        const Stencil& stencil = record.stencils[v];
        if (record.copy_of[v] == kNone) {
            courses.enter(stencil, v);
            const bool is_told =
                !courses.in_seed() && !(courses.is_led() && courses.going_on(stencil, v) != kNone);
            if (is_told) {
                LeadList list(courses, stencil, v);
                list.sort(places, list.size());
                float least = 1e30f;
                for (std::size_t i = 0; i < list.size() && list.size() > 1; ++i) {
                    const float price = i == 0 ? 0 : kPlaceBits;
                    const float taken = price + walk.taken(list[i], v, least - price);
                    if (taken < least) least = taken, leads[v] = static_cast<std::uint8_t>(i);
                }
                if (list.size() > 0) courses.lead(list[leads[v]], v);
            }
        }
        courses.insert(v);
    }
    return leads;
}

}  // namespace ravel
