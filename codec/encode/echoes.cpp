#include "encode/echoes.h"

#include <algorithm>
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

}  // namespace

Echoes find_echoes(const std::vector<Point3>& places, bool may_move) {
    Echoes echoes;
    std::vector<Point3> turned(places.size());  // the axis in question last
    std::vector<double> sums, steps;
    const std::size_t fewest = std::max<std::size_t>(8, places.size() / 24);
    std::size_t twice = 0;  // points on an earlier one
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Point3& p = places[i];
            turned[i] = {p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
        }
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
