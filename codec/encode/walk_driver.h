// The encoder's side of the walk: answers its questions from the complex and the strip, and writes
// the answers down.
#pragma once

#include <bit>
#include <vector>

#include "entropy/flag_encoder.h"
#include "mesh/complex.h"
#include "mesh/point3.h"
#include "strip/strip.h"
#include "walk/tet_front.h"
#include "walk/walk.h"

namespace ravel {

// What both drivers record for the sections that follow.
struct WalkRecord {
    std::vector<Id> cell_of;        // cell of the walk -> cell of the complex
    std::vector<Id> facet_of;       // walk facet (corner) -> facet (corner) of the complex
    std::vector<Stencil> stencils;  // per vertex of the walk
    std::vector<Id> vertex_of;      // vertex of the walk -> vertex of the complex
    std::vector<Id> copy_of;        // vertex of the walk -> earlier one at the same point, or kNone
    FlagEncoder codes;
};

class EncodeDriver {
  public:
    EncodeDriver(const Complex& complex, const Strip& strip, Id points, Context contexts,
                 Context copy, Context copy_number, Context flip, bool has_copies, bool has_flips)
        : complex_(complex),
          strip_(strip),
          models_(contexts),
          copy_(copy),
          copy_number_(copy_number),
          flip_(flip),
          has_copies_(has_copies),
          has_flips_(has_flips),
          walk_vertex_(complex.point.size(), kNone),
          walk_facet_(complex.twin.size(), kNone) {
        if (has_copies_) first_at_point_.assign(points, kNone);
        record_.facet_of.reserve(complex.twin.size());
        record_.stencils.reserve(complex.point.size());
        record_.vertex_of.reserve(complex.point.size());
        record_.copy_of.reserve(complex.point.size());
    }

    bool flag(Context context, bool truth) {
        record_.codes.flag(models_[context], truth);
        return truth;
    }
    std::uint64_t number(Context base, std::uint64_t truth) {
        const auto bits = static_cast<std::uint32_t>(std::bit_width(truth + 1));
        for (std::uint32_t i = 1; i < bits; ++i) flag(base + i - 1, true);
        if (bits < kNumberSteps) flag(base + bits - 1, false);
        record_.codes.plain(truth + 1, static_cast<int>(bits) - 1);
        return truth;
    }
    bool failed() const { return false; }

    void new_vertex(Id vertex, Id corner, const Stencil& stencil) {
        const Id source = complex_.vertex[corner_at(corner)];
        walk_vertex_[source] = vertex;
        record_.vertex_of.push_back(source);
        record_.stencils.push_back(stencil);
        record_.copy_of.push_back(kNone);
        if (!has_copies_) return;
        Id& first = first_at_point_[complex_.point[source]];
        const bool is_copy = flag(copy_ + last_was_copy_, first != kNone);
        last_was_copy_ = is_copy;
        if (is_copy) {
            number(copy_number_, zigzag(std::int64_t{first} - last_copied_));
            last_copied_ = record_.copy_of.back() = first;
        } else {
            first = vertex;
        }
    }

    void end_cell(Id) {
        for (const Id f : corners_) {
            walk_facet_[f] = static_cast<Id>(record_.facet_of.size());
            record_.facet_of.push_back(f);
        }
        if (has_flips_) {
            const bool flipped = complex_.flipped[cell_] != 0;
            flag(flip_ + last_flip_, flipped);
            last_flip_ = flipped;
        }
        record_.cell_of.push_back(cell_);
    }

    bool links_through(Id facet) const { return role(facet) == FacetRole::link; }
    bool leaves_through(Id facet) const { return role(facet) == FacetRole::strip; }

    WalkRecord take() { return std::move(record_); }

  protected:
    FacetRole role(Id walk_facet) const { return strip_.role[record_.facet_of[walk_facet]]; }
    Id corner_at(Id local) const { return corners_[local]; }
    bool visited(Id facet) const { return facet != kNone && walk_facet_[facet] != kNone; }

    const Complex& complex_;
    const Strip& strip_;
    std::vector<FlagModel> models_;
    const Context copy_, copy_number_, flip_;
    const bool has_copies_, has_flips_;
    std::vector<Id> walk_vertex_;     // complex vertex -> walk vertex
    std::vector<Id> walk_facet_;      // complex facet -> walk facet
    std::vector<Id> first_at_point_;  // point -> first walk vertex there
    std::vector<Id> corners_;         // of the cell being entered, in the walk's order
    Id cell_ = 0;                     // being entered, of the complex
    WalkRecord record_;
    std::size_t next_root_ = 0;
    Id last_copied_ = 0;
    bool last_was_copy_ = false, last_flip_ = false;
};

class SurfaceEncodeDriver : public EncodeDriver {
  public:
    SurfaceEncodeDriver(const Complex& complex, const Strip& strip, Id points, bool copies,
                        bool flips)
        : EncodeDriver(complex, strip, points, surface::kContexts, surface::kCopy.base,
                       surface::kCopyOf.base, surface::kFlip.base, copies, flips) {}

