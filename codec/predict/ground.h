// The mesh as both sides know it once connectivity and positions are decoded, before any order is
// restored: what rides along is coded on it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"
#include "mesh/stencil.h"
#include "ravel/mesh.h"

namespace ravel {

// Outward corners of the facet of a tet opposite each corner.
inline constexpr std::array<std::array<Id, 3>, 4> kOutwardCorners{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

// The arc cosine within 2e-8, the same on every machine [AbramowitzStegun1964, 4.4.46].
inline double angle_of_cosine(double cosine) {
    constexpr std::array<double, 8> kTerms{-0.0012624911, 0.0066700901,  -0.0170881256,
                                           0.0308918810,  -0.0501743046, 0.0889789874,
                                           -0.2145988016, 1.5707963050};
    const double x = std::min(std::abs(cosine), 1.0);
    double sum = 0;
    for (const double term : kTerms) sum = sum * x + term;
    const double angle = std::sqrt(1 - x) * sum;
    return cosine < 0 ? 3.14159265358979323846 - angle : angle;
}

// `Walk` is the visited complex (Walked, see the walk's room): cells, corners and facets in the
// order of the walk.
template <class Walk>
struct Ground {
    const Walk& walk;
    const Mesh& mesh;                          // points and cells in the same order
    const std::vector<Id>& point;              // vertex of the walk -> point
    const std::vector<std::uint8_t>& flipped;  // per cell; empty where none is
    const std::vector<Stencil>& stencils;      // per point of a vertex, then of edges; empty if
                                               // not needed

    Point3 place_of_point(Index p) const {
        Point3 place;
        for (std::size_t k = 0; k < 3; ++k)
            place[k] = mesh.positions.scalar == Scalar::f32
                           ? static_cast<double>(mesh.positions.as<float>()[3 * p + k])
                           : mesh.positions.as<double>()[3 * p + k];
        return place;
    }
    Id point_at(Id corner) const { return point[walk.vertex[corner]]; }
    Point3 place_of_corner(Id corner) const { return place_of_point(point_at(corner)); }
    // Of a tet's facet; its length is twice the area.
    Point3 normal_of(Id facet) const {
        const Id base = facet & ~Id{3};
        const auto& corner = kOutwardCorners[facet & 3];
        const Point3 a = place_of_corner(base + corner[0]);
        return cross(minus(place_of_corner(base + corner[1]), a),
                     minus(place_of_corner(base + corner[2]), a));
    }
    // Of a polygon (a part of one of very many corners); its length is twice the area.
    Point3 normal_of_polygon(Id cell) const {
        if (walk.kind == CellKind::tet) return {};
        const Id begin = walk.begin(cell), end = std::min(walk.end(cell), begin + 16);
        Point3 sum{};
        if (begin == end) return sum;
        const Point3 a = place_of_corner(begin);
        for (Id c = begin + 1; c + 1 < end; ++c) {
            const Point3 n = cross(minus(place_of_corner(c), a), minus(place_of_corner(c + 1), a));
            for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
        }
        // The mesh has flipped ones the other way round.
        if (!flipped.empty() && flipped[cell])
            for (double& x : sum) x = -x;
        return sum;
    }
    // The same at a corner; or its length is the polygon's angle there.
    Point3 normal_at_corner(Id corner, bool by_angle) const {
        Point3 n = normal_of_polygon(walk.cell_of(corner));
        if (!by_angle || walk.kind == CellKind::tet) return n;
        const Point3 here = place_of_corner(corner);
        const Point3 u = minus(place_of_corner(walk.next_in_cell(corner)), here),
                     v = minus(place_of_corner(walk.prev_in_cell(corner)), here);
        const double weight =
            angle_of_cosine(dot(u, v) / std::sqrt(dot(u, u) * dot(v, v))) / std::sqrt(dot(n, n));
        for (double& x : n) x *= weight;
        return n;
    }
    // Of a polygon's side, from start to end.
    Point3 way_of(Id side) const {
        return minus(place_of_corner(walk.next_in_cell(side)), place_of_corner(side));
    }

    // The corner of the mesh where the walk has `corner`: flipped cells are turned back there.
    Id mesh_corner(Id corner) const { return flipped.empty() ? corner : turned_back(corner); }
    Id turned_back(Id corner) const {
        const Id cell = walk.cell_of(corner), begin = walk.begin(cell);
        const Id i = corner - begin;
        if (!flipped[cell] || i == 0) return corner;
        if (walk.kind == CellKind::tet) return i < 2 ? corner : begin + 5 - i;
        return walk.end(cell) - i;
    }

    // The facets about an edge of a tet's facet, through cells from that of `facet` on, away from
    // it: `visit(g)` for each facet g, until it says stop or there is no cell that `enter` lets in.
    // The edge is the one of `facet` without corner `local` of its cell.
    template <class Enter, class Visit>
    void turn_about_edge(Id facet, Id local, const Enter& enter, const Visit& visit) const {
        constexpr int kMostSteps = 24;
        Id behind = walk.vertex[facet], g = (facet & ~Id{3}) + local;
        for (int step = 0; step < kMostSteps && visit(g); ++step) {
            const Id across = walk.twin[g];
            if (across == kNone || across / 4 == facet / 4 || !enter(across / 4)) return;
            const Id base = across & ~Id{3};
            Id next = base;
            for (Id k = 1; k < 4; ++k) next += walk.vertex[base + k] == behind ? k : 0;
            if (walk.vertex[next] != behind) return;  // no cell an encoder makes
            behind = walk.vertex[across];
            g = next;
        }
    }
    // The same about the start (or end) of a polygon's side.
    template <class Enter, class Visit>
    void turn_about_end(Id side, bool end, const Enter& enter, const Visit& visit) const {
        constexpr int kMostSteps = 24;
        const auto beside = [&](Id f) { return end ? walk.next_in_cell(f) : walk.prev_in_cell(f); };
        const Id home = walk.cell_of(side);
        Id g = beside(side);
        for (int step = 0; step < kMostSteps && visit(g); ++step) {
            const Id across = walk.twin[g];
            if (across == kNone || walk.cell_of(across) == home || !enter(walk.cell_of(across)))
                return;
            g = beside(across);
        }
    }
};

}  // namespace ravel
