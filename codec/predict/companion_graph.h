// Companions linked where they meet: faces by their edges, lines by their ends. For floods, and as
// elements with values.
#pragma once

#include <algorithm>
#include <vector>

#include "mesh/flatness.h"
#include "predict/around.h"
#include "predict/counting_sort.h"
#include "predict/flood_codes.h"
#include "predict/ground.h"

namespace ravel {

template <class Walk>
class CompanionGraph final : public FloodGraph, public Around {
  public:
    explicit CompanionGraph(const Ground<Walk>& ground)
        : FloodGraph(links_of(ground.mesh)), ground_(ground) {
        for (const CompanionBlock& block : ground.mesh.companions)
            for (Index i = 0; i < block.cell_count; ++i) {
                nodes_.push_back(block.nodes.data() + i * block.nodes_per_cell);
                first_.push_back(first_.back() + links_of(block));
            }
        element_.resize(first_.back());
        for (Id e = 0; e + 1 < first_.size(); ++e)
            std::fill(element_.begin() + first_[e], element_.begin() + first_[e + 1], e);
        pair_links();
        walls_at_.assign(ground.mesh.point_count(), 0);
    }

    Id size() const override { return static_cast<Id>(nodes_.size()); }
    Id begin(Id element) const override { return first_[element]; }
    Id end(Id element) const override { return first_[element + 1]; }
    Id twin(Id link) const override { return twin_[link]; }
    Id element_of(Id link) const override { return element_[link]; }

    // How straight the faces meet, and at how many ends of the edge there are walls.
    std::uint32_t walls_about(Id link, const std::vector<std::uint8_t>&) const override {
        const Id other = twin_[link];
        const Key key = key_of(link);
        return 3 * flatness(direction(link, false), direction(other, true)) + walls_at_[key.a] +
               (key.b != kNone ? walls_at_[key.b] : 0);
    }
    void note_wall(Id link) override {
        const Key key = key_of(link);
        walls_at_[key.a] = 1;
        if (key.b != kNone) walls_at_[key.b] = 1;
    }
    void note_start() override { walls_at_.assign(walls_at_.size(), 0); }

    Beside beside(Id element, const Id*) const override {
        Beside b;
        for (Id f = first_[element]; f < first_[element + 1]; ++f)
            if (twin_[f] != kNone && element_[twin_[f]] < element) b.add(element_[twin_[f]]);
        if (b.count == 0 && element > 0) b.add(element - 1, 1);
        return b;
    }
    Point3 place(Id element) const override {
        const Id links = std::max(first_[element + 1] - first_[element], Id{1});
        Point3 sum{};
        for (Id k = 0; k < links && nodes_[element] != nullptr; ++k) {
            const Point3 p = ground_.place_of_point(nodes_[element][k]);
            for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i];
        }
        for (double& x : sum) x /= static_cast<double>(links);
        return sum;
    }

  private:
    struct Key {
        Id a = kNone, b = kNone;
    };

    // Lines have two, triangles and quads as many as sides; others have none.
    static Id links_of(const CompanionBlock& block) {
        const bool known = block.vtk_type == 3 || block.vtk_type == 5 || block.vtk_type == 9;
        const std::uint32_t n = block.nodes_per_cell;
        return known && n == (block.vtk_type == 3 ? 2u : block.vtk_type == 5 ? 3u : 4u) ? n : 0;
    }
    static std::size_t links_of(const Mesh& mesh) {
        std::size_t links = 0;
        for (const CompanionBlock& block : mesh.companions)
            links += block.cell_count * links_of(block);
        return links;
    }

    // The point or edge by which a link leads on.
    Key key_of(Id link) const {
        const Id e = element_[link], k = link - first_[e], n = first_[e + 1] - first_[e];
        const auto a = static_cast<Id>(nodes_[e][k]);
        if (n == 2) return {a, kNone};
        const auto b = static_cast<Id>(nodes_[e][(k + 1) % n]);
        return {std::min(a, b), std::max(a, b)};
    }
    // Links with the same key in pairs, as they come.
    void pair_links() {
        std::vector<Id> links(element_.size()), low(links.size()), high(links.size());
        for (Id f = 0; f < links.size(); ++f) {
            const Key key = key_of(f);
            links[f] = f;
            low[f] = key.a;
            high[f] = key.b + 1;  // none is lowest
        }
        const auto points = static_cast<Id>(ground_.mesh.point_count());
        counting_sort(links, high, points + 1);
        counting_sort(links, low, points + 1);
        twin_.assign(element_.size(), kNone);
        for (std::size_t i = 0; i + 1 < links.size(); ++i) {
            const Id f = links[i], g = links[i + 1];
            if (low[f] != low[g] || high[f] != high[g]) continue;
            twin_[f] = g;
            twin_[g] = f;
            ++i;
        }
    }
    // The normal of a face, so turned that faces which go on straight have equal ones; the way of a
    // line through the link.
    Point3 direction(Id link, bool onwards) const {
        const Id e = element_[link], k = link - first_[e], n = first_[e + 1] - first_[e];
        const auto at = [&](Id i) { return ground_.place_of_point(nodes_[e][i % n]); };
        if (n == 2) return onwards ? minus(at(k + 1), at(k)) : minus(at(k), at(k + 1));
        const Point3 normal = cross(minus(at(k + 1), at(k)), minus(at(k + 2), at(k)));
        // An edge runs one way in one face and the other way in the next, where both are turned
        // alike.
        const bool up = (nodes_[e][k] < nodes_[e][(k + 1) % n]) != onwards;
        return up ? normal : Point3{-normal[0], -normal[1], -normal[2]};
    }

    const Ground<Walk>& ground_;
    std::vector<const Index*> nodes_;     // per element
    std::vector<Id> first_{0};            // element -> its first link
    std::vector<Id> element_, twin_;      // per link
    std::vector<std::uint8_t> walls_at_;  // per point
};

}  // namespace ravel
