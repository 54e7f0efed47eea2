// Compares a decoded mesh with its original under the encoder's order maps. Linear.
#include <cmath>
#include <cstring>
#include <string>

#include "mesh/reorder.h"
#include "ravel/ravel.h"

namespace ravel {
namespace {

std::string text_of(Index i) {
    return std::to_string(i);
}

// Is `map` one to one onto [0, count)?
bool is_permutation(const std::vector<Index>& map, Index count) {
    if (map.size() != count) return false;
    std::vector<bool> hit(count, false);
    for (const Index i : map) {
        if (i >= count || hit[i]) return false;
        hit[i] = true;
    }
    return true;
}

std::uint32_t degree_of(const Mesh& mesh, Index cell) {
    return static_cast<std::uint32_t>(mesh.cell(cell).size());
}

class Comparer {
  public:
    Comparer(const Mesh& a, const Mesh& b, const OrderMaps& order, double bound,
             std::span<const double> attribute_bounds)
        : a_(a), b_(b), order_(order), bound_(bound), attribute_bounds_(attribute_bounds) {
        out_.attribute_errors.resize(attribute_bounds.size());
    }

    Comparison run() {
        connectivity();
        if (out_.connectivity_equal) {
            positions();
            attributes();
        }
        out_.equal = out_.connectivity_equal && out_.positions_equal && out_.attributes_equal;
        return out_;
    }

  private:
    void differ(std::string what) {
        if (out_.difference.empty()) out_.difference = std::move(what);
    }

    void connectivity() {
        if (a_.kind != b_.kind) return differ("the cells are of another kind");
        if (a_.point_count() != b_.point_count())
            return differ(text_of(a_.point_count()) + " points became " +
                          text_of(b_.point_count()));
        if (a_.cell_count() != b_.cell_count())
            return differ(text_of(a_.cell_count()) + " cells became " + text_of(b_.cell_count()));
        if (!is_permutation(order_.point, a_.point_count()) ||
            !is_permutation(order_.cell, a_.cell_count()) || order_.turn.size() != a_.cell_count())
            return differ("the order maps are no permutations");
        for (Index c = 0; c < a_.cell_count(); ++c) {
            const auto old_cell = a_.cell(c), new_cell = b_.cell(order_.cell[c]);
            bool same = old_cell.size() == new_cell.size();
            const std::uint32_t degree = degree_of(a_, c);
            if (a_.kind == CellKind::polygon && degree > 0) same = same && order_.turn[c] < degree;
            for (std::uint32_t i = 0; i < degree && same; ++i)
                same = order_.point[old_cell[old_corner(a_.kind, order_.turn[c], degree, i)]] ==
                       new_cell[i];
            if (!same) return differ("cell " + text_of(c) + " came back with other corners");
        }
        if (!companions()) return;
        out_.connectivity_equal = true;
        out_.order_kept = true;
        for (Index p = 0; p < a_.point_count() && out_.order_kept; ++p)
            out_.order_kept = order_.point[p] == p;
        for (Index c = 0; c < a_.cell_count() && out_.order_kept; ++c)
            out_.order_kept = order_.cell[c] == c && order_.turn[c] == 0;
        for (Index c = 0; c < order_.companion.size() && out_.order_kept; ++c)
            out_.order_kept = order_.companion[c] == c && order_.companion_turn[c] == 0;
    }

