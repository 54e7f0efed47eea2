// Codes the values of all elements, or of all tuples of a pool, in their order; see FieldCodes.
#pragma once

#include <span>

#include "predict/field_codes.h"

namespace ravel {

// The tuples of a pool as elements: each is where the element is that has it first. Tuples that no
// element has come last, each beside the one before.
class PoolAround final : public Around {
  public:
    // `tuple`: of each element, by order of use, kNone for none.
    PoolAround(const Around& elements, std::span<const Id> tuple)
        : elements_(elements), tuple_(tuple) {
        for (std::size_t e = 0; e < tuple.size(); ++e)
            if (tuple[e] == first_.size()) first_.push_back(static_cast<Id>(e));
    }

    Beside beside(Id t) const override {
        Beside b;
        if (t < first_.size()) {
            const Beside near = elements_.beside_values(first_[t]);
            bool based = true;
            for (std::uint32_t i = 0; i < near.count; ++i) {
                const Id other = tuple_[near.at[i]];
                if (other < t)
                    b.add(other, near.kind[i], near.share[i]);
                else
                    based = based && near.share[i] == 0;
            }
            if (!based) b.share.fill(0);
        }
        if (b.count == 0 && t > 0) b.add(t - 1);
        return b;
    }
    Point3 place(Id t) const override {
        return t < first_.size() ? elements_.place(first_[t]) : Point3{};
    }
    Point3 normal(Id t) const override {
        return t < first_.size() ? elements_.normal(first_[t]) : Point3{};
    }

  private:
    const Around& elements_;
    std::span<const Id> tuple_;
    std::vector<Id> first_;  // tuple -> first element that has it
};

template <class Coder>
bool code_values(Coder& coder, const FieldFormat& format, const Around& around, Array& values,
                 const FieldTruth& truth) {
    FieldCodes<Coder> codes(coder, format, values, truth);
    const auto count = static_cast<Id>(values.count());
    for (Id e = 0; e < count; ++e) {
        const Beside beside = around.beside_values(e);
        if (!codes.next(e, beside, shares_of(format.guess, beside, around, e),
                        format.guess == Guess::normal ? around.normal(e) : Point3{}))
            return false;
    }
    return true;
}

}  // namespace ravel
