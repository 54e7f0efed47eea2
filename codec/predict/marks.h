// Companions that are parts of the mesh: triangles that are facets of tets, lines that are sides of
// polygons or edges of a tet mesh's border, points that are corners. They are marks: a yes or no
// for each candidate in the order of the walk, under contexts of the marks beside it. On either
// side: `Coder` writes or reads.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "mesh/flatness.h"
#include "predict/attribute_contexts.h"
#include "predict/ground.h"

namespace ravel {

// What can be marked, by the number of nodes.
inline constexpr std::uint16_t kMarkTypes[4] = {0, 1, 3, 5};  // VTK's point, line and triangle

struct Mark {
    std::array<Id, 3> nodes{};  // points, as many as there are; turned as the companion is
    Id block = 0;
    Id facet = kNone;  // that it is, of the earlier cell; none for edges of tets and points
    bool reversed = false;
};

// What the writer knows: is a companion left that has these nodes?
class MarkTruth {
  public:
    virtual ~MarkTruth() = default;
    virtual bool take(const std::array<Id, 3>&, std::uint32_t, Mark&) { return false; }
};

// A block of companions and how many of them are marks; those of `nodes` nodes are asked for
// together.
struct MarkBlock {
    std::uint32_t nodes = 0;
    Index marks = 0;
};

template <class Coder, class Walk>
class MarkCodes {
  public:
    MarkCodes(Coder& coder, const Ground<Walk>& ground, const std::vector<MarkBlock>& blocks,
              MarkTruth* truth)
        : coder_(coder), ground_(ground), walk_(ground.walk), blocks_(blocks), truth_(truth) {}

    // False: no encoder writes this.
    bool run() {
        Id points = 0;
        for (const Id p : ground_.point) points = std::max(points, p + 1);
        ends_.assign(points, {});
        const bool tets = walk_.kind == CellKind::tet;
        for (const std::uint32_t nodes : {3u, 2u, 1u}) {
            begin(nodes);
            if (left_ == 0) continue;
            if (nodes == 3 && tets) facets();
            if (nodes == 2) tets ? edges() : sides();
            if (nodes == 1) corners(points);
            sane_ = sane_ && left_ == 0;
        }
        return sane_;
    }
    const std::vector<Mark>& marks() const { return marks_; }

  private:
    // Of lines (or facets) so far at a point.
    struct Ends {
        std::uint8_t facets = 0, lines = 0;  // facets: of this pass
        std::int8_t flow = 0;                // lines that end here less those that start
        bool border = false;
    };

    // Begins the marks of so many nodes.
    void begin(std::uint32_t nodes) {
        open_.clear();
        left_ = 0;
        last_block_ = 0;
        for (Id b = 0; b < blocks_.size(); ++b) {
            if (blocks_[b].nodes != nodes || blocks_[b].marks == 0) continue;
            open_.push_back(b);
            left_ += blocks_[b].marks;
        }
        nodes_ = nodes;
    }

    bool earlier(Id facet) const { return walk_.twin[facet] == kNone || facet < walk_.twin[facet]; }

    // What lies about a candidate.
    struct About {
        std::uint32_t marked = 0, unmarked = 0, flat = 0;
        bool found = false, reversed = false;  // how the straightest mark beside it is turned
        Id block = 0;
    };

