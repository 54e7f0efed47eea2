// What is known around an element (point, cell, corner, companion, tuple) when its values are
// coded: earlier elements near it, the most telling first, and where they are.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/complex.h"
#include "mesh/point3.h"

namespace ravel {

inline constexpr std::size_t kMostBeside = 12;
inline constexpr std::uint32_t kBesideKinds = 4, kHints = 8;

struct Beside {
    std::uint32_t count = 0;
    std::array<Id, kMostBeside> at{};              // earlier elements
    std::array<std::uint8_t, kMostBeside> kind{};  // how they lie, below kBesideKinds
    std::array<std::int8_t, kMostBeside> share{};  // of a linear guess; all 0 where none is known
    std::uint32_t hint = 0;                        // below kHints

    void add(Id element, std::uint8_t how = 0, std::int8_t of_guess = 0) {
        if (count == kMostBeside) return;
        at[count] = element;
        kind[count] = how;
        share[count++] = of_guess;
    }
};

// Nothing is pure virtual here and in FloodGraph: what has no C++ runtime links no call for it.
class Around {
  public:
    Around() = default;
    Around(const Around&) = delete;
    Around& operator=(const Around&) = delete;
    virtual ~Around() = default;

    // `tuple`: of the elements so far, where several may have the same; none where each has its
    // own.
    virtual Beside beside(Id, const Id* /*tuple*/) const { return {}; }
    virtual Point3 place(Id) const { return {}; }
    // Those whose values tell most of this one's. `tuple` is then of all elements; those of lower
    // tuples have known values.
    virtual Beside beside_values(Id element, const Id* tuple) const {
        return beside(element, tuple);
    }
    // Of the surface at the element, as long as it counts among others that share a tuple.
    virtual Point3 normal(Id, bool /*by_angle*/) const { return {}; }
    virtual void prepare_normals(bool /*by_angle*/) {}
};

// Elements of which nothing is known but their order.
class InOrder final : public Around {
  public:
    Beside beside(Id element, const Id*) const override {
        Beside b;
        for (Id back = 1; back <= 2 && back <= element; ++back) b.add(element - back);
        return b;
    }
    Point3 place(Id element) const override { return {static_cast<double>(element), 0, 0}; }
};

}  // namespace ravel
