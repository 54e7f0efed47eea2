// What both sides know of the positions before the first one is coded, and what is told of one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/complex.h"
#include "mesh/point3.h"
#include "predict/echoes.h"
#include "predict/grid.h"
#include "predict/numbers.h"
#include "predict/predictor.h"
#include "predict/round_face.h"

namespace ravel {

// Beside a bit for each set of weights that is told: those of triangles that are not are 0.
inline constexpr unsigned kNoTriangleDefaults = 1u << kWeightSets;
inline constexpr unsigned kHasRounds = 2 * kNoTriangleDefaults;  // and that there are round faces
inline constexpr unsigned kHasRice = 2 * kHasRounds;             // and Rice codes

struct PositionFormat {
    NumberFormat numbers;
    bool narrow = true;              // float32
    bool has_escapes = false;        // some coordinates are told bit for bit
    bool mirrored = false;           // tets, most of which are inside out
    bool leaders_move = false;       // see carried()
    std::uint64_t usual_start = 16;  // what a residual is expected to be before any is known
    Weights weights = kDefaultWeights;
    bool has_levels = false;   // coordinates that several neighbours share are asked for
    int level_bits = 0;        // and those known from elsewhere, in intervals of 2^level_bits; or 0
    bool has_pairs = false;    // and those that go with the coordinate before; needs level_bits
    bool has_along = false;    // tets: new vertices may go on with the border
    RoundFaceList rounds;      // only if has_along
    bool has_follows = false;  // parts repeat: see follows.h
    bool has_rice = false;     // residuals of guesses are Rice codes
    std::vector<Echo> echoes;  // at most kMostEchoes
    int cube_bits = 0;         // of the cubes in which echoes are looked for
    // Lossless tets: integers that stand for the numbers where the walk asks for places.
    bool has_stand_ins = false;
    Point3 place_origin{};
    double place_scale = 1;

    bool grid() const { return numbers.base == NumberBase::grid; }
    // Values are below that.
    std::int64_t most() const { return grid() ? kMostGrid : kMostWhole; }
    // Values alone do not tell the last bit.
    bool keeps_exact() const { return numbers.base == NumberBase::decimal && numbers.digits > 0; }
    bool operator==(const PositionFormat&) const = default;
};

// Of tets: an eighth of a mean edge, in units. The walk looks for vertices in cubes of half of one;
// a file may hold any scale.
inline std::uint64_t usual_start_of(const PositionFormat& format, double grid_side) {
    const double start = grid_side / format.place_scale / 4;
    return start > 1 ? static_cast<std::uint64_t>(std::min(start, 0x1p40)) : 1;
}

// What is to be coded of a vertex.
using Position = std::array<Number, 3>;

inline Point3 units_of(const NumberFormat& format, const Position& position) {
    Point3 units;
    for (std::size_t axis = 0; axis < 3; ++axis)
        units[axis] = scaled_of(format, position[axis]).units;
    return units;
}

// Is a number that, to the last bit? Of long decimals several have the same units.
inline bool is_value(const PositionFormat& format, const Number& number, double units,
                     double exact) {
    if (number.escaped) return false;
    const Scaled want = scaled_of(format.numbers, number);
    return units == want.units && std::signbit(units) == std::signbit(want.units) &&
           (!format.keeps_exact() || exact == want.exact);
}

// An earlier vertex, and what it says of the new one.
struct Earlier {
    Id vertex = kNone;
    std::size_t echo = 0;                 // which one leads to it, and
    double distance = 0;                  // how far from it the echo of the guess is
    std::array<std::int64_t, 3> whole{};  // of the new vertex
    Point3 value{}, exact{};              // exact only if
    bool copies = false;                  // its coordinates are known to the last bit
};

// The bits of an escaped coordinate.
struct Escape {
    std::uint64_t bits = 0;
    Id vertex = 0;
    std::uint32_t axis = 0;
};

// Where the walk takes a vertex to be: its coordinates in units, or the nearest of 2^20 + 1 steps
// along each axis.
inline Point3 place_of(const PositionFormat& format, const Point3& value) {
    if (!format.has_stand_ins) return value;
    Point3 place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double scaled = (value[axis] - format.place_origin[axis]) * format.place_scale;
        place[axis] = scaled > 0 ? std::floor(std::min(scaled, 0x1p20) + 0.5) : 0;
    }
    return place;
}

}  // namespace ravel
