// The front of a walk over tets: a closed surface of triangles, the facets of visited tets that
// lead to unvisited ones, and the borders met so far. Edge e of a triangle lies opposite its vertex
// e; edges of neighbouring triangles are mates, and `fan` counts the visited tets between two
// mates. A hash finds an open triangle by its vertices; where many crowd into one place of it, it
// grows, or becomes another hash: no choice of vertices fits them all.
//
// Triangles that leave the front make room for new ones: what the walk touches stays small.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

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
        release(gate);
        const auto& v = old.vertex;
        const std::array<Id, 3> made{add({v[1], v[2], apex}, facet),
                                     add({v[2], v[0], apex}, facet + 1),
                                     add({v[0], v[1], apex}, facet + 2)};
        for (Id k = 0; k < 3; ++k) {
            Id other = old.mate[k];
            unsigned tets = old.fan[k] + 1u;
            if (other >> 2 == gate) {  // the gate is its own neighbour
                other = slot(made[other & 3], 2);
                ++tets;
            }
            pair(slot(made[k], 2), other, tets);
        }
        join_sides(made);
        return made;
    }

    // Two triangles have the same vertices and meet: their neighbours become mates. Both leave.
    void glue(Id f, Id g) {
        for (Id e = 0; e < 3; ++e) {
            const Triangle &a = triangles_[f], &b = triangles_[g];
            Id r = 0;
            while (r < 2 && b.vertex[r] != a.vertex[e]) ++r;
            const Id s = slot(f, e), t = slot(g, r), beside_s = a.mate[e], beside_t = b.mate[r];
            if (beside_s == t || beside_s == s || beside_t == t) continue;
            pair(beside_s, beside_t, a.fan[e] + unsigned{b.fan[r]});
        }
        release(f);
        release(g);
    }

    // --- open triangles by their vertices; no two have the same --------------------------------

    void insert(Id triangle) {
        if (2 * (used_ + 1) > table_.size()) rehash(false);
        while (!place(triangle)) rehash(true);
        ++live_;
    }
    void erase(Id triangle) {
        if (table_.empty()) return;
        std::size_t i = home_of(hash_of(key_of(triangles_[triangle].vertex)));
        for (int probe = 0; probe < kMostProbes && table_[i].triangle != kNone;
             ++probe, i = next(i))
            if (table_[i].triangle == triangle) {
                table_[i].triangle = kErased;
                --live_;
                return;
            }
    }
    // The open triangle with the vertices of `triangle`, or kNone.
    Id find(Id triangle) const {
        if (table_.empty()) return kNone;
        const Key key = key_of(triangles_[triangle].vertex);
        const std::uint64_t hash = hash_of(key);
        std::size_t i = home_of(hash);
        for (int probe = 0; probe < kMostProbes && table_[i].triangle != kNone;
             ++probe, i = next(i))
            if (table_[i].print == print_of(hash) && table_[i].triangle != kErased &&
                key_of(triangles_[table_[i].triangle].vertex) == key)
                return table_[i].triangle;
        return kNone;
    }
    // How many places the hash has, and how often it became another one.
    std::size_t places() const { return table_.size(); }
    std::uint64_t changes() const { return change_; }

  private:
    using Key = std::array<Id, 3>;
    static constexpr Id kErased = kNone - 1;
    static constexpr int kMostProbes = 48;

    static Id slot(Id triangle, Id edge) { return triangle << 2 | edge; }
    Id add(const std::array<Id, 3>& vertex, Id facet) {
        Id t = free_;
        if (t != kNone) {
            free_ = triangles_[t].mate[0];
        } else {
            t = static_cast<Id>(triangles_.size());
            triangles_.emplace_back();
        }
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
        a.fan[s & 3] = b.fan[r & 3] = static_cast<std::uint8_t>(tets < 255 ? tets : 255);
    }
    // The edges at the apex: facet k's edge 0 is facet k + 1's edge 1.
    void join_sides(const std::array<Id, 3>& made) {
        for (Id k = 0; k < 3; ++k) pair(slot(made[k], 0), slot(made[(k + 1) % 3], 1), 1);
    }

    static Key key_of(const Key& v) {
        const Id low = std::min(v[0], v[1]), high = std::max(v[0], v[1]);
        return {std::min(low, v[2]), std::max(low, std::min(high, v[2])), std::max(high, v[2])};
    }
    std::uint64_t hash_of(const Key& v) const {
        std::uint64_t h = (v[0] + (change_ << 32)) * 0x9E3779B97F4A7C15u;
        h = (h ^ (h >> 29) ^ v[1]) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 32) ^ v[2]) * 0x94D049BB133111EBu;
        return h ^ (h >> 31);
    }
    std::size_t home_of(std::uint64_t hash) const { return hash & (table_.size() - 1); }
    static std::uint32_t print_of(std::uint64_t hash) {
        return static_cast<std::uint32_t>(hash >> 32);
    }
    std::size_t next(std::size_t i) const { return (i + 1) & (table_.size() - 1); }
    // False where all places near its own are taken.
    bool place(Id triangle) {
        const std::uint64_t hash = hash_of(key_of(triangles_[triangle].vertex));
        std::size_t i = home_of(hash);
        for (int probe = 0; probe < kMostProbes; ++probe, i = next(i))
            if (table_[i].triangle >= kErased) {
                if (table_[i].triangle == kNone) ++used_;
                table_[i] = {triangle, print_of(hash)};
                return true;
            }
        return false;
    }
    void rehash(bool crowded) {
        std::vector<Place> old;
        old.swap(table_);
        std::size_t size = std::max<std::size_t>(64, old.size());
        for (bool fits = false; !fits; crowded = true) {
            if (size < 3 * (live_ + 16) || (crowded && size < 8 * live_))
                size *= 2;
            else
                change_ += crowded;
            table_.assign(size, {});
            used_ = 0;
            fits = true;
            for (const Place& p : old)
                if (p.triangle < kErased && fits) fits = place(p.triangle);
        }
    }

    struct Place {
        Id triangle = kNone;
        std::uint32_t print = 0;  // of its hash, to tell most others apart without a look at them
    };

    std::vector<Triangle> triangles_;
    Id free_ = kNone;           // first of the list of free places, linked by mate[0]
    std::vector<Place> table_;  // open addressing, linear probing
    std::size_t used_ = 0, live_ = 0;
    std::uint64_t change_ = 0;
};

}  // namespace ravel
