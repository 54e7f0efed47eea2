// Which of the numbers 0 .. n-1 are left, and how many below each: sums in a tree [Fenwick1994].
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace ravel {

class RankTree {
  public:
    explicit RankTree(std::uint32_t count)
        : sum_(std::size_t{count} + 1), has_(count, 1), left_(count) {
        for (std::uint32_t i = 1; i <= count; ++i) sum_[i] = i & (~i + 1);
    }

    std::uint32_t left() const { return left_; }
    bool has(std::uint32_t number) const { return number < has_.size() && has_[number] != 0; }
    void take(std::uint32_t number) {
        has_[number] = 0;
        --left_;
        for (std::size_t i = std::size_t{number} + 1; i < sum_.size(); i += i & (~i + 1)) --sum_[i];
    }
    // How many are left below a number.
    std::uint32_t below(std::uint32_t number) const {
        std::uint32_t count = 0;
        for (std::size_t i = number; i > 0; i -= i & (~i + 1)) count += sum_[i];
        return count;
    }
    // The one that has `rank` others below it; rank < left().
    std::uint32_t at(std::uint32_t rank) const {
        std::size_t i = 0;
        for (std::size_t step = std::bit_floor(sum_.size()); step > 0; step /= 2)
            if (i + step < sum_.size() && sum_[i + step] <= rank) {
                i += step;
                rank -= sum_[i];
            }
        return static_cast<std::uint32_t>(i);
    }

  private:
    std::vector<std::uint32_t> sum_;
    std::vector<std::uint8_t> has_;
    std::uint32_t left_;
};

}  // namespace ravel
