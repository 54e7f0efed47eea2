// The front of a walk over tets: a closed surface of triangles, the facets of visited tets that
// lead to unvisited ones, and the borders met so far. Edge e of a triangle lies opposite its vertex
// e; edges of neighbouring triangles are mates, and `fan` counts the visited tets between two
// mates.
//
// Triangles that leave the front make room for new ones: what the walk touches stays small.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "walk/open_triangles.h"
#include "walk/walk.h"

namespace ravel {

// Local corners of the facet opposite each corner, outward: the boundary of an oriented simplex.
// The apex of a tet (corner 3) is the last one of the facets it is in.
inline constexpr std::array<std::array<Id, 3>, 4> kOutward{
    {{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {0, 2, 1}}};

inline bool is_in(const std::array<Id, 3>& triangle, Id v) {
    return v == triangle[0] || v == triangle[1] || v == triangle[2];
}

class TetFront {
  public:
    struct Triangle {
        std::array<Id, 3> vertex{};  // outward
        std::array<Id, 3> mate{};    // 4 * triangle + edge
        std::array<std::uint8_t, 3> fan{};
        bool border = false;
        Id facet = kNone;  // of the walk
    };

    const Triangle& operator[](Id triangle) const { return triangles_[triangle]; }
    // All triangles so far have smaller numbers.
    std::size_t size() const { return triangles_.size(); }
    void set_border(Id triangle) { triangles_[triangle].border = true; }

    const Triangle& across(const Triangle& t, Id edge) const {
        return triangles_[t.mate[edge] >> 2];
    }
    // The apex across an edge: the vertex of the neighbour that is not on it.
    Id apex_across(const Triangle& t, Id edge) const {
        const Id mate = t.mate[edge];
        return triangles_[mate >> 2].vertex[mate & 3];
    }

    // The four facets of a first tet; its facet i becomes result[i].
    std::array<Id, 4> add_seed(const std::array<Id, 4>& corner, Id facet) {
        std::array<Id, 4> made;
        for (Id i = 0; i < 4; ++i)
            made[i] = add({corner[kOutward[i][0]], corner[kOutward[i][1]], corner[kOutward[i][2]]},
                          facet + i);
        join_sides({made[0], made[1], made[2]});
        // Edge e of facet 3 = (0 2 1) lies opposite corner 0, 2, 1.
        static constexpr std::array<Id, 3> kSide{0, 2, 1};
        for (Id e = 0; e < 3; ++e) pair(slot(made[3], e), slot(made[kSide[e]], 2), 1);
        return made;
    }

    // Replaces `gate` by the facets 0, 1, 2 of the tet entered through it: its corners 0, 1, 2 are
    // the gate's vertices, corner 3 is the apex.
    std::array<Id, 3> add_tet(Id gate, Id apex, Id facet) {
        const Triangle old = triangles_[gate];
        const std::array<Id, 3> made{gate, take(), take()};
        const auto& v = old.vertex;
        for (Id k = 0; k < 3; ++k) {
            const Id after = (k + 1) % 3, before = (k + 2) % 3;
            Id other = old.mate[k];
            unsigned tets = old.fan[k] + 1u;
            if (other >> 2 == gate) {  // the gate is its own neighbour
                other = slot(made[other & 3], 2);
                ++tets;
            }
            // The edges at the apex: facet k's edge 0 is facet k + 1's edge 1.
            triangles_[made[k]] = {{v[after], v[before], apex},
                                   {slot(made[after], 1), slot(made[before], 0), other},
                                   {1, 1, most_255(tets)},
                                   false,
                                   facet + k};
            if (old.mate[k] >> 2 == gate) continue;
            Triangle& beside = triangles_[other >> 2];
            beside.mate[other & 3] = slot(made[k], 2);
            beside.fan[other & 3] = most_255(tets);
        }
        return made;
    }

    // Two triangles have the same vertices and meet: their neighbours become mates. Both leave.
    void glue(Id f, Id g) {
        for (Id e = 0; e < 3; ++e) {
            const Triangle &a = triangles_[f], &b = triangles_[g];
            const Id r = (b.vertex[1] == a.vertex[e]) + 2 * (b.vertex[2] == a.vertex[e]);
            const Id s = slot(f, e), t = slot(g, r), beside_s = a.mate[e], beside_t = b.mate[r];
            if (beside_s == t || beside_s == s || beside_t == t) continue;
            pair(beside_s, beside_t, a.fan[e] + unsigned{b.fan[r]});
        }
        release(f);
        release(g);
    }

    // The triangle across the edge that was the gate's, of one that add_tet has just made.
    Id beyond(Id triangle) const { return triangles_[triangle].mate[2] >> 2; }

    // --- open triangles by their vertices; no two have the same --------------------------------

    void insert(Id triangle) { open_.insert(triangle, VerticesOf{triangles_}); }
    void erase(Id triangle) { open_.erase(triangle, triangles_[triangle].vertex); }
    // The open triangle with the vertices of `triangle`, which add_tet has just made, or kNone.
    // Four times in five it is the one across the edge that was the gate's: with the same apex it
    // has the same vertices, and what is in the front and no border is open.
    Id find(Id triangle) const {
        const Triangle& t = triangles_[triangle];
        const Id mate = t.mate[2];
        const Triangle& beside = triangles_[mate >> 2];
        if (beside.vertex[mate & 3] == t.vertex[2] && !beside.border) return mate >> 2;
        return open_.find(t.vertex, VerticesOf{triangles_});
    }
    const OpenTriangles& open() const { return open_; }

  private:
    struct VerticesOf {
        const std::vector<Triangle>& triangles;
        const std::array<Id, 3>& operator()(Id t) const { return triangles[t].vertex; }
    };
    static Id slot(Id triangle, Id edge) { return triangle << 2 | edge; }
    // The place of a new triangle.
    Id take() {
        const Id t = free_;
        if (t == kNone) {
            triangles_.emplace_back();
            return static_cast<Id>(triangles_.size() - 1);
        }
        free_ = triangles_[t].mate[0];
        return t;
    }
    Id add(const std::array<Id, 3>& vertex, Id facet) {
        const Id t = take();
        triangles_[t].vertex = vertex;
        triangles_[t].border = false;
        triangles_[t].facet = facet;
        return t;
    }
    void release(Id t) {
        triangles_[t].mate[0] = free_;
        free_ = t;
    }
    void pair(Id s, Id r, unsigned tets) {
        Triangle &a = triangles_[s >> 2], &b = triangles_[r >> 2];
        a.mate[s & 3] = r;
        b.mate[r & 3] = s;
        a.fan[s & 3] = b.fan[r & 3] = most_255(tets);
    }
    static std::uint8_t most_255(unsigned tets) {
        return static_cast<std::uint8_t>(tets < 255 ? tets : 255);
    }
    // The edges at the apex of a seed.
    void join_sides(const std::array<Id, 3>& made) {
        for (Id k = 0; k < 3; ++k) pair(slot(made[k], 0), slot(made[(k + 1) % 3], 1), 1);
    }

    std::vector<Triangle> triangles_;
    Id free_ = kNone;  // first of the list of free places, linked by mate[0]
    OpenTriangles open_;
};

}  // namespace ravel
