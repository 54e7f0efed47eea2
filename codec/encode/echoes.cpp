#include "encode/echoes.h"

#include <algorithm>

namespace ravel {
namespace {

// The most frequent number, and how often it is there. Sorts.
std::pair<double, std::size_t> most_frequent(std::vector<double>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    std::pair<double, std::size_t> best{0, 0};
    for (std::size_t i = 0, j = 0; i < numbers.size(); i = j) {
        while (j < numbers.size() && numbers[j] == numbers[i]) ++j;
        if (j - i > best.second) best = {numbers[i], j - i};
    }
    return best;
}

}  // namespace

std::vector<Echo> find_echoes(const std::vector<Point3>& places, bool may_move) {
    std::vector<Echo> echoes;
    std::vector<Point3> turned(places.size());  // the axis in question last
    std::vector<double> sums;
    std::size_t twice = 0;  // points on an earlier one
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Point3& p = places[i];
            turned[i] = {p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
        }
        std::sort(turned.begin(), turned.end());
        sums.clear();
        for (std::size_t i = 0, j = 0; i < turned.size(); i = j) {
            while (j < turned.size() && turned[j][0] == turned[i][0] &&
                   turned[j][1] == turned[i][1])
                ++j;
            if (axis == 0)
                for (std::size_t k = i + 1; k < j; ++k) twice += turned[k][2] == turned[k - 1][2];
            constexpr std::size_t kMany = 8;  // a row that says little
            if (j - i > kMany) continue;
            for (std::size_t a = i; a < j; ++a)
                for (std::size_t b = a + 1; b < j; ++b)
                    if (turned[a][2] != turned[b][2]) sums.push_back(turned[a][2] + turned[b][2]);
        }
        const auto [sum, votes] = most_frequent(sums);
        if (votes * 24 < places.size() || votes < 8 || (!may_move && sum != 0)) continue;
        if (std::abs(sum) >= 0x1p52) continue;
        Echo echo;
        echo.mirrored[axis] = true;
        echo.offset[axis] = static_cast<std::int64_t>(sum);
        echoes.push_back(echo);
    }
    if (twice * 24 >= places.size() && twice >= 8) echoes.push_back({});
    return echoes;
}

}  // namespace ravel
