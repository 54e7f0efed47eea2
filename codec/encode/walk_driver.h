// The encoder's side of the walk: answers its questions from the complex and the strip, and writes
// the answers down.
#pragma once

#include <bit>
#include <vector>

#include "encode/answers.h"
#include "encode/seeds.h"
#include "entropy/flag_encoder.h"
#include "mesh/complex.h"
#include "mesh/point3.h"
#include "walk/copies.h"
#include "walk/gate_shapes.h"
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
};

// Where the answers go: into flags under models that know the walk's priors.
struct WalkCodes {
    FlagEncoder out;
    std::vector<FlagModel> models;
    Answers* record = nullptr;  // where they are kept besides, if at all

    void begin_cell(bool seed) {
        if (record) record->begin_cell(seed);
    }
    void flag(Context context, bool truth) {
        if (record) record->flag(context, truth);
        out.flag(models[context], truth);
    }
    void plain(std::uint64_t truth, int count) {
        if (record) record->plain(truth, count);
        out.plain(truth, count);
    }
};

// What the walk is to follow: where it starts in each component, and where the points are.
struct WalkPlan {
    std::vector<Seed> seeds;     // one per component
    std::vector<Point3> places;  // per point of the mesh, as the decoder will see it
};

template <class Codes>
class EncodeDriver {
  public:
    EncodeDriver(const Complex& complex, const WalkPlan& plan, Codes& codes, CellKind kind,
                 Context flip, bool has_copies, bool has_flips)
        : complex_(complex),
          plan_(plan),
          codes_(codes),
          copies_(kind, has_copies ? complex.point.size() : 0),
          flip_(flip),
          has_copies_(has_copies),
          has_flips_(has_flips),
          walk_vertex_(complex.point.size(), kNone),
          walk_facet_(complex.twin.size(), kNone) {
        if (has_copies_) first_at_point_.assign(plan.places.size(), kNone);
        record_.facet_of.reserve(complex.twin.size());
        record_.stencils.reserve(complex.point.size());
        record_.vertex_of.reserve(complex.point.size());
        record_.copy_of.reserve(complex.point.size());
        places_.reserve(complex.point.size());
    }

    bool flag(Context context, bool truth) {
        codes_.flag(context, truth);
        return truth;
    }
    std::uint64_t number(Context base, std::uint64_t truth) {
        const auto bits = static_cast<std::uint32_t>(std::bit_width(truth + 1));
        for (std::uint32_t i = 1; i < bits; ++i) flag(base + i - 1, true);
        if (bits < kNumberSteps) flag(base + bits - 1, false);
        codes_.plain(truth + 1, static_cast<int>(bits) - 1);
        return truth;
    }
    bool failed() const { return false; }
    const Point3& place(Id vertex) const { return places_[vertex]; }

    void new_vertex(Id vertex, Id corner, const Stencil& stencil) {
        const Id source = complex_.vertex[corner_at(corner)], point = complex_.point[source];
        walk_vertex_[source] = vertex;
        record_.vertex_of.push_back(source);
        record_.stencils.push_back(stencil);
        const Id of = has_copies_ ? code_copy(vertex, point, stencil) : kNone;
        record_.copy_of.push_back(of);
        places_.push_back(of != kNone ? places_[of] : plan_.places[point]);
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

    WalkRecord take() { return std::move(record_); }

  protected:
    Id corner_at(Id local) const { return corners_[local]; }
    bool visited(Id facet) const { return facet != kNone && walk_facet_[facet] != kNone; }
    const Seed& next_seed() { return plan_.seeds[next_seed_++]; }

    const Complex& complex_;
    const WalkPlan& plan_;
    Codes& codes_;
    Copies copies_;
    const Context flip_;
    const bool has_copies_, has_flips_;
    std::vector<Id> walk_vertex_;     // complex vertex -> walk vertex
    std::vector<Id> walk_facet_;      // complex facet -> walk facet
    std::vector<Id> first_at_point_;  // point -> first walk vertex there
    std::vector<Id> corners_;         // of the cell being entered, in the walk's order
    Id cell_ = 0;                     // being entered, of the complex
    std::vector<Point3> places_;      // per vertex of the walk
    WalkRecord record_;

  private:
    // The earlier vertex at the same point, or kNone.
    Id code_copy(Id vertex, Id point, const Stencil& stencil) {
        Id& first = first_at_point_[point];
        copies_.next(*this, vertex, stencil, first);
        if (first != kNone) return first;
        first = vertex;
        return kNone;
    }

    std::size_t next_seed_ = 0;
    bool last_flip_ = false;
};

template <class Codes>
class SurfaceEncodeDriver : public EncodeDriver<Codes> {
    using Base = EncodeDriver<Codes>;
    using Base::cell_, Base::complex_, Base::corners_, Base::record_, Base::visited,
        Base::walk_facet_, Base::walk_vertex_;

  public:
    SurfaceEncodeDriver(const Complex& complex, const WalkPlan& plan, Codes& codes, bool copies,
                        bool flips)
        : Base(complex, plan, codes, CellKind::polygon, surface::kFlip.base, copies, flips) {}

    void begin_cell(Id gate) {
        this->codes_.begin_cell(gate == kNone);
        Seed start;
        if (gate == kNone) {
            start = this->next_seed();
        } else {
            start.facet = complex_.twin[record_.facet_of[gate]];
            start.cell = complex_.cell_of[start.facet];
        }
        cell_ = start.cell;
        corners_.clear();
        Id f = start.facet;
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

template <class Codes>
class TetEncodeDriver : public EncodeDriver<Codes> {
    using Base = EncodeDriver<Codes>;
    using Base::cell_, Base::complex_, Base::corners_, Base::plan_, Base::record_, Base::visited,
        Base::walk_vertex_;

  public:
    TetEncodeDriver(const Complex& complex, const WalkPlan& plan, Codes& codes, bool copies,
                    bool flips)
        : Base(complex, plan, codes, CellKind::tet, tet::kFlip.base, copies, flips) {}

    void begin_cell(Id gate) {
        if (gate == kNone) {
            const Seed& seed = this->next_seed();
            const Id base = 4 * seed.cell;
            const auto& triple = kOutward[seed.facet & 3];
            cell_ = seed.cell;
            corners_ = {base + triple[0], base + triple[2], base + triple[1], seed.facet};
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
    bool is_new_near(const Point3& there, double reach) const {
        return apex() == kNone &&
               lies_near(plan_.places[complex_.point[complex_.vertex[corners_[3]]]], there, reach);
    }
    bool glues(Id facet) const { return visited(complex_.twin[corners_[facet & 3]]); }
    bool meets(Id facet) const { return glues(facet); }
    bool border(Id facet) const { return complex_.twin[corners_[facet & 3]] == kNone; }
};

}  // namespace ravel
