// The walk over polygons. [DiazGopi2005] gives the strip; the front and its zips are in the manner
// of cut-border coders, with corner counts as contexts.
//
// The front is the facets of visited cells whose other side is not visited, and the borders met so
// far, in closed loops. Seen from outside, front facet f runs from the end of side f to its start;
// next(f) starts where f ends. Two neighbours in a loop bound one gap: unvisited cells around their
// vertex. A new cell enters one gap at each of its old corners and splits it; a side that meets the
// front zips with it and vanishes. Constant time per corner but for bounded steps along the front.
//
// Truths of the driver (about the cell being entered; side and corner numbers count from its
// entry):
//     Id degree()
//     bool zips(Id side)                is the cell across already visited?
//     bool is_new(Id corner)
//     bool border(Id side)              is there no cell across?
//     Id gap(Id corner, bool& arrives)  a front facet of the corner's gap: that leaves it, or
//                                       arrives at it
#pragma once

#include "walk/angle.h"
#include "walk/surface_stencil.h"
#include "walk/walk.h"

namespace ravel {

template <class Driver>
class SurfaceWalk {
  public:
    SurfaceWalk(Driver& driver, const WalkLimits& limits) : driver_(driver), limits_(limits) {
        walked_.kind = CellKind::polygon;
        walked_.fours = limits.uniform_degree == 4;
        reserve(walked_, limits);
        const std::size_t corners = std::min<std::size_t>(limits.corners, limits.plausible);
        next_.reserve(corners);
        prev_.reserve(corners);
        state_.reserve(corners);
    }

    // False: the answers contradict each other or the limits (only a decoder can see this).
    bool run() {
        while (walked_.cell_count() < limits_.cells) {
            if (!visit(kNone) || !wind_component()) return false;
        }
        grow(corner_count_);
        return corner_count_ == limits_.corners && walked_.vertex_count == limits_.vertices;
    }

    const Walked& walked() const { return walked_; }
    Walked take() { return std::move(walked_); }

  private:
    enum State : std::uint8_t { open, border, gone };
    static constexpr std::size_t kAhead = 1024;  // corners

    Id start_of(Id front) const { return walked_.vertex[walked_.next_in_cell(front)]; }
    Id end_of(Id front) const { return walked_.vertex[front]; }
    static std::uint32_t degree_class(Id degree) { return degree == 4 ? 0 : degree == 3 ? 1 : 2; }
    std::uint32_t seen(Id vertex) const { return corners_[vertex]; }

    bool wind_component() {
        return wind(
            walked_, [&](Id cell) { return choose_exit(cell); },
            [&](Id out) { return visit(out); });
    }

    // Rightmost first, so that the walk hugs what it has visited.
    Id choose_exit(Id cell) const {
        for (Id f = walked_.begin(cell); f < walked_.end(cell); ++f)
            if (state_[f] == open) return f;
        return kNone;
    }

    Id code_degree(Id gate) {
        if (limits_.uniform_degree != 0) return limits_.uniform_degree;
        const Id truth = driver_.degree();
        const std::uint32_t across =
            gate == kNone ? 0 : coarse(walked_.degree(walked_.cell_of(gate)));
        const std::uint32_t angles = gate == kNone ? 25 : gate_angles(gate);
        static constexpr Id kUsual[6] = {4, 3, 5, 6, 7, 8};
        for (std::uint32_t i = 0; i < 6; ++i)
            if (driver_.flag(surface::kDegree.at(across, angles, i), truth == kUsual[i]))
                return kUsual[i];
        const std::uint64_t rest =
            driver_.number(surface::kDegreeRest.base, truth <= 2 ? truth : truth - 6);
        if (rest <= 2) return static_cast<Id>(rest);
        return rest < limits_.corners ? static_cast<Id>(rest) + 6
                                      : kNone;  // more than there can be
    }
    static std::uint32_t coarse(Id degree) {
        return degree == 4 ? 0 : degree == 3 ? 1 : degree == 5 ? 2 : 3;
    }