    bool companions() {
        if (a_.companions.size() != b_.companions.size()) {
            differ("the companion blocks are others");
            return false;
        }
        if (!is_permutation(order_.companion, a_.companion_count()) ||
            order_.companion_turn.size() != a_.companion_count()) {
            differ("the order maps are no permutations");
            return false;
        }
        Index before = 0;
        for (std::size_t i = 0; i < a_.companions.size(); ++i) {
            CompanionBlock x = a_.companions[i];
            const CompanionBlock& y = b_.companions[i];
            if (a_.kind == CellKind::tet)
                turn_edge_nodes(x, false, [&](Index host) { return order_.turn[host]; });
            bool same = x.vtk_type == y.vtk_type && x.nodes_per_cell == y.nodes_per_cell &&
                        x.cell_count == y.cell_count && x.nodes.size() == y.nodes.size() &&
                        x.hosts.size() == y.hosts.size();
            const Index n = x.nodes_per_cell;
            for (Index c = 0; c < x.cell_count && same; ++c) {
                const Index there = order_.companion[before + c] - before;
                const Index turn = order_.companion_turn[before + c];
                same = there < x.cell_count && (turn == 0 || turn < n);
                for (Index k = 0; k < n && same; ++k)
                    same = order_.point[x.nodes[c * n + (turn + k) % n]] == y.nodes[there * n + k];
                if (same && !x.hosts.empty()) same = order_.cell[x.hosts[c]] == y.hosts[there];
            }
            before += x.cell_count;
            if (!same) {
                differ("companion block " + text_of(i) + " came back changed");
                return false;
            }
        }
        return true;
    }

    void positions() {
        const Array &x = a_.positions, &y = b_.positions;
        out_.positions_equal = true;
        if (bound_ == 0) {
            if (x.scalar != y.scalar) {
                out_.positions_equal = false;
                return differ("the positions are of another type");
            }
            for (Index p = 0; p < a_.point_count(); ++p)
                if (std::memcmp(x.bytes.data() + p * x.stride(),
                                y.bytes.data() + order_.point[p] * x.stride(), x.stride()) != 0) {
                    out_.positions_equal = false;
                    return differ("point " + text_of(p) + " came back with other bits");
                }
            return;
        }
        for (Index p = 0; p < a_.point_count(); ++p)
            for (Index axis = 0; axis < 3; ++axis) {
                const double u = value_of(x, 3 * p + axis),
                             v = value_of(y, 3 * order_.point[p] + axis);
                const double error = std::abs(u - v);
                if (std::isfinite(u) && std::isfinite(v))
                    out_.max_error = std::max(out_.max_error, error);
                const bool same =
                    std::isfinite(u) ? error <= bound_ : std::memcmp(&u, &v, sizeof u) == 0;
                if (!same && out_.positions_equal) {
                    out_.positions_equal = false;
                    differ("point " + text_of(p) + " came back farther away than the bound");
                }
            }
    }

    // Where element i of the original is in the decoded mesh; corners go with their cells.
    void place_corners() {
        if (!corner_.empty() || a_.corners.empty()) return;
        corner_.resize(a_.corners.size());
        for (Index c = 0; c < a_.cell_count(); ++c) {
            const Index from = static_cast<Index>(a_.cell(c).data() - a_.corners.data());
            const Index to = static_cast<Index>(b_.cell(order_.cell[c]).data() - b_.corners.data());
            const std::uint32_t degree = degree_of(a_, c);
            for (std::uint32_t i = 0; i < degree; ++i)
                corner_[from + old_corner(a_.kind, order_.turn[c], degree, i)] = to + i;
        }
    }

    bool same_attribute(const Attribute& given, const Attribute& y) {
        if (given.references.size() != y.references.size()) return false;
        for (std::size_t i = 0; i < y.references.size(); ++i) {
            const Reference &r = given.references[i], &t = y.references[i];
            if (r.component != t.component || r.place != t.place || r.base != t.base) return false;
        }
        if (given.references.empty()) return same_values(given, y);
        Attribute renumbered = given;
        renumber(renumbered, order_.point, order_.cell);
        return same_values(renumbered, y);
    }

    bool same_values(const Attribute& x, const Attribute& y) {
        if (x.name != y.name || x.place != y.place || x.values.scalar != y.values.scalar ||
            x.values.arity != y.values.arity || x.values.bytes.size() != y.values.bytes.size() ||
            x.index.size() != y.index.size())
            return false;
        const std::vector<Index>* map = nullptr;
        if (x.place == Place::point) map = &order_.point;
        if (x.place == Place::cell) map = &order_.cell;
        if (x.place == Place::companion) map = &order_.companion;
        if (x.place == Place::corner) {
            place_corners();
            map = &corner_;
        }
        if (map != nullptr && map->empty()) map = nullptr;  // a pool that nothing refers to
        if (!x.index.empty()) return same_pool(x, y, map);
        for (Index i = 0; i < x.values.count(); ++i)
            if (!same_tuple(x, i, y, map != nullptr ? (*map)[i] : i)) return false;
        return true;
    }

