#include "ravel/strip_of_steps.h"

#include <string>

namespace ravel::tool {
namespace {

// A flipped cell lists its corners in another order than the mesh does, and so its facets.
Id facet_of(const Complex& complex, Id cell, std::uint32_t facet) {
    const Id first = complex.first[cell], degree = complex.degree(cell);
    if (!complex.flipped[cell]) return first + facet;
    if (complex.kind == CellKind::tet) return first + (facet < 2 ? facet : 5 - facet);
    return first + (degree - 1 - facet);
}

Error misfit(Index cell) {
    return {Code::corrupt, cell,
            "the strip's step to cell " + std::to_string(cell) + " leads elsewhere"};
}

// Glues the loop's last cell back to its first, by a facet no strip uses yet.
bool close_loop(const Complex& complex, Strip& strip, Id last, Id first) {
    if (last == first) return false;
    for (Id f = complex.first[last]; f < complex.first[last + 1]; ++f) {
        const Id twin = complex.twin[f];
        if (twin == kNone || complex.cell_of[twin] != first || strip.role[f] != FacetRole::none)
            continue;
        strip.role[f] = strip.role[twin] = FacetRole::strip;
        return true;
    }
    return false;
}

}  // namespace

Result<Strip> strip_of_steps(const Complex& complex, const std::vector<StripStep>& steps) {
    const Id cells = complex.cell_count();
    if (steps.size() != cells)
        return Error{Code::corrupt, steps.size(), "one step per cell is needed"};
    Strip strip;
    strip.role.assign(complex.twin.size(), FacetRole::none);
    std::vector<Id> last(cells, kNone);   // first cell of a strip -> its last
    std::vector<Id> start(cells, kNone);  // visited cell -> first cell of its strip
    for (const StripStep& step : steps) {
        if (step.cell >= cells) return misfit(step.cell);
        const Id cell = static_cast<Id>(step.cell);
        if (start[cell] != kNone) return misfit(cell);
        if (step.from == kNoIndex) {
            strip.roots.push_back(cell);
            start[cell] = last[cell] = cell;
            continue;
        }
        if (step.from >= cells || step.entry >= complex.degree(cell)) return misfit(cell);
        const Id from = static_cast<Id>(step.from);
        if (start[from] == kNone || step.exit >= complex.degree(from)) return misfit(cell);
        const Id out = facet_of(complex, from, step.exit), in = facet_of(complex, cell, step.entry);
        if (complex.twin[out] != in || strip.role[out] != FacetRole::none) return misfit(cell);
        strip.role[out] = strip.role[in] = step.link ? FacetRole::link : FacetRole::strip;
        if (step.link) {
            start[cell] = last[cell] = cell;
            ++strip.counts.links;
        } else {
            start[cell] = start[from];
            last[start[cell]] = cell;
        }
    }
    for (const StripStep& step : steps) {
        const Id cell = static_cast<Id>(step.cell);
        if (start[cell] != cell) continue;
        const bool alone = last[cell] == cell;
        const bool closed = close_loop(complex, strip, last[cell], cell);
        if (!alone && !closed && step.from != kNoIndex) return misfit(cell);
        strip.counts.open_strips += !alone && !closed;
    }
    strip.counts.components = strip.counts.strips = strip.roots.size();
    return strip;
}

}  // namespace ravel::tool