    // How open the front is at both ends of the gate.
    std::uint32_t gate_angles(Id gate) const {
        const Id after = next_[gate], before = prev_[gate];
        const auto coarse_angle = [](std::uint32_t c) {
            return c <= 2 ? c == 0 ? 3u : 0u : c == 3 ? 1u : c == 4 ? 2u : 3u;
        };
        const std::uint32_t a =
            state_[after] == open ? coarse_angle(angle(end_of(gate), start_of(gate), end_of(after)))
                                  : 4;
        const std::uint32_t b =
            state_[before] == open
                ? coarse_angle(angle(start_of(gate), end_of(gate), start_of(before)))
                : 4;
        return 5 * a + b;
    }
    std::uint32_t angle(Id vertex, Id from, Id to) const {
        return angle_class(driver_.place(vertex), driver_.place(from), driver_.place(to));
    }

    bool visit(Id gate) {
        if (walked_.cell_count() >= limits_.cells) return false;
        driver_.begin_cell(gate);
        const Id degree = code_degree(gate);
        const Id base = corner_count_;
        if (degree > limits_.corners - base || (gate != kNone && degree < 2)) return false;
        const Id cell = walked_.cell_count();
        walked_.gate.push_back(gate);
        corner_count_ = base + degree;
        if (corner_count_ > state_.size())
            grow(std::min<std::size_t>(std::size_t{corner_count_} + kAhead, limits_.corners));
        if (!walked_.fours) {
            walked_.first.push_back(corner_count_);
            for (Id f = base; f < corner_count_; ++f) walked_.of[f] = cell;
        }
        const bool placed = gate == kNone ? place_seed(base, degree) : place(base, degree, gate);
        if (!placed || driver_.failed()) return false;
        for (Id f = base; f < base + degree; ++f) {
            const Id v = walked_.vertex[f];
            if (corners_[v] < 255) ++corners_[v];
            if (state_[f] == border)
                on_border_[v] = on_border_[walked_.vertex[walked_.next_in_cell(f)]] = 1;
        }
        driver_.end_cell(cell);
        return true;
    }

    // Makes room for so many corners; the last room is given back by `run`.
    void grow(std::size_t corners) {
        if (!walked_.fours) walked_.of.resize(corners, kNone);
        walked_.vertex.resize(corners, kNone);
        walked_.twin.resize(corners, kNone);
        next_.resize(corners, kNone);
        prev_.resize(corners, kNone);
        state_.resize(corners, gone);
    }

    bool add_vertex(Id corner, const Stencil& stencil) {
        if (walked_.vertex_count >= limits_.vertices) return false;
        const Id v = walked_.vertex_count++;
        walked_.vertex[corner] = v;
        corners_.push_back(0);
        on_border_.push_back(0);
        driver_.new_vertex(v, corner - walked_.begin(walked_.cell_count() - 1), stencil);
        return true;
    }

    bool place_seed(Id base, Id degree) {
        for (Id i = 0; i < degree; ++i) {
            Stencil stencil;
            const Id known = walked_.vertex_count;
            if (degree == 4 && i == 3)
                stencil = stencil_of(Configuration::quad_fourth, {known - 3, known - 1, known - 2});
            else if (i >= 1)
                stencil = stencil_of(Configuration::seed, {known - 1, i >= 2 ? known - 2 : kNone,
                                                           i >= 3 ? known - 3 : kNone});
            else if (known > 0)
                stencil.at[0] = known - 1;
            stencil.variant = static_cast<std::uint8_t>(std::min<Id>(i, 2));
            if (!add_vertex(base + i, stencil)) return false;
        }
        near_border_start_ = near_border_end_ = false;
        for (Id i = 0; i < degree; ++i) {
            make_front(base + i, i == 0 ? kNone : base + i - 1, true, true);
            const Id before = base + (i == 0 ? degree - 1 : i - 1);
            join(base + i, before);  // seen from outside the loop runs backwards
        }
        return true;
    }

    // Side `f` becomes part of the front: open, or a border for good.
    void make_front(Id f, Id side_before, bool start_new, bool end_new) {
        bool is_border = true;
        const Id s = walked_.vertex[f], e = walked_.vertex[walked_.next_in_cell(f)];
        if (s == e) {
            // A side that ends where it starts is glued to nothing.
        } else if (!limits_.has_border) {
            is_border = false;
        } else {
            const bool before = side_before != kNone && state_[side_before] == border;
            is_border =
                driver_.flag(surface::kBorder.at(before || near_border_start_, near_border_end_,
                                                 start_new ? 0 : 1 + on_border_[s],
                                                 end_new ? 0 : 1 + on_border_[e]),
                             driver_.border(f - walked_.begin(walked_.cell_count() - 1)));
        }
        state_[f] = is_border ? border : open;
    }

