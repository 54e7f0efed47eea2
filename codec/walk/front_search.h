// The vertices around a gate of a front of tets: those of its neighbours, of their neighbours, then
// others in the order in which a search from triangle to triangle meets them first.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "walk/tet_front.h"

namespace ravel {

class FrontSearch {
  public:
    static constexpr Id kMost = 255;  // the rank of what is not found
    static constexpr Id kNear = 8;

    // The place of `vertex` among those around, or kMost. `edge`: what is across is not among them.
    Id rank_of(const TetFront& front, Id gate, Id edge, Id vertex) {
        if (vertex == kNone) return kMost;
        for (Id i = 0; i < kNear; ++i)
            if (near(front, front[gate], edge, i) == vertex) return i;
        Id rank = kNear;
        bool found = false;
        search(front, gate, edge, [&](Id v) {
            found = v == vertex;
            rank += !found;
            return !found && rank < kMost;
        });
        return found ? rank : kMost;
    }
    // The vertex of a rank below kMost, or kNone.
    Id at_rank(const TetFront& front, Id gate, Id edge, Id rank) {
        if (rank < kNear) return near(front, front[gate], edge, rank);
        Id at = kNone;
        rank -= kNear;
        search(front, gate, edge, [&](Id v) {
            if (rank-- != 0) return true;
            at = v;
            return false;
        });
        return at;
    }

    static Id edge_after(Id edge, Id steps) {
        return edge + steps > 2 ? edge + steps - 3 : edge + steps;
    }

  private:
    static constexpr std::size_t kLooked = 192;  // triangles

    // Across the other edges of the gate, then across both other edges of each neighbour. Any may
    // come more than once, or be the gate's own: that is faster to tell than which do not.
    static Id near(const TetFront& front, const TetFront::Triangle& gate, Id edge, Id i) {
        if (i < 2) return front.apex_across(gate, edge_after(edge, 1 + i));
        const Id mate = gate.mate[edge_after(edge, i / 2)];
        return front.apex_across(front[mate >> 2], edge_after(mate & 3, 1 + (i & 1)));
    }

    template <class Meet>
    void search(const TetFront& front, Id gate, Id edge, const Meet& meet) {
        if (front.size() > triangle_turn_.size()) triangle_turn_.resize(2 * front.size());
        ++turn_;
        for (const Id v : front[gate].vertex) meets(v);
        meets(front.apex_across(front[gate], edge));
        for (Id i = 0; i < kNear; ++i) meets(near(front, front[gate], edge, i));
        queue_[0] = gate;
        triangle_turn_[gate] = turn_;
        std::size_t end = 1;
        for (std::size_t i = 0; i < end; ++i) {
            const TetFront::Triangle& t = front[queue_[i]];
            for (Id e = 0; e < 3; ++e) {
                const Id mate = t.mate[e], next = mate >> 2;
                if (triangle_turn_[next] == turn_ || end == kLooked) continue;
                triangle_turn_[next] = turn_;
                if (front[next].border) continue;
                queue_[end++] = next;
                const Id v = front[next].vertex[mate & 3];
                if (meets(v) && !meet(v)) return;
            }
        }
    }
    // For the first time in this search?
    bool meets(Id v) {
        if (v >= vertex_turn_.size()) vertex_turn_.resize(2 * std::size_t{v} + 64);
        const bool first = vertex_turn_[v] != turn_;
        vertex_turn_[v] = turn_;
        return first;
    }

    // Per triangle, per vertex: the last search that met it.
    std::vector<std::uint32_t> triangle_turn_, vertex_turn_;
    std::uint32_t turn_ = 0;
    std::array<Id, kLooked> queue_;
};

}  // namespace ravel
