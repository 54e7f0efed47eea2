// Gluing by counting sort on the smallest point of each facet, orientation by a breadth-first walk,
// vertices by union-find over corners. Near-linear; the order of cells decides every tie.
#include "mesh/complex.h"

#include <algorithm>
#include <array>
#include <string>

namespace ravel {
namespace {

// The points of a facet in ascending order, and whether its own order is an odd permutation of
// that.
struct FacetKey {
    std::array<Id, 3> points{kNone, kNone, kNone};
    bool odd = false;
    bool degenerate = false;
};

// Outward orientation of the facet opposite each corner: the boundary of an oriented simplex.
constexpr std::array<std::array<int, 3>, 4> kTetFacets{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

class Gluer {
  public:
    Gluer(const Mesh& mesh, Complex& out) : mesh_(mesh), out_(out) {}

    void run() {
        number_facets();
        glue_equal_facets();
        orient();
        join_corners();
        while (isolate_cells_meeting_a_vertex_twice()) join_corners();
        name_vertices();
        apply_flips();
    }

  private:
    Id point_at(Id corner) const { return static_cast<Id>(mesh_.corners[corner]); }

    void number_facets() {
        const auto cells = static_cast<Id>(mesh_.cell_count());
        const auto facets = static_cast<Id>(mesh_.corners.size());
        out_.kind = mesh_.kind;
        out_.first.resize(std::size_t{cells} + 1);
        out_.cell_of.resize(facets);
        for (Id c = 0; c <= cells; ++c)
            out_.first[c] = mesh_.kind == CellKind::tet  ? 4 * c
                            : mesh_.corner_begin.empty() ? 0
                                                         : static_cast<Id>(mesh_.corner_begin[c]);
        for (Id c = 0; c < cells; ++c)
            for (Id f = out_.first[c]; f < out_.first[c + 1]; ++f) out_.cell_of[f] = c;
        out_.twin.assign(facets, kNone);
        out_.flipped.assign(cells, 0);
    }

    FacetKey key_of(Id facet) const {
        FacetKey key;
        if (mesh_.kind == CellKind::tet) {
            const Id base = facet & ~Id{3};
            const auto& local = kTetFacets[facet & 3];
            for (std::size_t i = 0; i < 3; ++i)
                key.points[i] = point_at(base + static_cast<Id>(local[i]));
            auto& p = key.points;
            if (p[0] > p[1]) std::swap(p[0], p[1]), key.odd = !key.odd;
            if (p[1] > p[2]) std::swap(p[1], p[2]), key.odd = !key.odd;
            if (p[0] > p[1]) std::swap(p[0], p[1]), key.odd = !key.odd;
            key.degenerate = p[0] == p[1] || p[1] == p[2];
        } else {
            key.points[0] = point_at(facet);
            key.points[1] = point_at(out_.next_in_cell(facet));
            if (key.points[0] > key.points[1])
                std::swap(key.points[0], key.points[1]), key.odd = true;
            key.degenerate = key.points[0] == key.points[1];
        }
        return key;
    }

    void glue_equal_facets() {
        struct Entry {
            Id second, third, facet;
            bool odd;
        };
        const auto facets = static_cast<Id>(out_.twin.size());
        std::vector<Id> begin(mesh_.point_count() + 1, 0);
        for (Id f = 0; f < facets; ++f)
            if (const FacetKey key = key_of(f); !key.degenerate) ++begin[key.points[0] + 1];
        for (std::size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
        std::vector<Entry> entries(begin.back());
        std::vector<Id> cursor(begin.begin(), begin.end() - 1);
        for (Id f = 0; f < facets; ++f)
            if (const FacetKey key = key_of(f); !key.degenerate)
                entries[cursor[key.points[0]]++] = {key.points[1], key.points[2], f, key.odd};
        odd_.assign(facets, 0);
        for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
            const auto from = entries.begin() + begin[p], to = entries.begin() + begin[p + 1];
            std::sort(from, to, [](const Entry& a, const Entry& b) {
                if (a.second != b.second) return a.second < b.second;
                return a.third != b.third ? a.third < b.third : a.facet < b.facet;
            });
            for (auto run = from; run != to;) {
                auto end = run;
                group_.clear();
                for (; end != to && end->second == run->second && end->third == run->third; ++end) {
                    group_.push_back(end->facet);
                    odd_[end->facet] = end->odd;
                }
                glue_group();
                run = end;
            }
        }
    }

    // Facets with the same points. Two are glued as they are. Of more, pairs that already run in
    // opposite directions are glued, first come first served, but not a cell with its own double;
    // of tets only one pair, so that the points of a facet name at most one gluing.
    void glue_group() {
        if (group_.size() == 2) {
            if (out_.cell_of[group_[0]] != out_.cell_of[group_[1]]) glue(group_[0], group_[1]);
            return;
        }
        for (std::size_t i = 1; i < group_.size(); ++i)
            for (std::size_t j = i; j-- > 0 && i - j < 16;) {
                const Id a = group_[j], b = group_[i];
                if (out_.twin[a] != kNone || odd_[a] == odd_[b]) continue;
                if (out_.cell_of[a] == out_.cell_of[b] ||
                    same_points(out_.cell_of[a], out_.cell_of[b]))
                    continue;
                glue(a, b);
                if (mesh_.kind == CellKind::tet) return;
                break;
            }
    }

    bool same_points(Id a, Id b) const {
        if (out_.degree(a) != out_.degree(b)) return false;
        for (Id i = out_.first[a]; i < out_.first[a + 1]; ++i) {
            bool found = false;
            for (Id j = out_.first[b]; j < out_.first[b + 1] && !found; ++j)
                found = point_at(i) == point_at(j);
            if (!found) return false;
        }
        return true;
    }

    void glue(Id a, Id b) {
        out_.twin[a] = b;
        out_.twin[b] = a;
    }
    void cut(Id facet) {
        if (out_.twin[facet] == kNone) return;
        out_.twin[out_.twin[facet]] = kNone;
        out_.twin[facet] = kNone;
    }

    // Flips cells so that glued facets run in opposite directions; where a loop contradicts itself
    // (Moebius) the facet that closes it is cut.
    void orient() {
        const Id cells = out_.cell_count();
        std::vector<std::uint8_t> seen(cells, 0);
        std::vector<Id> queue;
        for (Id seed = 0; seed < cells; ++seed) {
            if (seen[seed]) continue;
            seen[seed] = 1;
            queue.assign(1, seed);
            std::size_t flips = 0;
            for (std::size_t head = 0; head < queue.size(); ++head) {
                const Id cell = queue[head];
                flips += out_.flipped[cell];
                for (Id f = out_.first[cell]; f < out_.first[cell + 1]; ++f) {
                    const Id g = out_.twin[f];
                    if (g == kNone) continue;
                    const Id other = out_.cell_of[g];
                    const std::uint8_t want = out_.flipped[cell] ^ (odd_[f] == odd_[g] ? 1 : 0);
                    if (!seen[other]) {
                        seen[other] = 1;
                        out_.flipped[other] = want;
                        queue.push_back(other);
                    } else if (out_.flipped[other] != want) {
                        cut(f);
                    }
                }
            }
            if (2 * flips > queue.size())
                for (Id cell : queue) out_.flipped[cell] ^= 1;
        }
    }

    Id root_of(Id corner) {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }
    void join(Id a, Id b) {
        a = root_of(a), b = root_of(b);
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }

    void join_corners() {
        parent_.resize(out_.twin.size());
        for (Id i = 0; i < parent_.size(); ++i) parent_[i] = i;
        for (Id f = 0; f < out_.twin.size(); ++f) {
            const Id g = out_.twin[f];
            if (g == kNone || g < f) continue;
            if (mesh_.kind == CellKind::tet) {
                for (Id i = f & ~Id{3}; i < (f & ~Id{3}) + 4; ++i)
                    for (Id j = g & ~Id{3}; i != f && j < (g & ~Id{3}) + 4; ++j)
                        if (j != g && point_at(i) == point_at(j)) join(i, j);
            } else {
                const Id f2 = out_.next_in_cell(f), g2 = out_.next_in_cell(g);
                const bool opposite = point_at(f) == point_at(g2);
                join(f, opposite ? g2 : g);
                join(f2, opposite ? g : g2);
            }
        }
    }

    bool repeats_a_point(Id cell) {
        const Id begin = out_.first[cell], end = out_.first[cell + 1];
        if (end - begin == 4) {
            const Id a = point_at(begin), b = point_at(begin + 1), c = point_at(begin + 2),
                     d = point_at(begin + 3);
            return a == b || a == c || a == d || b == c || b == d || c == d;
        }
        scratch_.clear();
        for (Id i = begin; i < end; ++i) scratch_.push_back(point_at(i));
        std::sort(scratch_.begin(), scratch_.end());
        return std::adjacent_find(scratch_.begin(), scratch_.end()) != scratch_.end();
    }

    // Only a cell that repeats a point can do so; it becomes a component of its own. Quadratic in
    // the degree of such cells alone.
    bool isolate_cells_meeting_a_vertex_twice() {
        bool any = false;
        for (Id c = 0; c < out_.cell_count(); ++c) {
            if (!repeats_a_point(c)) continue;
            scratch_.clear();
            for (Id i = out_.first[c]; i < out_.first[c + 1]; ++i) scratch_.push_back(root_of(i));
            std::sort(scratch_.begin(), scratch_.end());
            if (std::adjacent_find(scratch_.begin(), scratch_.end()) == scratch_.end()) continue;
            for (Id f = out_.first[c]; f < out_.first[c + 1]; ++f) cut(f);
            any = true;
        }
        return any;
    }

    void name_vertices() {
        out_.vertex.resize(parent_.size());
        for (Id i = 0; i < parent_.size(); ++i) {
            const Id root = root_of(i);  // the smallest corner of its vertex
            if (root == i) {
                out_.vertex[i] = static_cast<Id>(out_.point.size());
                out_.point.push_back(point_at(i));
            } else {
                out_.vertex[i] = out_.vertex[root];
            }
        }
    }

    void apply_flips() {
        std::vector<Id> moved(out_.twin.size());
        for (Id f = 0; f < moved.size(); ++f) moved[f] = f;
        for (Id c = 0; c < out_.cell_count(); ++c) {
            if (!out_.flipped[c]) continue;
            const auto begin = out_.first[c], end = out_.first[c + 1];
            if (mesh_.kind == CellKind::tet) {
                std::swap(out_.vertex[begin + 2], out_.vertex[begin + 3]);
                std::swap(moved[begin + 2], moved[begin + 3]);
            } else if (begin < end) {
                std::reverse(out_.vertex.begin() + begin + 1, out_.vertex.begin() + end);
                std::reverse(moved.begin() + begin, moved.begin() + end);
            }
        }
        std::vector<Id> twin(out_.twin.size(), kNone);
        for (Id f = 0; f < twin.size(); ++f)
            if (out_.twin[f] != kNone) twin[moved[f]] = moved[out_.twin[f]];
        out_.twin = std::move(twin);
    }

    const Mesh& mesh_;
    Complex& out_;
    std::vector<std::uint8_t> odd_;
    std::vector<Id> group_, parent_, scratch_;
};

}  // namespace

Result<Complex> build_complex(const Mesh& mesh) {
    constexpr Index kMost = Index{kNone} - 1;
    constexpr Index kMostTets = 357913941;  // three edge slots per facet are counted in 32 bits
    if (mesh.corners.size() + mesh.point_count() >= kMost || mesh.cell_count() >= kMost ||
        (mesh.kind == CellKind::tet && mesh.cell_count() >= kMostTets))
        return Error{
            Code::limit_exceeded, mesh.cell_count(),
            "one block holds fewer than 4294967294 points and corners, and 357913941 tets"};
    Complex complex;
    Gluer(mesh, complex).run();
    return complex;
}

}  // namespace ravel
