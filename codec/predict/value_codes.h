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
    PoolAround(Around& elements, std::span<const Id> tuple) : elements_(elements), tuple_(tuple) {
        for (std::size_t e = 0; e < tuple.size(); ++e)
            if (tuple[e] == first_.size()) first_.push_back(static_cast<Id>(e));
    }

    Beside beside(Id t, const Id*) const override {
        Beside b;
        if (t < first_.size()) {
            const Beside near = elements_.beside_values(first_[t], tuple_.data());
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
    Point3 normal(Id t, bool) const override {
        return t < normals_.size() ? normals_[t] : Point3{};
    }
    // The sums of those of all elements with a tuple.
    void prepare_normals(bool by_angle) override {
        elements_.prepare_normals(by_angle);
        normals_.assign(first_.size(), {});
        for (std::size_t e = 0; e < tuple_.size(); ++e) {
            if (tuple_[e] == kNone) continue;
            const Point3 n = elements_.normal(static_cast<Id>(e), by_angle);
            for (std::size_t k = 0; k < 3; ++k) normals_[tuple_[e]][k] += n[k];
        }
    }

  private:
    Around& elements_;
    std::span<const Id> tuple_;
    std::vector<Id> first_;  // tuple -> first element that has it
    std::vector<Point3> normals_;
};

template <class Coder>
bool code_values(Coder& coder, const FieldFormat& format, Around& around, Array& values,
                 const FieldTruth& truth) {
    if (format.guess == Guess::normal) around.prepare_normals(format.by_angle);
    FieldCodes<Coder> codes(coder, format, values, truth);
    const auto count = static_cast<Id>(values.count());
    for (Id e = 0; e < count; ++e) {
        const Beside beside = around.beside_values(e, nullptr);
        Point3 normal{};
        if (format.guess == Guess::normal) {
            normal = around.normal(e, format.by_angle);
            const double length = std::sqrt(dot(normal, normal));
            for (double& x : normal) x /= length;
        }
        if (!codes.next(e, beside, shares_of(format.guess, beside, around, e), normal))
            return false;
    }
    return true;
}

}  // namespace ravel
