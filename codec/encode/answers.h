// What the walk over a surface was answered, kept to be coded once more.
#pragma once

#include <cstdint>
#include <vector>

#include "base/context.h"
#include "entropy/flag_model.h"
#include "walk/precedents.h"

namespace ravel {

class Answers {
  public:
    bool empty() const { return said_.empty(); }
    void begin_cell(bool seed) { said_.push_back(kCell | (seed ? 1u : 0u)); }
    void flag(Context context, bool truth) { said_.push_back(2 * context + (truth ? 1u : 0u)); }
    void plain(std::uint64_t value, int count) {
        if (count == 0) return;
        said_.push_back(kPlain | static_cast<std::uint32_t>(count));
        values_.push_back(value);
    }

    // Tells `out`, which takes flags under models and plain bits, all of it by precedents.
    // `models`: as the walk's begin. Linear.
    template <class Out>
    void tell(Precedents precedents, std::vector<FlagModel>& models, Out& out) const {
        auto value = values_.begin();
        const auto code = [&](FlagModel& model, bool yes) {
            out.flag(model, yes);
            return yes;
        };
        for (const std::uint32_t said : said_) {
            if ((said & kPlain) != 0)
                out.plain(*value++, static_cast<int>(said & ~kPlain));
            else if ((said & kCell) != 0)
                precedents.begin_cell((said & 1) != 0);
            else
                precedents.flag(models, said >> 1, (said & 1) != 0, code);
        }
    }

  private:
    static constexpr std::uint32_t kCell = 1u << 30, kPlain = 1u << 31;
    std::vector<std::uint32_t> said_;    // 2 * context + truth, or a kind and what it is about
    std::vector<std::uint64_t> values_;  // of plain bits
};

}  // namespace ravel
