#include "compare/polygon_match.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace ravel::compare {
namespace {

using Place = std::array<std::uint64_t, 3>;
using Digest = std::array<std::uint64_t, 2>;

std::vector<Place> places_of(const Mesh& mesh, const std::optional<Grid>& grid, bool decoded) {
    std::vector<Place> places(mesh.point_count());
    for (Index p = 0; p < places.size(); ++p)
        for (int k = 0; k < 3; ++k) {
            const double x = coordinate(mesh, p, k);
            std::uint64_t& place = places[p][static_cast<std::size_t>(k)];
            if (!grid)
                place = std::bit_cast<std::uint64_t>(x);
            else if (!decoded)
                place = grid_number(*grid, x, k);
            else
                place = static_cast<std::uint64_t>(
                    std::max(0.0, std::floor((x - grid->origin[k]) / grid->step() + 0.5)));
        }
    return places;
}

// Numbers of places in one sorted list.
std::vector<std::uint64_t> numbers_of(const std::vector<Place>& places,
                                      const std::vector<Place>& sorted) {
    std::vector<std::uint64_t> numbers(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        numbers[i] = static_cast<std::uint64_t>(
            std::lower_bound(sorted.begin(), sorted.end(), places[i]) - sorted.begin());
    return numbers;
}

// Of all rotations the least one.
void turn_to_least(std::vector<std::uint64_t>& cycle) {
    std::size_t best = 0;
    const std::size_t n = cycle.size();
    for (std::size_t start = 1; start < n; ++start)
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint64_t a = cycle[(start + i) % n], b = cycle[(best + i) % n];
            if (a < b) best = start;
            if (a != b) break;
        }
    std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(best), cycle.end());
}

Digest digest_of(const std::vector<std::uint64_t>& cycle) {
    Digest digest{0x9ae16a3b2f90404fu, cycle.size()};
    for (std::uint64_t number : cycle)
        for (std::uint64_t& half : digest) {
            half = (half ^ number) * 0x9e3779b97f4a7c15u;
            half ^= half >> 29;
            half = half * 0xbf58476d1ce4e5b9u + 0x94d049bb133111ebu;
            half ^= half >> 32;
        }
    return digest;
}

std::vector<Digest> digests_of(const Mesh& mesh, const std::vector<std::uint64_t>& numbers) {
    std::vector<Digest> digests;
    digests.reserve(mesh.cell_count());
    std::vector<std::uint64_t> cycle;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        cycle.clear();
        for (Index p : mesh.cell(c)) cycle.push_back(numbers[p]);
        turn_to_least(cycle);
        digests.push_back(digest_of(cycle));
    }
    std::sort(digests.begin(), digests.end());
    return digests;
}

}  // namespace

PolygonMatch match_polygons(const Mesh& original, const Mesh& decoded,
                            const std::optional<Grid>& grid) {
    const std::vector<Place> before = places_of(original, grid, false);
    const std::vector<Place> after = places_of(decoded, grid, true);
    std::vector<Place> sorted = before;
    sorted.insert(sorted.end(), after.begin(), after.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    const std::vector<std::uint64_t> old_numbers = numbers_of(before, sorted);
    const std::vector<std::uint64_t> new_numbers = numbers_of(after, sorted);

    PolygonMatch match;
    const std::vector<Digest> wanted = digests_of(original, old_numbers);
    const std::vector<Digest> got = digests_of(decoded, new_numbers);
    std::vector<Digest> both;
    std::set_intersection(wanted.begin(), wanted.end(), got.begin(), got.end(),
                          std::back_inserter(both));
    match.expected = wanted.size();
    match.found = both.size();
    match.extra = got.size() - both.size();

    std::vector<Index> point_at(sorted.size(), kNoIndex);
    for (Index p = 0; p < new_numbers.size(); ++p) point_at[new_numbers[p]] = p;
    for (Index p = 0; p < old_numbers.size(); ++p) {
        const Index q = point_at[old_numbers[p]];
        if (q == kNoIndex) continue;
        for (int k = 0; k < 3; ++k) {
            const double error = std::fabs(coordinate(original, p, k) - coordinate(decoded, q, k));
            match.max_error = std::max(match.max_error, error);
        }
    }
    return match;
}

}  // namespace ravel::compare
