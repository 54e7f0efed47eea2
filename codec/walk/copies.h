// Vertices at the points of earlier ones: the walk meets such a point once for every sheet of a
// non-manifold mesh. Most copies lie side by side as what they copy does. So what the neighbours of
// a new vertex were beside before is asked for first, the nearest to the guess before the others,
// then the cell's own points, which degenerate cells repeat; only else it is told by number.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "mesh/complex.h"
#include "mesh/point3.h"
#include "mesh/stencil.h"
#include "mesh/ties.h"
#include "walk/contexts.h"

namespace ravel {

class Copies {
  public:
    // `vertices`: about how many there will be; 0 where none is a copy.
    Copies(CellKind kind, std::size_t vertices)
        : copy_(kind == CellKind::tet ? tet::kCopy : surface::kCopy),
          near_(kind == CellKind::tet ? tet::kCopyNear : surface::kCopyNear),
          number_(kind == CellKind::tet ? tet::kCopyOf.base : surface::kCopyOf.base) {
        of_.reserve(vertices);
        ties_.reserve(vertices);
    }

    // What the new vertex v copies: the first one at its point, or kNone if it is that itself. v if
    // the codes make no sense. `driver` codes flags and numbers and knows places, as the walk's do.
    template <class Driver>
    Id next(Driver& driver, Id v, const Stencil& stencil, Id truth) {
        const std::array<Id, 2> beside = neighbours_of(stencil);
        was_copy_ = driver.flag(copy_.at(was_copy_, around(beside)), truth != kNone);
        Id of = kNone;
        if (was_copy_) {
            of = code_source(driver, stencil, beside, truth);
            if (of >= v || of_[of] != kNone) of = v;
            last_ = of;
        }
        of_.push_back(of == v ? kNone : of);
        ties_.add_vertex();
        for (const Id n : beside)
            if (n != kNone) ties_.tie(origin_of(n), origin_of(v));
        return of;
    }

    // Per vertex the earlier one at the same point, or kNone.
    const std::vector<Id>& of() const { return of_; }

  private:
    static constexpr std::size_t kMostLooks = 12, kMostNear = 8;
    static_assert(kMostNear + 3 <= 2 * kMostLooks);
    struct Candidate {
        Id vertex = kNone;
        double distance = 0;  // squared
    };
    Id origin_of(Id v) const { return of_[v] == kNone ? v : of_[v]; }
    std::uint32_t is_copy(Id v) const { return of_[v] != kNone; }
    std::uint32_t around(const std::array<Id, 2>& beside) const {
        if (beside[0] == kNone) return 0;
        if (beside[1] == kNone) return 1 + is_copy(beside[0]);
        return 3 + is_copy(beside[0]) + is_copy(beside[1]);
    }
    template <class Driver>
    Id code_source(Driver& driver, const Stencil& stencil, const std::array<Id, 2>& beside,
                   Id truth) {
        double scale = 0;
        find(driver, stencil, beside, scale);
        for (std::size_t i = 0; i < count_; ++i) {
            const double d = found_[i].distance;
            const std::uint32_t far = d * 256 <= scale ? 0 : d * 16 <= scale ? 1 : 2;
            if (driver.flag(near_.at(static_cast<std::uint32_t>(i), far, i + 1 == count_),
                            found_[i].vertex == truth))
                return found_[i].vertex;
        }
        const std::uint64_t number =
            driver.number(number_, zigzag(std::int64_t{truth} - std::int64_t{last_}));
        const auto of = last_ + static_cast<std::uint64_t>(unzigzag(number));
        return of < kNone ? static_cast<Id>(of) : kNone - 1;
    }

    // The candidates, likeliest first; `scale`: the square of how far the guess is from the corner
    // before.
    template <class Driver>
    void find(const Driver& driver, const Stencil& stencil, const std::array<Id, 2>& beside,
              double& scale) {
        count_ = 0;
        if (beside[0] == kNone) return;
        const Point3 guess = guess_of(driver, stencil);
        const auto distance = [&](Id v) {
            const Point3 way = minus(driver.place(v), guess);
            return dot(way, way);
        };
        scale = distance(beside[0]);
        const Id p = origin_of(beside[0]), q = beside[1] == kNone ? kNone : origin_of(beside[1]);
        for (const Id n : {p, q}) {
            if (n == kNone) continue;
            ties_.each(n, kMostLooks, [&](Id v) {
                if (v == p || v == q || is_found(v)) return;
                const Candidate c{v, distance(v)};
                std::size_t at = count_++;
                for (; at > 0 && c.distance < found_[at - 1].distance; --at)
                    found_[at] = found_[at - 1];
                found_[at] = c;
            });
        }
        count_ = std::min(count_, kMostNear);
        for (std::size_t i = 0; i < 3; ++i) {
            if (stencil.at[i] == kNone) continue;
            const Id v = origin_of(stencil.at[i]);
            if (!is_found(v)) found_[count_++] = {v, distance(v)};
        }
    }
    bool is_found(Id v) const {
        for (std::size_t i = 0; i < count_; ++i)
            if (found_[i].vertex == v) return true;
        return false;
    }

    // The parallelogram as far as there is one; of tets the middle of the gate.
    template <class Driver>
    static Point3 guess_of(const Driver& driver, const Stencil& stencil) {
        const Configuration c = stencil.configuration;
        const Point3& p = driver.place(stencil.at[0]);
        if (c == Configuration::seed || c == Configuration::polygon || stencil.at[2] == kNone)
            return p;
        const Point3 &q = driver.place(stencil.at[1]), &r = driver.place(stencil.at[2]);
        if (c > Configuration::polygon)
            return {(p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3, (p[2] + q[2] + r[2]) / 3};
        const Point3 way = minus(c == Configuration::quad_third ? p : q, r);
        return {p[0] + way[0], p[1] + way[1], p[2] + way[2]};
    }

    const ContextBlock copy_, near_;
    const Context number_;
    std::vector<Id> of_;  // per vertex
    Ties ties_;           // of vertices that are beside each other
    std::array<Candidate, 2 * kMostLooks> found_{};
    std::size_t count_ = 0;  // of what is found
    Id last_ = 0;            // what was copied last
    bool was_copy_ = false;
};

}  // namespace ravel
