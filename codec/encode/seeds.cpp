#include "encode/seeds.h"

namespace ravel {
namespace {

Id borders_of(const Complex& complex, Id cell) {
    Id n = 0;
    for (Id f = complex.first[cell]; f < complex.first[cell + 1]; ++f)
        n += complex.twin[f] == kNone;
    return n;
}

// Does the cell's pattern of borders, read from side f on, come before that from side g on?
bool comes_before(const Complex& complex, Id f, Id g) {
    for (Id i = complex.degree(complex.cell_of[f]); i > 0; --i) {
        const bool a = complex.twin[f] == kNone, b = complex.twin[g] == kNone;
        if (a != b) return b;
        f = complex.next_in_cell(f);
        g = complex.next_in_cell(g);
    }
    return false;
}

Id first_facet(const Complex& complex, Id cell) {
    const Id begin = complex.first[cell], end = complex.first[cell + 1];
    if (begin == end) return kNone;
    if (complex.kind == CellKind::tet) {
        // The last corner lies opposite the facet that is never left: a border where there is one.
        for (Id f = end; f-- > begin;)
            if (complex.twin[f] == kNone) return f;
        return end - 1;
    }
    // A polygon of many corners is not worth comparing all its turns.
    constexpr Id kMostTurns = 16;
    Id best = begin;
    if (end - begin <= kMostTurns)
        for (Id f = begin + 1; f < end; ++f)
            if (comes_before(complex, f, best)) best = f;
    return best;
}

}  // namespace

std::vector<Seed> choose_seeds(const Complex& complex) {
    std::vector<Seed> seeds;
    std::vector<std::uint8_t> seen(complex.cell_count(), 0);
    std::vector<Id> part;
    for (Id start = 0; start < complex.cell_count(); ++start) {
        if (seen[start]) continue;
        seen[start] = 1;
        part.assign(1, start);
        Id best = start, most = borders_of(complex, start);
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Id cell = part[i];
            const Id borders = borders_of(complex, cell);
            if (borders > most || (borders == most && cell < best)) best = cell, most = borders;
            for (Id f = complex.first[cell]; f < complex.first[cell + 1]; ++f) {
                if (complex.twin[f] == kNone) continue;
                const Id other = complex.cell_of[complex.twin[f]];
                if (seen[other]) continue;
                seen[other] = 1;
                part.push_back(other);
            }
        }
        seeds.push_back({best, first_facet(complex, best)});
    }
    return seeds;
}

}  // namespace ravel
