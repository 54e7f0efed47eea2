#include "encode/echoes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ravel {
namespace {

struct Vote {
    double number = 0;
    std::size_t count = 0;
};

// The numbers that are there at least `fewest` times, most frequent first; at most `most` of them.
std::vector<Vote> most_frequent(std::vector<double>& numbers, std::size_t fewest,
                                std::size_t most) {
    std::sort(numbers.begin(), numbers.end());
    std::vector<Vote> votes;
    for (std::size_t i = 0, j = 0; i < numbers.size(); i = j) {
        while (j < numbers.size() && numbers[j] == numbers[i]) ++j;
        if (j - i >= fewest && std::abs(numbers[i]) < 0x1p52) votes.push_back({numbers[i], j - i});
    }
    std::stable_sort(votes.begin(), votes.end(),
                     [](const Vote& a, const Vote& b) { return a.count > b.count; });
    std::vector<Vote> kept;  // one off is the same, rounded
    for (const Vote& v : votes) {
        bool near = kept.size() >= most;
        for (const Vote& k : kept) near = near || std::abs(k.number - v.number) <= 1;
        if (!near) kept.push_back(v);
    }
    return kept;
}

Echo echo_along(std::size_t axis, bool mirrored, double offset) {
    Echo echo;
    echo.mirrored[axis] = mirrored;
    echo.offset[axis] = static_cast<std::int64_t>(offset);
    return echo;
}

// Of large meshes about so many points are looked at; all or none of a row.
constexpr std::size_t kPlaces = 16384;
std::uint64_t row_of(const Point3& turned) {
    std::uint64_t hash = std::bit_cast<std::uint64_t>(turned[0]) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ hash >> 29 ^ std::bit_cast<std::uint64_t>(turned[1])) * 0xBF58476D1CE4E5B9u;
    return hash >> 32;
}

}  // namespace

Echoes find_echoes(const std::vector<Point3>& places, bool may_move) {
    Echoes echoes;
    std::vector<Point3> turned;  // the axis in question last
    std::vector<double> sums, steps;
    const std::uint64_t share = places.size() / kPlaces + 1;
    std::size_t twice = 0, fewest = 8;  // twice: points on an earlier one
    for (std::size_t axis = 0; axis < 3; ++axis) {
        turned.clear();
        for (const Point3& p : places) {
            const Point3 t{p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
            if (share == 1 || row_of(t) % share == 0) turned.push_back(t);
        }
        fewest = std::max<std::size_t>(8, turned.size() / 24);
        std::sort(turned.begin(), turned.end());
        sums.clear();
        steps.clear();
        for (std::size_t i = 0, j = 0; i < turned.size(); i = j) {
            while (j < turned.size() && turned[j][0] == turned[i][0] &&
                   turned[j][1] == turned[i][1])
                ++j;
            for (std::size_t k = i + 1; k < j; ++k) {
                const double step = turned[k][2] - turned[k - 1][2];
                if (step == 0)
                    twice += axis == 0;
                else
                    steps.push_back(step);
            }
            constexpr std::size_t kMany = 8;  // a row that says little
            if (j - i > kMany) continue;
            for (std::size_t a = i; a < j; ++a)
                for (std::size_t b = a + 1; b < j; ++b)
                    if (turned[a][2] != turned[b][2]) sums.push_back(turned[a][2] + turned[b][2]);
        }
        bool first = true;
        for (const Vote& v : most_frequent(sums, fewest, 2)) {
            if (!may_move && v.number != 0) continue;
            (first ? echoes.likely : echoes.more).push_back(echo_along(axis, true, v.number));
            first = false;
        }
        if (!may_move) continue;
        for (const Vote& v : most_frequent(steps, fewest, 1)) {
            echoes.more.push_back(echo_along(axis, false, v.number));
            echoes.more.push_back(echo_along(axis, false, -v.number));
        }
    }
    if (twice >= fewest) echoes.likely.push_back({});
    return echoes;
}

}  // namespace ravel