    bool same_tuple(const Attribute& x, Index i, const Attribute& y, Index j) {
        const std::size_t stride = x.values.stride(), n = x.values.arity;
        const bool same = std::memcmp(x.values.bytes.data() + i * stride,
                                      y.values.bytes.data() + j * stride, stride) == 0;
        const double bound = at_ < attribute_bounds_.size() ? attribute_bounds_[at_] : 0;
        if (same || bound == 0 || !is_float(x.values.scalar)) return same;
        for (std::size_t k = 0; k < n; ++k) {
            const double error =
                std::abs(value_of(x.values, i * n + k) - value_of(y.values, j * n + k));
            if (!(error <= bound)) return false;
            out_.attribute_errors[at_] = std::max(out_.attribute_errors[at_], error);
        }
        return true;
    }
    static double value_of(const Array& array, Index i) {
        return array.scalar == Scalar::f32 ? static_cast<double>(array.as<float>()[i])
                                           : array.as<double>()[i];
    }

    // The same tuple wherever it was the same, each with its values; those that no element has in
    // their order.
    bool same_pool(const Attribute& x, const Attribute& y, const std::vector<Index>* map) {
        const Index tuples = x.values.count();
        std::vector<Index> there(tuples, kNoIndex), back(tuples, kNoIndex);
        for (Index e = 0; e < x.index.size(); ++e) {
            const Index i = x.index[e], j = y.index[map != nullptr ? (*map)[e] : e];
            if (i == kNoIndex || j == kNoIndex) {
                if (i != j) return false;
                continue;
            }
            if (j >= tuples) return false;
            if (there[i] == kNoIndex && back[j] == kNoIndex) there[i] = j, back[j] = i;
            if (there[i] != j || back[j] != i) return false;
        }
        for (Index i = 0, j = 0; i < tuples; ++i) {
            out_.order_kept = out_.order_kept && (there[i] == i || there[i] == kNoIndex);
            if (there[i] == kNoIndex) {
                while (back[j] != kNoIndex) ++j;
                there[i] = j++;
            }
            if (!same_tuple(x, i, y, there[i])) return false;
        }
        return true;
    }

    void attributes() {
        out_.attributes_equal = a_.attributes.size() == b_.attributes.size();
        if (!out_.attributes_equal) return differ("the attributes are others");
        for (std::size_t i = 0; i < a_.attributes.size(); ++i) {
            at_ = i;
            if (!same_attribute(a_.attributes[i], b_.attributes[i])) {
                out_.attributes_equal = false;
                differ("attribute \"" + a_.attributes[i].name + "\" came back changed");
            }
        }
        const auto same_names = [](const TagName& x, const TagName& y) {
            return x.attribute == y.attribute && x.dimension == y.dimension && x.value == y.value &&
                   x.name == y.name;
        };
        bool names =
            a_.tag_names.size() == b_.tag_names.size() && a_.notes.size() == b_.notes.size();
        for (std::size_t i = 0; names && i < a_.tag_names.size(); ++i)
            names = same_names(a_.tag_names[i], b_.tag_names[i]);
        for (std::size_t i = 0; names && i < a_.notes.size(); ++i)
            names = a_.notes[i].key == b_.notes[i].key && a_.notes[i].text == b_.notes[i].text;
        if (!names) {
            out_.attributes_equal = false;
            differ("names or notes came back changed");
        }
    }

    const Mesh &a_, &b_;
    const OrderMaps& order_;
    const double bound_;
    const std::span<const double> attribute_bounds_;
    std::size_t at_ = 0;  // the attribute that is compared
    std::vector<Index> corner_;
    Comparison out_;
};

}  // namespace

Comparison compare_meshes(const Mesh& original, const Mesh& decoded, const OrderMaps& order,
                          double bound, std::span<const double> attribute_bounds) {
    return Comparer(original, decoded, order, bound, attribute_bounds).run();
}

}  // namespace ravel
