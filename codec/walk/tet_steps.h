// What both walks over tets do alike: they keep the front, its open triangles by their facets and
// the borders, begin cells and components, and glue.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/stencil.h"
#include "walk/tet_front.h"
#include "walk/walk.h"

namespace ravel {

template <class Driver>
class TetSteps {
  public:
    const Walked& walked() const { return walked_; }
    Walked take() { return std::move(walked_); }

  protected:
    TetSteps(Driver& driver, const WalkLimits& limits) : driver_(driver), limits_(limits) {
        walked_.kind = CellKind::tet;
        walked_.fours = true;
        reserve(walked_, limits);
        on_border_.reserve(std::min<std::size_t>(limits.vertices, limits.plausible));
        triangle_of_.reserve(std::min<std::size_t>(limits.corners, limits.plausible));
    }

    // Once all cells are visited.
    bool end() {
        grow(4 * std::size_t{walked_.cell_count()});
        return walked_.vertex_count == limits_.vertices;
    }
    // The next cell, entered through `gate`; `base` becomes its first corner.
    bool begin_cell(Id gate, Id& base) {
        if (walked_.cell_count() >= limits_.cells) return false;
        driver_.begin_cell(gate);
        base = 4 * walked_.cell_count();
        if (base + 4 > limits_.corners) return false;
        walked_.gate.push_back(gate);
        if (base + 4 > triangle_of_.size())
            grow(std::min<std::size_t>(std::size_t{base} + 4 + kAhead, limits_.corners));
        return true;
    }
    bool add_vertex(Id corner, const Stencil& stencil) {
        if (walked_.vertex_count >= limits_.vertices) return false;
        const Id v = walked_.vertex_count++;
        walked_.vertex[corner] = v;
        on_border_.push_back(0);
        driver_.new_vertex(v, corner & 3, stencil);
        return true;
    }
    // The vertices of a seed, and its triangles; false if there are too many.
    bool add_seed(Id base, std::array<Id, 4>& made) {
        for (Id i = 0; i < 4; ++i) {
            Stencil stencil;
            stencil.variant = static_cast<std::uint8_t>(std::min<Id>(i, 2));
            const Id known = walked_.vertex_count;
            for (Id j = 0; j < 3 && j < known; ++j) stencil.at[j] = known - 1 - j;
            if (!add_vertex(base + i, stencil)) return false;
        }
        const auto& v = walked_.vertex;
        made = front_.add_seed({v[base], v[base + 1], v[base + 2], v[base + 3]}, base);
        return true;
    }
    // Of an apex that is a new vertex.
    Stencil stencil_at(const TetFront::Triangle& gate, Id behind) const {
        Stencil stencil = stencil_of(
            Configuration::tet,
            {gate.vertex[0], gate.vertex[1], gate.vertex[2], behind, front_.apex_across(gate, 0),
             front_.apex_across(gate, 1), front_.apex_across(gate, 2)});
        for (Id e = 0; e < 3; ++e)
            stencil.borders |= static_cast<std::uint8_t>(front_.across(gate, e).border << e);
        return stencil;
    }
    // The gate is no open triangle any more, and its facet meets the new cell's.
    void go_through(Id gate, Id base) {
        if (!goes_on_) front_.erase(triangle_of_[gate]);
        goes_on_ = false;
        triangle_of_[gate] = kNone;
        walked_.twin[gate] = base + 3;
        walked_.twin[base + 3] = gate;
    }
    // The walk leaves through a facet, or none. What waits to be found by its vertices: all new
    // triangles but the one to go through.
    Id leave(Id out) {
        for (const Id t : waiting_)
            if (front_[t].facet != out) front_.insert(t);
        goes_on_ = out != kNone && out >= 4 * (walked_.cell_count() - 1);
        waiting_.clear();
        return out;
    }
    // A new triangle meets an open one.
    void glue(Id triangle, Id other) {
        const Id f = front_[triangle].facet, g = front_[other].facet;
        walked_.twin[f] = g;
        walked_.twin[g] = f;
        front_.erase(other);
        triangle_of_[g] = kNone;
        front_.glue(triangle, other);
    }
    void become_border(Id triangle) {
        front_.set_border(triangle);
        for (const Id v : front_[triangle].vertex) on_border_[v] = 1;
    }
    void stay_open(Id triangle) {
        triangle_of_[front_[triangle].facet] = triangle;
        waiting_.push_back(triangle);
    }

    Driver& driver_;
    const WalkLimits limits_;
    Walked walked_;
    TetFront front_;
    std::vector<Id> triangle_of_;          // per facet: its open triangle, or kNone
    std::vector<std::uint8_t> on_border_;  // per vertex

  private:
    static constexpr std::size_t kAhead = 1024;  // corners

    // Makes room for so many corners; the last room is given back at the end.
    void grow(std::size_t corners) {
        walked_.vertex.resize(corners, kNone);
        walked_.twin.resize(corners, kNone);
        triangle_of_.resize(corners, kNone);
    }

    std::vector<Id> waiting_;  // open triangles that are not to be found yet
    bool goes_on_ = false;     // through one of these
};

}  // namespace ravel
