#include "encode/follow_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "predict/leads.h"

namespace ravel {
namespace {

// About how many tenths of a bit a vertex takes that is missed by so much: a coordinate that is met
// costs next to nothing.
std::uint64_t price_of(const Point3& missed) {
    std::uint64_t price = 0;
    for (const double x : missed) {
        const std::uint32_t digits = digits_of(x);
        price += digits == 0 ? 1 : 10 * (1 + digits);
    }
    return price;
}

// What a guess missed, and the same along the two sides of its stencil's first triangle and across
// them, as `carried` has it: `height` of one vertex times `across` of another is in multiples of
// the cross product of the other's sides. 0 where the sides span nothing.
struct Missed {
    Point3 by{};
    std::array<double, 2> along{};
    double height = 0, across = 0;
};

// What is known of each vertex: its course, and how far off its own guess is.
struct Walk {
    const WalkRecord& record;
    const std::vector<Point3>& places;
    std::vector<std::uint64_t> course;
    std::vector<Id> end;  // of its part
    std::vector<Missed> missed;
    std::vector<std::uint64_t> before;  // the prices of all before it by their own guesses

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
    std::uint64_t taken(Id u, Id v, std::uint64_t least) const {
        const Id by = v - u;
        std::uint64_t sum = 0;
        Id w = v;
        for (; w < end[v] && sum < least; ++w) {
            if (record.copy_of[w] != kNone) continue;
            if (course[w - by] != course[w] || !can_shift(record.stencils[w], by)) break;
            sum += std::min(before[w + 1] - before[w], price_of(off(w - by, w)));
        }
        return sum + (before[end[v]] - before[w]);  // from where on u leads no more
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
    Walk walk{record, places, {}, {}, {}, {0}};
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
        const bool coded = record.copy_of[v] == kNone;
        walk.before.push_back(walk.before.back() + (coded ? price_of(missed) : 0));
        if (!coded) continue;
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
    constexpr std::uint64_t kPlacePrice = 50;  // of one that is not the first
    const Walk walk = walk_of(record, places, format);
    std::vector<std::uint8_t> leads(record.stencils.size(), 0);
    Courses courses(record.stencils.size());
    for (Id v = 0; v < leads.size(); ++v) {
        const Stencil& stencil = record.stencils[v];
        if (record.copy_of[v] == kNone) {
            courses.enter(stencil, v);
            if (!courses.in_seed() && courses.led_by(stencil, v) == kNone) {
                LeadList list(courses, stencil, v);
                list.sort(places, list.size());
                std::uint64_t least = ~std::uint64_t{0};
                for (std::size_t i = 0; i < list.size() && list.size() > 1; ++i) {
                    const std::uint64_t price = i == 0 ? 0 : kPlacePrice;
                    if (price >= least) break;
                    const std::uint64_t taken = price + walk.taken(list[i], v, least - price);
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