    void join(Id before, Id after) {
        next_[before] = after;
        prev_[after] = before;
    }
    void zip(Id side, Id front) {
        walked_.twin[side] = front;
        walked_.twin[front] = side;
        state_[front] = gone;
    }

    bool place(Id base, Id n, Id gate) {
        auto& vertex = walked_.vertex;
        const std::uint32_t dc = degree_class(n);
        vertex[base] = start_of(gate);
        vertex[base + 1] = end_of(gate);
        Id after = next_[gate],
           before = prev_[gate];  // of the gaps at both ends of the zipped chain
        zip(base, gate);

        // Zips to the right, as far as they go; sides 1 .. right_end - 1.
        Id right_end = 1;
        while (right_end < n && state_[after] == open) {
            const bool closes = next_[after] == gate;
            if (closes != (right_end + 1 == n)) break;
            const Id v = vertex[base + right_end];
            const std::uint32_t opening = angle(v, vertex[base + right_end - 1], end_of(after));
            if (!driver_.flag(surface::kZipRight.at(dc, seen(v) - 1, opening, right_end == 1),
                              driver_.zips(right_end)))
                break;
            zip(base + right_end, after);
            ++right_end;
            if (right_end < n) vertex[base + right_end] = end_of(after);
            after = next_[after];
        }
        if (right_end == n) return true;

        // Zips to the left; sides left_end .. n - 1. Side right_end does not zip.
        Id left_end = n;
        while (left_end > right_end + 1 && state_[before] == open) {
            const Id v = vertex[left_end == n ? base : base + left_end];
            const Id next = vertex[left_end == n       ? base + 1
                                   : left_end + 1 == n ? base
                                                       : base + left_end + 1];
            const std::uint32_t opening = angle(v, next, start_of(before));
            if (!driver_.flag(surface::kZipLeft.at(dc, seen(v) - 1, opening, left_end == n),
                              driver_.zips(left_end - 1)))
                break;
            --left_end;
            zip(base + left_end, before);
            vertex[base + left_end] = start_of(before);
            before = prev_[before];
        }
        return place_middle(base, n, right_end, left_end, after, before);
    }

    // The corners between both zipped chains and the sides right_end .. left_end - 1.
    bool place_middle(Id base, Id n, Id right_end, Id left_end, Id after, Id before) {
        const auto& vertex = walked_.vertex;
        const std::uint32_t dc = degree_class(n);
        const bool border_after = state_[after] == border, border_before = state_[before] == border;
        const Id middle = left_end - right_end - 1, side = base + right_end;
        near_border_start_ = border_after;
        near_border_end_ = border_before;
        if (middle == 0) {
            make_front(side, kNone, false, false);
            join(side, after);
            join(before, side);
            return true;
        }
        const auto code_new = [&](Id i) {
            return driver_.flag(
                surface::kNew.at(dc, right_end - 1, n - left_end, border_after + border_before),
                driver_.is_new(i));
        };
        const bool first_is_new = code_new(right_end + 1);
        if (middle > 1 || !first_is_new)
            return place_corners(base, n, right_end, left_end, after, before, first_is_new,
                                 code_new);
        // One new corner between two new sides: by far the most frequent case.
        if (!add_vertex(side + 1, n == 3 ? triangle_stencil(walked_, base, before, after,
                                                            seen(vertex[base]), seen(vertex[side]))
                                         : surface_stencil(walked_, base, n, side + 1 - base,
                                                           right_end, left_end)))
            return false;
        near_border_end_ = false;
        make_front(side, kNone, false, true);
        near_border_start_ = false;
        near_border_end_ = border_before;
        make_front(side + 1, side, true, false);
        join(side, after);
        join(side + 1, side);
        join(before, side + 1);
        return true;
    }