    // Asks for a candidate; `nodes` as it is turned.
    bool ask(Context context, std::array<Id, 3> nodes, Id facet, const About& about) {
        Mark mark{nodes, 0, facet, false};
        bool yes = false;
        if constexpr (Coder::kWrites) yes = truth_->take(nodes, nodes_, mark);
        if (!coder_.flag(context, yes)) return false;
        mark.block = code_block(about, mark.block);
        if (nodes_ > 1) {
            const bool turned =
                coder_.flag(AttributeContexts::mark_turn.at(nodes_ - 2, about.found, last_turn_),
                            mark.reversed != about.reversed);
            mark.reversed = turned != about.reversed;
            last_turn_ = turned;
        }
        mark.nodes = nodes;
        if (mark.reversed) std::swap(mark.nodes[0], mark.nodes[1]);
        marks_.push_back(mark);
        --left_;
        return true;
    }
    Id code_block(const About& about, Id truth) {
        if (open_.size() == 1) return open_[0];
        const auto is = [&](Id block, std::uint32_t how) {
            return coder_.flag(AttributeContexts::mark_block.at(how), truth == block);
        };
        if (about.found && is(about.block, 0)) return last_block_ = about.block;
        const Id last = std::max(last_block_, open_[0]);
        if ((!about.found || last != about.block) && is(last, about.found ? 1 : 2))
            return last_block_ = last;
        const auto at = std::lower_bound(open_.begin(), open_.end(), truth) - open_.begin();
        const std::uint64_t i = coder_.plain(Coder::kWrites ? static_cast<std::uint64_t>(at) : 0,
                                             static_cast<int>(std::bit_width(open_.size() - 1)));
        sane_ = sane_ && i < open_.size();
        return last_block_ = open_[sane_ ? i : 0];
    }

    // --- triangles of a tet mesh -----------------------------------------------------------------

    std::array<Id, 3> nodes_of(Id facet) const {
        std::array<Id, 3> nodes{};
        for (std::size_t k = 0; k < 3; ++k)
            nodes[k] = ground_.point_at((facet & ~Id{3}) + kOutwardCorners[facet & 3][k]);
        return nodes;
    }
    // Those of the border come first: mostly they are all that is marked.
    void facets() {
        marked_.assign(walk_.twin.size(), 0);
        for (const bool border : {true, false}) {
            first_of_pass_ = marks_.size();
            inside_ = !border;
            for (Ends& end : ends_) end.facets = 0;
            for (Id f = 0; f < walk_.twin.size() && left_ > 0; ++f)
                if ((walk_.twin[f] == kNone) == border && earlier(f)) ask_facet(f);
        }
    }
    void ask_facet(Id f) {
        const std::array<Id, 3> nodes = nodes_of(f);
        std::uint32_t touched = 0;
        for (const Id p : nodes) touched += ends_[p].facets;
        About about;
        if (!inside_ || touched > 1) look_about(f, about);
        if (!ask(AttributeContexts::mark_facet.at(!inside_, about.marked, about.unmarked,
                                                  about.flat),
                 nodes, f, about))
            return;
        marked_[f] = 1;
        for (const Id p : nodes) ends_[p].facets = 1;
    }
    // Of a marked facet of the earlier cell. Each pass leaves its marks in the order of facets.
    const Mark& mark_of(Id facet) const {
        const auto pass = marks_.begin() + static_cast<std::ptrdiff_t>(first_of_pass_);
        const bool now = (walk_.twin[facet] != kNone) == inside_;
        return *std::lower_bound(now ? pass : marks_.begin(), now ? marks_.end() : pass, facet,
                                 [](const Mark& m, Id f) { return m.facet < f; });
    }
    // The facets met when turning about the edges, first from the facet's own cell, then from the
    // other side. As seen from between them, marks that go on straight have equal normals.
    void look_about(Id f, About& about) const {
        for (const Id side : {f, walk_.twin[f]}) {
            if (side == kNone) continue;
            const Point3 normal = ground_.normal_of(side);
            for (Id local = 0; local < 4; ++local) {
                if (local == (side & 3)) continue;
                ground_.turn_about_edge(
                    side, local, [](Id) { return true; },
                    [&](Id g) {
                        const Id other = walk_.twin[g], first = std::min(g, other);
                        if (first >= f && (other == kNone) != inside_) return true;
                        if (!marked_[first]) {
                            about.unmarked += other == kNone;
                            return true;
                        }
                        ++about.marked;
                        const std::uint32_t flat = flatness(normal, ground_.normal_of(g));
                        if (flat <= about.flat) return false;
                        about.flat = flat;
                        const Mark& mark = mark_of(first);
                        about.found = true;
                        about.block = mark.block;
                        about.reversed = mark.reversed != ((g != first) != (side != f));
                        return false;
                    });
            }
        }
    }

