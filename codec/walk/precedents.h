// Answers of the walk that repeat. Where the last twelve, four or one cells were answered for as
// some cells were before, the walk may go on as it went there: the answer then given to the same
// question is the precedent of the one at hand, and one flag says whether it holds. Parts of
// surfaces that are there many times so cost next to nothing, however they begin; and what is alike
// without being the same helps, too. [Mahoney2005]'s packers know the like as match models.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "walk/contexts.h"

namespace ravel {

class Precedents {
  public:
    // `cells`, `corners`: about how many there will be. Memory is in proportion to both.
    Precedents(std::size_t cells, std::size_t corners)
        : most_(std::min(3 * corners + 16, kMostAnswers)),
          bits_(static_cast<int>(
              std::bit_width(std::clamp<std::size_t>(cells / 8, 16, kMostSlots) - 1))) {
        for (auto& slots : slots_) slots.resize(std::size_t{1} << bits_);
        said_.resize(most_);
    }

    void begin_cell(bool seed) {
        take_in(print_ ^ print_ >> 32);
        print_ = seed ? 2 : 1;
        const std::uint16_t mark = seed ? kSeed : kOther;
        // After an answer that was as before, the walk goes on from cell to cell there, too.
        const bool goes_on = at_ < count_ && said_[at_] == mark && agreed_ > 0;
        const bool records = count_ < most_;
        Slot found;
        for (std::size_t i = 0; i < kOrders.size(); ++i) {
            const std::uint64_t key = (sums_[i] ^ print_) * kFactor;
            const auto check = static_cast<std::uint32_t>(key);
            Slot& slot = slots_[i][static_cast<std::size_t>(key >> (64 - bits_))];
            if (slot.at != 0 && slot.check == check) found = slot;
            if (records) slot = {static_cast<std::uint32_t>(count_) + 1, check};
        }
        if (records) said_[count_++] = mark;
        if (goes_on) {
            ++at_;
            return;
        }
        agreed_ = 0;
        at_ = found.at == 0 ? kNowhere : found.at;
    }

    // The answer to the question `context`, by `code(model, truth)`, which writes or reads a flag
    // under a model. The question's own model learns it either way.
    template <class Model, class Code>
    bool flag(std::vector<Model>& models, Context context, bool truth, const Code& code) {
        bool answer = false;
        if (at_ < count_ && said_[at_] >> 1 == context) {
            const bool then = (said_[at_++] & 1) != 0;
            Model& own = models[context];
            const std::uint32_t often = agreed_ - (agreed_ > 2);  // never, once, some times, more
            const auto sure = static_cast<std::uint32_t>(own.flag_class()) / 5;
            // As kPrecedent.at has it, where nothing is out of range.
            const Context asked =
                surface::kPrecedent.base + (2 * often + (own.likely() == then ? 1 : 0)) * 3 + sure;
            const bool holds = code(models[asked], truth == then);
            answer = holds == then;
            own.update(answer);
            agreed_ = holds ? std::min(agreed_ + 1, kOften) : 0;
        } else {
            at_ = kNowhere;
            answer = code(models[context], truth);
        }
        const auto said = static_cast<std::uint16_t>(2 * context + answer);
        if (count_ < most_) said_[count_++] = said;
        print_ = (print_ ^ said) * kFactor;
        return answer;
    }

  private:
    // Where a cell begins, and by what question it could be none.
    static constexpr std::uint16_t kSeed = 0xFFFF, kOther = 0xFFFE;
    static_assert(2 * surface::kContexts < kOther);
    static constexpr std::uint32_t kOften = 4;
    static constexpr std::size_t kNowhere = ~std::size_t{0}, kMostSlots = std::size_t{1} << 22,
                                 kMostAnswers = 0xFFFFFFF0;
    static constexpr std::array<std::size_t, 3> kOrders{1, 4, 12};
    static constexpr std::size_t kLongest = kOrders.back();
    static constexpr std::uint64_t kFactor = 0xD6E8FEB86659FD93u, kStep = 0x9E3779B97F4A7C15u;
    // kStep to the power of each order.
    static constexpr auto kPowers = [] {
        std::array<std::uint64_t, kOrders.size()> powers{};
        for (std::size_t i = 0; i < powers.size(); ++i) {
            powers[i] = 1;
            for (std::size_t k = 0; k < kOrders[i]; ++k) powers[i] *= kStep;
        }
        return powers;
    }();

    // The print of a cell comes last in the sums, and what is now too long ago leaves them.
    void take_in(std::uint64_t print) {
        for (std::size_t i = 0; i < kOrders.size(); ++i)
            sums_[i] =
                (sums_[i] * kStep + print) - trail_[(cell_ - kOrders[i]) % kLongest] * kPowers[i];
        trail_[cell_++ % kLongest] = print;
    }

    struct Slot {
        std::uint32_t at = 0;  // behind where the cell begins; 0: nowhere
        std::uint32_t check = 0;
    };

    std::size_t most_;
    int bits_;
    std::array<std::vector<Slot>, kOrders.size()> slots_;  // by what the last cells were
    std::vector<std::uint16_t> said_;                      // 2 * context + answer, and marks
    std::size_t count_ = 0;
    std::array<std::uint64_t, kLongest> trail_{};       // prints of the last cells
    std::array<std::uint64_t, kOrders.size()> sums_{};  // of these, in powers of kStep
    std::uint64_t print_ = 0;                           // of the answers of the cell at hand
    std::size_t cell_ = kLongest;
    std::size_t at_ = kNowhere;  // of the precedent, in `said_`
    std::uint32_t agreed_ = 0;   // answers in a row that were as their precedents, at most kOften
};

}  // namespace ravel