    // The same, whatever the corners are.
    template <class CodeNew>
    bool place_corners(Id base, Id n, Id right_end, Id left_end, Id after, Id before,
                       bool first_is_new, const CodeNew& code_new) {
        auto& vertex = walked_.vertex;
        const std::uint32_t dc = degree_class(n);
        const bool border_after = near_border_start_, border_before = near_border_end_;
        gaps_.assign(n, kNone);  // the front facet that leaves the gap of an old corner
        fresh_.assign(n + std::size_t{1}, 0);
        zipped_.assign(n, 0);
        gaps_[right_end] = after;
        for (Id i = right_end + 1; i < left_end; ++i) {
            const Id c = base + i;
            const Id gap = gaps_[i - 1];
            // A side that leaves an old corner may run along the front.
            if (i - 1 > right_end && gap != kNone && state_[gap] == open &&
                driver_.flag(surface::kZipMiddle.at(dc, seen(vertex[c - 1]) - 1),
                             driver_.zips(i - 1))) {
                zip(c - 1, gap);
                zipped_[i - 1] = 1;
                vertex[c] = end_of(gap);
                gaps_[i] = next_[gap];
                continue;
            }
            if (i == right_end + 1 ? first_is_new : code_new(i)) {
                fresh_[i] = 1;
                if (!add_vertex(c, surface_stencil(walked_, base, n, i, right_end, left_end)))
                    return false;
                continue;
            }
            const Id front = code_old(after, before, i);
            if (front == kNone) return false;
            gaps_[i] = front;
            vertex[c] = start_of(front);
        }
        const Id arrives = before;  // ends at the gap of corner left_end
        for (Id i = right_end; i < left_end; ++i) {
            if (zipped_[i]) continue;
            near_border_start_ = i == right_end && border_after;
            near_border_end_ = i + 1 == left_end && border_before;
            make_front(base + i, i == right_end || zipped_[i - 1] ? kNone : base + i - 1, fresh_[i],
                       i + 1 < left_end && fresh_[i + 1]);
        }

        // Each corner hands its gap over to the sides beside it. The links of zipped facets are
        // read before any is changed.
        arrive_.assign(n, kNone);
        for (Id i = right_end + 1; i < left_end; ++i)
            if (!fresh_[i]) arrive_[i] = zipped_[i - 1] ? kNone : prev_[gaps_[i]];
        for (Id i = right_end; i < left_end; ++i) {
            const bool out_open = !zipped_[i];
            if (i > right_end) {
                if (fresh_[i]) {
                    join(base + i, base + i - 1);
                    continue;
                }
                if (!zipped_[i - 1]) join(arrive_[i], base + i - 1);
            }
            if (out_open) join(base + i, gaps_[i]);
        }
        join(arrives, base + left_end - 1);
        return true;
    }

    // An old vertex, named by the front facet that leaves its gap: by steps along the front from
    // either end of the zipped chain where that is near, otherwise by the age of the facet.
    Id code_old(Id after, Id before, Id corner) {
        constexpr Id kNear = 64;
        bool arrives = false;
        Id truth = driver_.gap(corner, arrives);
        if (arrives) truth = next_[truth];
        Id steps = kNone;
        bool backward = false;
        if (truth != kNone) {
            Id forth = next_[after], back = before;
            for (Id d = 0; d < kNear && steps == kNone; ++d) {
                if (forth == truth)
                    steps = d;
                else if (back == truth)
                    steps = d, backward = true;
                forth = next_[forth];
                back = prev_[back];
            }
        }
        Id front = kNone;
        if (driver_.flag(surface::kOldNear.at(0), steps != kNone)) {
            backward = driver_.flag(surface::kOldSide.at(0), backward);
            const std::uint64_t d = driver_.number(surface::kOldSteps.base, steps);
            if (d >= kNear) return kNone;
            front = backward ? before : next_[after];
            for (std::uint64_t i = 0; i < d; ++i) front = backward ? prev_[front] : next_[front];
        } else {
            const std::uint64_t newest = walked_.begin(walked_.cell_count() - 1);
            const std::uint64_t age = driver_.number(surface::kOldFar.base, newest - 1 - truth);
            if (age >= newest) return kNone;
            front = static_cast<Id>(newest - 1 - age);
        }
        // Facets that are no longer on the front bound no gap.
        if (state_[front] == gone || state_[prev_[front]] == gone) return kNone;
        return front;
    }

    Driver& driver_;
    const WalkLimits limits_;
    Walked walked_;
    Id corner_count_ = 0;
    std::vector<Id> next_, prev_;          // along the front, per facet
    std::vector<std::uint8_t> state_;      // per facet
    std::vector<std::uint8_t> corners_;    // per vertex: visited corners, at most 255
    std::vector<std::uint8_t> on_border_;  // per vertex
    std::vector<Id> gaps_, arrive_;
    std::vector<std::uint8_t> fresh_, zipped_;
    bool near_border_start_ = false, near_border_end_ = false;
};

}  // namespace ravel