    // --- lines -----------------------------------------------------------------------------------

    void sides() {
        for (Id f = 0; f < walk_.twin.size() && left_ > 0; ++f) {
            if (!earlier(f)) continue;
            const Id g = walk_.twin[f];
            const std::uint32_t flat = g == kNone ? 0 : flatness(normal_at(f), normal_at(g));
            ask_line(ground_.point_at(f), ground_.point_at(walk_.next_in_cell(f)), f, flat);
        }
    }
    // Of a polygon at one of its sides.
    Point3 normal_at(Id side) const {
        const Point3 a = ground_.place_of_corner(side),
                     b = ground_.place_of_corner(walk_.next_in_cell(side)),
                     c = ground_.place_of_corner(walk_.next_in_cell(walk_.next_in_cell(side)));
        return cross(minus(b, a), minus(c, a));
    }
    void edges() {
        for (Id f = 0; f < walk_.twin.size() && left_ > 0; ++f) {
            if (walk_.twin[f] != kNone) continue;
            const std::array<Id, 3> nodes = nodes_of(f);
            for (std::size_t k = 0; k < 3 && left_ > 0; ++k) {
                // The edge that starts at node k lies opposite the node before.
                Id across = kNone;
                ground_.turn_about_edge(
                    f, kOutwardCorners[f & 3][(k + 2) % 3], [](Id) { return true; },
                    [&](Id g) {
                        if (walk_.twin[g] == kNone) across = g;
                        return true;
                    });
                if (across < f) continue;
                const std::uint32_t flat =
                    across == kNone ? 0 : flatness(ground_.normal_of(f), ground_.normal_of(across));
                ask_line(nodes[k], nodes[(k + 1) % 3], kNone, flat);
            }
        }
    }
    void ask_line(Id p, Id q, Id facet, std::uint32_t flat) {
        About about;
        Ends &a = ends_[p], &b = ends_[q];
        about.found = a.flow != 0 || b.flow != 0;
        about.reversed = a.flow < 0 || b.flow > 0;
        about.block = last_block_;
        const std::uint32_t more = std::max(a.lines, b.lines), less = std::min(a.lines, b.lines);
        if (!ask(AttributeContexts::mark_line.at(flat, more, less), {p, q, 0}, facet, about))
            return;
        for (Ends* end : {&a, &b})
            end->lines = static_cast<std::uint8_t>(end->lines < 3 ? end->lines + 1 : 3);
        const bool turned = marks_.back().reversed;
        a.flow = static_cast<std::int8_t>(turned ? 1 : -1);
        b.flow = static_cast<std::int8_t>(turned ? -1 : 1);
    }

    // --- points ----------------------------------------------------------------------------------

    void corners(Id points) {
        for (Id f = 0; f < walk_.twin.size(); ++f) {
            if (walk_.twin[f] != kNone) continue;
            if (walk_.kind == CellKind::tet)
                for (const Id p : nodes_of(f)) ends_[p].border = true;
            else
                ends_[ground_.point_at(f)].border = true;
        }
        for (Id p = 0; p < points && left_ > 0; ++p) {
            About about;
            ask(AttributeContexts::mark_point.at(ends_[p].lines, ends_[p].border), {p, 0, 0}, kNone,
                about);
        }
    }

    Coder& coder_;
    const Ground<Walk>& ground_;
    const Walk& walk_;
    const std::vector<MarkBlock>& blocks_;
    MarkTruth* const truth_;
    std::vector<Id> open_;  // blocks whose marks are asked for, ascending
    Index left_ = 0;        // marks still to come
    std::uint32_t nodes_ = 0;
    Id last_block_ = 0;
    bool last_turn_ = false, sane_ = true;
    std::vector<Mark> marks_;
    std::size_t first_of_pass_ = 0;     // of the facets' marks
    bool inside_ = false;               // the pass: facets that are no border
    std::vector<std::uint8_t> marked_;  // per facet of the earlier cell
    std::vector<Ends> ends_;            // per point that a cell has
};

}  // namespace ravel
