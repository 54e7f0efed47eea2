// The split of two polygons at a shared side, the paper's six-vertex split [DiazGopi2005, 3.2] for
// n-gons. Side 0 is the shared one, from v0 to v1; it gets vertices w1 near v1 and wn near v0; v2
// .. v(n-1) get inner vertices w2 .. w(n-1). Outer quad Oi = vi v(i+1) w(i+1) wi lies on side i = 1
// .. n-1, and the inner polygon I = wn w1 w2 .. w(n-1) touches all of them. The strip enters at Op,
// leaves at Oq, visits all pieces and passes between O1 and I; there it is toggled with the
// neighbour's, seen in a mirror, so that both have the same v1 and w1. Where one inner polygon is
// not enough (p and q apart, q not last) it is cut in two from wn.
// Cost: linear in the corners.
#include <algorithm>
#include <array>

#include "strip/split.h"

namespace ravel {
namespace {

// A polygon seen from its shared side, counter-clockwise or in a mirror.
struct View {
    const SplitMesh* mesh = nullptr;
    Id link = kNone;
    bool mirrored = false;

    Id cell() const { return mesh->cell_of[link]; }
    Id sides() const { return mesh->degree(cell()); }
    // The facet of side i of the view.
    Id side(Id i) const {
        const Id base = mesh->first[cell()], n = sides();
        return base + (mirrored ? link - base + n - i : link - base + i) % n;
    }
    Id vertex(Id i) const {
        const Id base = mesh->first[cell()], n = sides(), f = side(i % n);
        return mesh->vertex[mirrored ? base + (f - base + 1) % n : f];
    }
};

struct Ends {
    Id count = 0;
    Id p = 0, q = 0;  // sides of the view with a strip, p < q
    bool needs_two_inner(Id sides) const { return count == 2 && q != p + 1 && q != sides - 1; }
};

Ends strip_ends(const View& view) {
    Ends ends;
    for (Id i = 1; i < view.sides(); ++i) {
        if (view.mesh->role[view.side(i)] != FacetRole::strip) continue;
        (ends.count++ == 0 ? ends.p : ends.q) = i;
    }
    return ends;
}

// The pieces of one polygon; facets are numbered as in the view.
class Pieces {
  public:
    Pieces(SplitMesh& mesh, const View& view, Id near, Id far)
        : mesh_(mesh),
          view_(view),
          n_(view.sides()),
          ends_(strip_ends(view)),
          near_(near),
          far_(far) {}

    void split() {
        place_inner_vertices();
        cut_inner();
        add_pieces();
        glue_pieces();
        route();
    }

    Id near_third() const { return facet(outer_[1], 3); }
    Id far_third() const { return facet(outer_[n_ - 1], 1); }
    Id middle() const { return facet(inner_[0], 0); }

  private:
    // Facet i of the view of a piece: mirrored pieces have their corners stored backwards.
    Id facet(Id cell, Id i) const {
        const Id m = mesh_.degree(cell);
        return mesh_.first[cell] + (view_.mirrored ? (2 * m - 2 - i) % m : i);
    }

    // Halfway to a point near the middle of the shared side: convex pieces in a convex polygon.
    void place_inner_vertices() {
        w_.assign(n_ + 1, far_);
        w_[1] = near_;
        std::vector<Blend> parts(n_);
        const double share = 0.25 / n_;
        for (Id j = 2; j < n_; ++j) {
            for (Id i = 0; i < n_; ++i) parts[i] = {view_.vertex(i), share + (i < 2 ? 0.125 : 0)};
            std::swap(parts[0], parts[j]);
            parts[0].weight += 0.5;
            w_[j] = add_vertex(mesh_, parts);
        }
    }

    // Where two inner polygons are needed they meet in the line from wn to w(cut_), or, where p and
    // q have one side between them, to an extra vertex in the middle of that side's inner edge.
    void cut_inner() {
        cut_ = n_;
        if (!ends_.needs_two_inner(n_)) return;
        cut_ = ends_.p + 2;
        if (ends_.q > ends_.p + 2) return;
        const std::array<Blend, 2> parts{{{w_[cut_ - 1], 0.5}, {w_[cut_], 0.5}}};
        extra_ = add_vertex(mesh_, parts);
    }

    Id add(std::vector<Id>& vertices) {
        if (view_.mirrored) std::reverse(vertices.begin(), vertices.end());
        return add_cell(mesh_, vertices, mesh_.parent[view_.cell()]);
    }

    void add_pieces() {
        std::vector<Id> side(n_), v(n_ + 1), corners;
        for (Id i = 0; i < n_; ++i) side[i] = view_.side(i);
        for (Id i = 0; i <= n_; ++i) v[i] = view_.vertex(i);
        outer_.assign(n_, kNone);
        for (Id i = 1; i < n_; ++i) {
            corners = {v[i], v[i + 1], w_[i + 1]};
            if (extra_ != kNone && i + 1 == cut_) corners.push_back(extra_);
            corners.push_back(w_[i]);
            outer_[i] = add(corners);
            take_over(mesh_, side[i], facet(outer_[i], 0));
        }
        corners = {far_};
        for (Id i = 1; i < cut_; ++i) corners.push_back(w_[i]);
        if (cut_ < n_) corners.push_back(extra_ != kNone ? extra_ : w_[cut_]);
        inner_[0] = add(corners);
        if (cut_ == n_) return;
        corners = {far_};
        if (extra_ != kNone) corners.push_back(extra_);
        for (Id i = cut_; i < n_; ++i) corners.push_back(w_[i]);
        inner_[1] = add(corners);
    }

