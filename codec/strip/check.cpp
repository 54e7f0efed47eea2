// Shares nothing with the makers: roles are read off facets, strips are traced and the tree is
// counted: a component of s strips is a tree when its links connect them and number s - 1.
// Cost: linear.
#include "strip/check.h"

#include <string>

namespace ravel {
namespace {

Error wrong(std::uint64_t at, const std::string& detail) {
    return {Code::corrupt, at, detail};
}

// Labels cells that hang together by facets whose role `passes`; gives the number of labels.
template <class Passes>
Id label(const Complex& complex, std::vector<Id>& of, Passes passes) {
    of.assign(complex.cell_count(), kNone);
    Id count = 0;
    std::vector<Id> queue;
    for (Id seed = 0; seed < complex.cell_count(); ++seed) {
        if (of[seed] != kNone) continue;
        of[seed] = count;
        queue.assign(1, seed);
        for (std::size_t i = 0; i < queue.size(); ++i) {
            for (Id f = complex.first[queue[i]]; f < complex.first[queue[i] + 1]; ++f) {
                if (complex.twin[f] == kNone || !passes(f)) continue;
                const Id next = complex.cell_of[complex.twin[f]];
                if (of[next] != kNone) continue;
                of[next] = count;
                queue.push_back(next);
            }
        }
        ++count;
    }
    return count;
}

}  // namespace

Status check_strip(const Complex& complex, const Strip& strip) {
    const Id cells = complex.cell_count();
    if (strip.role.size() != complex.twin.size()) return wrong(0, "not one role per facet");
    std::vector<Id> edges(cells, 0);  // strip facets of a cell
    for (Id f = 0; f < complex.twin.size(); ++f) {
        const Id g = complex.twin[f];
        if (strip.role[f] != (g == kNone ? FacetRole::none : strip.role[g]))
            return wrong(f, "facet " + std::to_string(f) + " and its twin differ in role");
        if (strip.role[f] == FacetRole::strip && ++edges[complex.cell_of[f]] > 2)
            return wrong(complex.cell_of[f], "a cell has more than two strip facets");
    }
    std::vector<Id> part, linked, piece;
    const Id parts = label(complex, part, [](Id) { return true; });
    const Id trees = label(complex, linked, [&](Id f) { return strip.role[f] != FacetRole::none; });
    if (trees != parts) return wrong(0, "links leave a component in pieces");
    const Id pieces =
        label(complex, piece, [&](Id f) { return strip.role[f] == FacetRole::strip; });

    std::vector<Id> links(parts, 0), strips(parts, 0), root(parts, kNone), ends(pieces, 0);
    std::vector<std::uint8_t> counted(pieces, 0);
    for (Id f = 0; f < complex.twin.size(); ++f)
        if (strip.role[f] == FacetRole::link && f < complex.twin[f])
            ++links[part[complex.cell_of[f]]];
    for (Id c = 0; c < cells; ++c) {
        if (counted[piece[c]] == 0) ++strips[part[c]];
        counted[piece[c]] = 1;
        ends[piece[c]] += edges[c] == 1;
    }
    if (strip.roots.size() != parts) return wrong(0, "not one root per component");
    for (const Id r : strip.roots) {
        if (r >= cells) return wrong(r, "a root is no cell");
        if (root[part[r]] != kNone) return wrong(r, "a component has two roots");
        root[part[r]] = r;
    }
    for (Id p = 0; p < parts; ++p)
        if (links[p] + 1 != strips[p]) return wrong(root[p], "strips and links are no tree");
    for (Id c = 0; c < cells; ++c) {
        if (ends[piece[c]] == 0) continue;
        const Id r = root[part[c]];
        if (piece[r] != piece[c]) return wrong(c, "a strip other than the root's is a path");
        if (edges[r] != 1) return wrong(r, "the root of an open strip is not its end");
    }
    return Done{};
}

}  // namespace ravel
