// Disjoint sets with path halving and union by size. Near-constant time per call [Tarjan1975].
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "graph/graph.h"

namespace ravel {

class UnionFind {
  public:
    explicit UnionFind(GraphId count) : parent_(count), size_(count, 1) {
        std::iota(parent_.begin(), parent_.end(), GraphId{0});
    }

    GraphId find(GraphId x) {
        while (parent_[x] != x) {
            parent_[x] = parent_[parent_[x]];
            x = parent_[x];
        }
        return x;
    }

    // False where both already are in one set.
    bool unite(GraphId a, GraphId b) {
        a = find(a);
        b = find(b);
        if (a == b) return false;
        if (size_[a] < size_[b] || (size_[a] == size_[b] && b < a)) std::swap(a, b);
        parent_[b] = a;
        size_[a] += size_[b];
        return true;
    }

    GraphId size(GraphId x) { return size_[find(x)]; }

    // Starts x with another size than one, before any unite.
    void weigh(GraphId x, GraphId size) { size_[x] = size; }

  private:
    std::vector<GraphId> parent_;
    std::vector<GraphId> size_;
};

}  // namespace ravel