    void glue_pieces() {
        for (Id i = 1; i + 1 < n_; ++i)
            glue(mesh_, facet(outer_[i], 1), facet(outer_[i + 1], mesh_.degree(outer_[i + 1]) - 1));
        if (cut_ == n_) {
            for (Id i = 1; i < n_; ++i) glue(mesh_, facet(outer_[i], 2), facet(inner_[0], i));
            return;
        }
        const bool shared = extra_ != kNone;  // outer polygon cut_ - 1 touches both
        for (Id i = 1; i < cut_; ++i) {
            const bool both = shared && i + 1 == cut_;
            glue(mesh_, facet(outer_[i], both ? 3 : 2), facet(inner_[0], i));
            if (both) glue(mesh_, facet(outer_[i], 2), facet(inner_[1], 1));
        }
        for (Id i = cut_; i < n_; ++i)
            glue(mesh_, facet(outer_[i], 2), facet(inner_[1], i - cut_ + (shared ? 2 : 1)));
        glue(mesh_, facet(inner_[0], cut_), facet(inner_[1], 0));
    }

    void visit_outer(Id from, Id to) {
        for (Id i = from;; from < to ? ++i : --i) {
            route_.push_back(outer_[i]);
            if (i == to) return;
        }
    }

    void route() {
        route_.clear();
        if (ends_.count == 0) {
            // A ring that already is open between O1 and I.
            visit_outer(1, n_ - 1);
            route_.push_back(inner_[0]);
        } else if (cut_ < n_) {
            visit_outer(ends_.p, 1);
            route_.push_back(inner_[0]);
            visit_outer(ends_.p + 1, ends_.q - 1);
            route_.push_back(inner_[1]);
            visit_outer(n_ - 1, ends_.q);
        } else {
            visit_outer(ends_.p, 1);
            route_.push_back(inner_[0]);
            if (ends_.count == 2 && ends_.q != ends_.p + 1) {
                visit_outer(ends_.p + 1, n_ - 1);
            } else if (ends_.p + 1 < n_) {
                visit_outer(n_ - 1, ends_.p + 1);
            }
        }
        for (std::size_t i = 0; i + 1 < route_.size(); ++i) {
            const bool toggled =
                ends_.count > 0 && route_[i] == outer_[1] && route_[i + 1] == inner_[0];
            if (!toggled) connect(route_[i], route_[i + 1]);
        }
    }

    void connect(Id a, Id b) {
        for (Id f = mesh_.first[a]; f < mesh_.first[a + 1]; ++f) {
            if (mesh_.twin[f] == kNone || mesh_.cell_of[mesh_.twin[f]] != b) continue;
            set_role(mesh_, f, FacetRole::strip);
            return;
        }
    }

    SplitMesh& mesh_;
    const View view_;
    const Id n_;
    const Ends ends_;
    const Id near_, far_;
    std::vector<Id> w_;      // 1 .. n
    std::vector<Id> outer_;  // 1 .. n - 1
    std::array<Id, 2> inner_{kNone, kNone};
    std::vector<Id> route_;
    Id cut_ = 0;
    Id extra_ = kNone;
};

}  // namespace

bool split_polygons(SplitMesh& mesh, Id link) {
    const Id twin = mesh.twin[link];
    // One of the two is seen in the mirror: the way that needs fewer inner polygons.
    const auto inner_cuts = [&](Id facet, bool mirrored) {
        const View view{&mesh, facet, mirrored};
        return static_cast<int>(strip_ends(view).needs_two_inner(view.sides()));
    };
    const bool mirror = inner_cuts(link, true) + inner_cuts(twin, false) <
                        inner_cuts(link, false) + inner_cuts(twin, true);
    const View a{&mesh, link, mirror}, b{&mesh, twin, !mirror};
    if (a.sides() < 2 || b.sides() < 2) return false;
    const Id v0 = a.vertex(0), v1 = a.vertex(1);
    const std::array<Blend, 2> near_parts{{{v1, 2.0 / 3}, {v0, 1.0 / 3}}};
    const std::array<Blend, 2> far_parts{{{v0, 2.0 / 3}, {v1, 1.0 / 3}}};
    const Id near = add_vertex(mesh, near_parts);
    const Id far = add_vertex(mesh, far_parts);
    Pieces pieces_a(mesh, a, near, far), pieces_b(mesh, b, near, far);
    pieces_a.split();
    pieces_b.split();
    glue(mesh, pieces_a.near_third(), pieces_b.near_third());
    glue(mesh, pieces_a.far_third(), pieces_b.far_third());
    glue(mesh, pieces_a.middle(), pieces_b.middle());
    set_role(mesh, pieces_a.near_third(), FacetRole::strip);
    set_role(mesh, pieces_a.middle(), FacetRole::strip);
    return true;
}

}  // namespace ravel