    void begin_cell(Id gate) {
        Id f = gate == kNone ? complex_.first[strip_.roots[next_root_++]]
                             : complex_.twin[record_.facet_of[gate]];
        cell_ = gate == kNone ? strip_.roots[next_root_ - 1] : complex_.cell_of[f];
        corners_.clear();
        for (Id i = 0; i < complex_.degree(cell_); ++i, f = complex_.next_in_cell(f))
            corners_.push_back(f);
    }
    Id degree() const { return static_cast<Id>(corners_.size()); }
    bool zips(Id side) const { return visited(complex_.twin[corners_[side]]); }
    bool border(Id side) const { return complex_.twin[corners_[side]] == kNone; }
    bool is_new(Id corner) const {
        return walk_vertex_[complex_.vertex[corners_[corner]]] == kNone;
    }

    // Turns about the corner through unvisited cells until it meets the front.
    Id gap(Id corner, bool& arrives) const {
        for (Id f = corners_[corner];;) {
            const Id g = complex_.twin[f];
            if (g == kNone) break;
            if (visited(g)) return walk_facet_[g];
            f = complex_.next_in_cell(g);
        }
        arrives = true;
        for (Id f = complex_.prev_in_cell(corners_[corner]);;) {
            const Id g = complex_.twin[f];
            if (g == kNone) return kNone;
            if (visited(g)) return walk_facet_[g];
            f = complex_.prev_in_cell(g);
        }
    }
};

class TetEncodeDriver : public EncodeDriver {
  public:
    // `places` and `outlier` are per point of the mesh; `outlier` is empty where there are none.
    TetEncodeDriver(const Complex& complex, const Strip& strip, const std::vector<Point3>& places,
                    const std::vector<bool>& outlier, bool copies, bool flips)
        : EncodeDriver(complex, strip, static_cast<Id>(places.size()), tet::kContexts,
                       tet::kCopy.base, tet::kCopyOf.base, tet::kFlip.base, copies, flips),
          point_places_(places),
          outlier_(outlier) {
        places_.reserve(complex.point.size());
    }

    void new_vertex(Id vertex, Id corner, const Stencil& stencil) {
        EncodeDriver::new_vertex(vertex, corner, stencil);
        const Id point = complex_.point[record_.vertex_of.back()];
        // The decoder does not know an outlier's place and lets its first neighbour stand in.
        if (!outlier_.empty() && outlier_[point] && record_.copy_of.back() == kNone)
            places_.push_back(stencil.at[0] != kNone ? places_[stencil.at[0]] : Point3{});
        else if (record_.copy_of.back() != kNone)
            places_.push_back(places_[record_.copy_of.back()]);
        else
            places_.push_back(point_places_[point]);
    }
    const Point3& place(Id vertex) const { return places_[vertex]; }

    void begin_cell(Id gate) {
        if (gate == kNone) {
            cell_ = strip_.roots[next_root_++];
            const Id base = 4 * cell_;
            corners_ = {base, base + 1, base + 2, base + 3};
            return;
        }
        const Id entry = complex_.twin[record_.facet_of[gate]], base = entry & ~Id{3};
        cell_ = entry / 4;
        corners_.assign(4, entry);
        const auto& triple = kOutward[gate & 3];
        for (std::size_t i = 0; i < 3; ++i) {
            const Id v = complex_.vertex[record_.facet_of[(gate & ~Id{3}) + triple[i]]];
            for (Id c = base; c < base + 4; ++c)
                if (complex_.vertex[c] == v) corners_[i] = c;
        }
    }

    bool apex_is(Id vertex) const { return apex() == vertex; }
    Id apex() const { return walk_vertex_[complex_.vertex[corners_[3]]]; }
    bool glues(Id facet) const { return visited(complex_.twin[corners_[facet & 3]]); }
    bool border(Id facet) const { return complex_.twin[corners_[facet & 3]] == kNone; }

  private:
    const std::vector<Point3>& point_places_;
    const std::vector<bool>& outlier_;
    std::vector<Point3> places_;  // per vertex of the walk
};

}  // namespace ravel
