// The front of a walk over tets: a closed surface of triangles, the facets of visited tets that
// lead to unvisited ones, and the borders met so far. Facet f has the edge slots 3f, 3f+1, 3f+2;
// slot e is the edge opposite the e-th vertex of the facet's outward triple. Slots of neighbouring
// facets are mates; `fan` counts the visited tets between two mates. A hash finds an open facet by
// its vertices; those that crowd into one place of it go to a tree, so that no choice of vertices
// makes a step dearer than O(log facets).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "walk/walk.h"

namespace ravel {

// Local corners of the facet opposite each corner, outward: the boundary of an oriented simplex.
inline constexpr std::array<std::array<Id, 3>, 4> kOutward{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

class TetFront {
  public:
    explicit TetFront(const std::vector<Id>& vertex) : vertex_(vertex) {}

    void reserve(std::size_t facets) {
        mate_.reserve(3 * facets);
        fan_.reserve(3 * facets);
    }

    Id corner_of_slot(
        Id slot) const {  // the corner (in its cell) the slot's edge lies opposite, in the facet
        const Id facet = slot / 3;
        return (facet & ~Id{3}) + kOutward[facet & 3][slot % 3];
    }
    Id vertex_of_slot(Id slot) const { return vertex_[corner_of_slot(slot)]; }
    // The apex across the slot's edge: the vertex of the mate facet that is not on the edge.
    Id apex_across(Id slot) const { return vertex_of_slot(mate_[slot]); }
    Id mate(Id slot) const { return mate_[slot]; }
    unsigned fan(Id slot) const { return fan_[slot]; }

    // Slots of facets of one tet that share an edge: facet a's slot opposite corner b.
    static Id slot_between(Id base, Id a, Id b) {
        const auto& triple = kOutward[a];
        const Id e = triple[0] == b ? 0 : triple[1] == b ? 1 : 2;
        return 3 * (base + a) + e;
    }

    void add_seed(Id base) {
        grow(base);
        for (Id a = 0; a < 4; ++a)
            for (Id b = 0; b < a; ++b) pair(slot_between(base, a, b), slot_between(base, b, a), 1);
    }

    // Replaces front facet `gate` by facets 0, 1, 2 of the tet at `base`, whose corners 0, 1, 2 are
    // the gate's outward triple.
    void add_tet(Id base, Id gate) {
        grow(base);
        std::array<Id, 3> across;
        std::array<unsigned, 3> fans;
        for (Id k = 0; k < 3; ++k) {
            across[k] = mate_[3 * gate + k];
            fans[k] = fan_[3 * gate + k];
        }
        for (Id k = 0; k < 3; ++k) {
            const Id mine = slot_between(base, k, 3);
            Id other = across[k];
            unsigned tets = fans[k] + 1;
            if (other / 3 == gate) {  // the gate is its own neighbour
                other = slot_between(base, other % 3, 3);
                ++tets;
            }
            pair(mine, other, tets);
        }
        for (Id a = 0; a < 3; ++a)
            for (Id b = 0; b < a; ++b) pair(slot_between(base, a, b), slot_between(base, b, a), 1);
    }

    // Facets f and g have the same vertices and meet: their neighbours become mates.
    void glue(Id f, Id g) {
        for (Id e = 0; e < 3; ++e) {
            const Id s = 3 * f + e;
            Id r = 3 * g;
            while (r < 3 * g + 2 && vertex_of_slot(r) != vertex_of_slot(s)) ++r;
            const Id beside_s = mate_[s], beside_r = mate_[r];
            if (beside_s == r || beside_s == s || beside_r == r) continue;
            pair(beside_s, beside_r, fan_[s] + unsigned{fan_[r]});
        }
    }

    // --- open facets by their vertices; no two have the same -----------------------------------

    void insert(Id facet) {
        if (2 * (used_ + 1) > table_.size()) rehash();
        if (place(facet)) ++live_;
    }
    void erase(Id facet) {
        if (table_.empty()) return;
        std::size_t i = home_of(key_of(facet));
        for (int probe = 0; probe < kMostProbes && table_[i] != kNone; ++probe, i = next(i))
            if (table_[i] == facet) {
                table_[i] = kErased;
                --live_;
                return;
            }
        if (!crowd_.empty()) crowd_.erase(key_of(facet));
    }
    // The open facet with the vertices of `facet`, or kNone.
    Id find(Id facet) const {
        if (table_.empty()) return kNone;
        const Key key = key_of(facet);
        std::size_t i = home_of(key);
        for (int probe = 0; probe < kMostProbes && table_[i] != kNone; ++probe, i = next(i))
            if (table_[i] != kErased && key_of(table_[i]) == key) return table_[i];
        if (crowd_.empty()) return kNone;
        const auto found = crowd_.find(key);
        return found == crowd_.end() ? kNone : found->second;
    }
    // How many open facets found no place near their own.
    std::size_t crowd() const { return crowd_.size(); }

  private:
    using Key = std::array<Id, 3>;
    static constexpr Id kErased = kNone - 1;
    static constexpr int kMostProbes = 48;

    void grow(Id base) {
        mate_.resize(3 * (std::size_t{base} + 4), 0);
        fan_.resize(3 * (std::size_t{base} + 4), 0);
    }
    void pair(Id s, Id r, unsigned tets) {
        mate_[s] = r;
        mate_[r] = s;
        fan_[s] = fan_[r] = static_cast<std::uint8_t>(tets < 255 ? tets : 255);
    }
    Key key_of(Id facet) const {
        const Id base = facet & ~Id{3};
        const auto& triple = kOutward[facet & 3];
        Key v{vertex_[base + triple[0]], vertex_[base + triple[1]], vertex_[base + triple[2]]};
        if (v[0] > v[1]) std::swap(v[0], v[1]);
        if (v[1] > v[2]) std::swap(v[1], v[2]);
        if (v[0] > v[1]) std::swap(v[0], v[1]);
        return v;
    }
    std::size_t home_of(const Key& v) const {
        std::uint64_t h = v[0] * 0x9E3779B97F4A7C15u;
        h = (h ^ (h >> 29) ^ v[1]) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 32) ^ v[2]) * 0x94D049BB133111EBu;
        return (h ^ (h >> 31)) & (table_.size() - 1);
    }
    std::size_t next(std::size_t i) const { return (i + 1) & (table_.size() - 1); }
    // Into the table, or else the tree: is it the table?
    bool place(Id facet) {
        const Key key = key_of(facet);
        std::size_t i = home_of(key);
        for (int probe = 0; probe < kMostProbes; ++probe, i = next(i))
            if (table_[i] >= kErased) {
                if (table_[i] == kNone) ++used_;
                table_[i] = facet;
                return true;
            }
        crowd_.emplace(key, facet);
        return false;
    }
    void rehash() {
        std::vector<Id> old(table_.size() < 4 * (live_ + 16)
                                ? std::max<std::size_t>(64, table_.size() * 2)
                                : table_.size(),
                            kNone);
        old.swap(table_);
        used_ = live_ = 0;
        for (const Id facet : old)
            if (facet < kErased && place(facet)) ++live_;
    }

    const std::vector<Id>& vertex_;  // of the walk, per corner
    std::vector<Id> mate_;           // per slot
    std::vector<std::uint8_t> fan_;  // per slot
    std::vector<Id> table_;          // open addressing, linear probing
    std::size_t used_ = 0, live_ = 0;
    std::map<Key, Id> crowd_;
};

}  // namespace ravel
