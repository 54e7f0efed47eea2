#include "encode/positions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <optional>

#include "base/bytes.h"
#include "container/head.h"
#include "encode/numbers.h"

namespace ravel {
namespace {

double value_at(const Array& positions, std::size_t i) {
    return positions.scalar == Scalar::f32 ? static_cast<double>(positions.as<float>()[i])
                                           : positions.as<double>()[i];
}

std::uint64_t bits_at(const Array& positions, std::size_t i) {
    return positions.scalar == Scalar::f32 ? std::uint64_t{positions.as<std::uint32_t>()[i]}
                                           : positions.as<std::uint64_t>()[i];
}

bool finite_point(const Array& positions, std::size_t p) {
    return std::isfinite(value_at(positions, 3 * p)) &&
           std::isfinite(value_at(positions, 3 * p + 1)) &&
           std::isfinite(value_at(positions, 3 * p + 2));
}

struct Box {
    std::array<double, 3> low{}, high{};
    double longest = 0, farthest = 0;  // side; largest absolute coordinate
    bool empty = true;

    void take_in(const Array& positions, std::size_t p) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = value_at(positions, 3 * p + axis);
            low[axis] = empty ? x : std::min(low[axis], x);
            high[axis] = empty ? x : std::max(high[axis], x);
            farthest = std::max(farthest, std::abs(x));
            longest = std::max(longest, high[axis] - low[axis]);
        }
        empty = false;
    }
};

Box box_of(const Array& positions, std::size_t points) {
    Box box;
    for (std::size_t p = 0; p < points; ++p)
        if (finite_point(positions, p)) box.take_in(positions, p);
    return box;
}

// The nearest float32 that is not below (above) x, where x has one near by; the head then stores it
// in half the bytes. Both are at most one unit in the last place of a float32 away.
double float32_above(double x) {
    if (!(std::abs(x) < 1e30) || (x != 0 && std::abs(x) < 1e-30)) return x;
    const auto f = static_cast<float>(x);
    return static_cast<double>(static_cast<double>(f) >= x ? f : std::nextafter(f, INFINITY));
}
double float32_below(double x) {
    return -float32_above(-x);
}

// The least power of two that is not below x.
double power_above(double x) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    return fraction == 0.5 || fraction == 0 ? x : std::ldexp(1.0, exponent);
}
// x rounded down to ten bits.
double few_bits_below(double x) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    return std::ldexp(std::floor(std::ldexp(fraction, 10)), exponent - 10);
}

// The box of all points but for a few that would make it hundreds of times as large: they are left
// to be escaped.
Box robust_box(const Array& positions, std::size_t points) {
    constexpr std::size_t kFewest = 20;  // points among which one may be let go
    constexpr double kMuch = 256;
    Box box = box_of(positions, points);
    if (points < kFewest) return box;
    std::vector<double> values;
    Box core;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        values.clear();
        for (std::size_t p = 0; p < points; ++p)
            if (finite_point(positions, p)) values.push_back(value_at(positions, 3 * p + axis));
        if (values.size() < kFewest) return box;
        const std::size_t spare = values.size() / 200 + 1;
        const auto low = values.begin() + static_cast<std::ptrdiff_t>(spare);
        const auto high = values.end() - static_cast<std::ptrdiff_t>(spare + 1);
        std::nth_element(values.begin(), low, values.end());
        core.low[axis] = *low;
        std::nth_element(low, high, values.end());
        core.high[axis] = *high;
        core.longest = std::max(core.longest, core.high[axis] - core.low[axis]);
    }
    if (!(box.longest > kMuch * core.longest) || core.longest == 0) return box;
    // What is as near as the core is large belongs to it.
    Box kept;
    for (std::size_t p = 0; p < points; ++p) {
        bool near = finite_point(positions, p);
        for (std::size_t axis = 0; axis < 3 && near; ++axis) {
            const double x = value_at(positions, 3 * p + axis);
            near = x >= core.low[axis] - core.longest && x <= core.high[axis] + core.longest;
        }
        if (near) kept.take_in(positions, p);
    }
    return kept;
}

// Is every point a whole number of steps from the box's low corner, to `off` at most?
bool lies_on(const Array& positions, const Box& box, double step, double off) {
    off = std::min(off / step, 1.0 / 64);
    for (std::size_t p = 0; p < positions.count(); ++p)
        for (std::size_t axis = 0; axis < 3 && finite_point(positions, p); ++axis) {
            const double q = (value_at(positions, 3 * p + axis) - box.low[axis]) / step;
            if (!(std::abs(q - std::floor(q + 0.5)) <= off)) return false;
        }
    return true;
}

// The coarsest step of few digits, decimal or a power of two, that all points are whole multiples
// of apart, to `off`, if it is not finer than `finest`; or 0.
double step_of_few_digits(const Array& positions, const Box& box, double finest, double off) {
    if (!(box.longest > 0) || !(finest > 0) || !(box.longest < 1e15)) return 0;
    const double least = std::max({finest, box.longest / 0x1p30, 1e-15});
    std::vector<double> steps;
    for (int e = std::ilogb(box.longest) + 1; std::ldexp(1.0, e) >= least; --e)
        steps.push_back(std::ldexp(1.0, e));
    for (std::size_t places = 0; places <= 15; ++places)
        for (const double digits : {5.0, 2.5, 2.0, 1.0})
            for (const double step :
                 {digits / kTensAsDoubles[places], digits * kTensAsDoubles[places]})
                if (step <= box.longest && step >= least) steps.push_back(step);
    std::sort(steps.begin(), steps.end(), std::greater<>());
    // The head has more room for a step where that is needed to tell points far off.
    for (const double step : steps) {
        const auto brief = static_cast<double>(static_cast<float>(step));
        if (box.longest / step < 0x1p17 && lies_on(positions, box, brief, off)) return brief;
        if (lies_on(positions, box, step, off)) return step;
    }
    return 0;
}

// The step of the grid that a mesh lies on already, where that is coarser than `asked` or hardly
// finer; or 0. It takes fewer bytes, and points stay where they are. That may be a grid of few
// digits, or one that was made with as many steps over a box that was a step larger or smaller.
double own_step(const Array& positions, const Box& box, double asked) {
    constexpr double kHardly = 0.85;
    const double off = asked / 8;
    const double own = step_of_few_digits(positions, box, kHardly * asked, off);
    if (own > 0) return own;
    const double cells = std::floor(box.longest / asked + 0.5);
    for (const double other : {cells, cells + 1, cells - 1}) {
        if (!(cells >= 256) || box.longest > 1e30) break;
        const auto step = static_cast<double>(static_cast<float>(box.longest / other));
        if (step > 0 && lies_on(positions, box, step, off)) return step;
    }
    return 0;
}

// How many coordinates have a mirror image about `centre`, to an eighth of a step. Of many only
// those in some of the layers about the centre are looked at: images are in the same.
std::size_t mirrored_about(double centre, const std::vector<double>& values, double step) {
    constexpr std::size_t kLooks = 8192;
    constexpr double kLayer = 16, kOff = 0.137;  // in steps; no face of a layer is on the grid
    const std::uint64_t share = values.size() / kLooks + 1;
    const auto is_looked_at = [&](double x) {
        const double layer = std::abs(x - centre) / (kLayer * step) + kOff;
        if (!(layer < 0x1p62)) return false;
        const std::uint64_t hash = static_cast<std::uint64_t>(layer) * 0x9E3779B97F4A7C15u;
        return (hash >> 32) % share == 0;
    };
    std::vector<double> sorted;
    for (const double x : values)
        if (share == 1 || is_looked_at(x)) sorted.push_back(x);
    std::sort(sorted.begin(), sorted.end());
    std::size_t count = 0;
    for (std::size_t i = 0, j = sorted.size(); i < j;) {
        const double sum = (sorted[i] - centre) + (sorted[j - 1] - centre);
        const bool match = std::abs(sum) < step / 8;
        count += match;
        if (match || sum < 0) ++i;
        if (match || !(sum < 0)) --j;
    }
    return count;
}

// Where the grid starts on an axis: what is mirrored about zero, or about the middle of the box, is
// mirrored on the grid too; what lies on it anyhow stays.
double origin_on(const Array& positions, const Box& box, std::size_t axis, double step,
                 double asked, bool is_own) {
    const double low = box.low[axis], high = box.high[axis];
    const double middle = low + (high - low) / 2;
    double origin = std::abs(low / step) < 0x1p40 ? std::floor(low / step + 0.5) * step : low;
    if (is_own) {
        if (!(std::abs(origin - low) < asked / 16)) origin = low;
    } else if (std::abs(middle) > step / 64 && std::isfinite(middle)) {
        std::vector<double> values;
        for (std::size_t p = 0; p < positions.count(); ++p) {
            const double x = value_at(positions, 3 * p + axis);
            if (x >= low && x <= high) values.push_back(x);
        }
        if (mirrored_about(middle, values, step) > mirrored_about(0, values, step))
            origin = middle - std::ceil((middle - low) * 2 / step) * step / 2;
    }
    return std::isfinite(origin) ? origin : low;
}

// An origin that is not whole steps on all axes is a number of few digits on each, unless that
// would move the grid by more than a sixteenth of the step that was `asked` for.
void shorten_origin(Grid& grid, double asked) {
    if (std::all_of(grid.origin.begin(), grid.origin.end(),
                    [&](double x) { return is_whole_steps(x, grid.step); }))
        return;
    for (double& x : grid.origin) {
        const double near = float32_below(x);
        if (x - near < asked / 16) x = near;
    }
}

// An origin that takes fewer bytes to tell, farther below the box; unless the grid is so coarse
// that values would be much larger for it.
void coarsen_origin(Grid& grid, int bits, double longest) {
    const double step = grid.step, unit = origin_unit(bits);
    const auto bytes = [](double steps) {
        return varint_size(zigzag(static_cast<std::int64_t>(steps)));
    };
    if (!(longest / step >= 16 * unit) || !(longest / step + unit < static_cast<double>(kMostGrid)))
        return;
    std::size_t fine = 0, coarse = 0;
    Grid coarsened = grid;
    for (double& x : coarsened.origin) {
        if (!is_whole_steps(x, step)) return;
        const double steps = std::floor(x / step + 0.5), units = std::floor(steps / unit);
        fine += bytes(steps);
        coarse += bytes(units);
        x = units * unit * step;
    }
    if (coarse < fine) grid = coarsened;
}

// The grid number of a coordinate. On a lattice the nearest multiple of the step is found first, so
// that it does not depend on the origin.
double grid_number(const PositionPlan& plan, std::size_t axis, double x, bool lattice) {
    const double step = plan.grid.step, origin = plan.grid.origin[axis];
    return lattice ? std::floor(x / step + 0.5) - origin / step
                   : std::floor((x - origin) / step + 0.5);
}

// A coordinate told bit for bit, for which `whole` stands.
Number escaped(const Array& positions, std::size_t i, double whole) {
    return {static_cast<std::int64_t>(whole), bits_at(positions, i), 0, false, true};
}

// Puts every coordinate on the grid; those that miss `bound`, or lie out of the box, are escaped.
void place_on_grid(const Array& positions, const Box& box, bool lattice, PositionPlan& plan) {
    plan.error = 0;
    plan.format.has_escapes = false;
    for (std::size_t p = 0; p < positions.count(); ++p)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = value_at(positions, 3 * p + axis);
            const double within =
                std::isfinite(x) ? std::clamp(x, box.low[axis], box.high[axis]) : box.low[axis];
            const auto most = static_cast<double>(kMostGrid - 1);
            const double q = std::clamp(grid_number(plan, axis, within, lattice), -most, most);
            Number& n = plan.values[p][axis];
            n = {static_cast<std::int64_t>(q), 0, 0, false, false};
            const double error =
                std::abs(coordinate_of(plan.grid, axis, n.whole, positions.scalar) - x);
            if (within == x && error <= plan.bound) {
                plan.error = std::max(plan.error, error);
            } else {
                n = escaped(positions, 3 * p + axis, q);
                plan.format.has_escapes = true;
            }
        }
}

// Lossless: every coordinate as a number, or bit for bit.
void place_exactly(const Array& positions, PositionPlan& plan) {
    const NumberFormat& format = plan.format.numbers = choose_numbers(positions);
    for (std::size_t i = 0; i < 3 * positions.count(); ++i) {
        const double x = value_at(positions, i);
        const std::optional<Number> n = number_of(format, x, positions.scalar);
        plan.values[i / 3][i % 3] = n ? *n : escaped(positions, i, whole_near(format, x));
        plan.format.has_escapes = plan.format.has_escapes || !n;
    }
}

}  // namespace

Result<PositionPlan> plan_positions(const Mesh& mesh, const EncodeOptions& options) {
    const Array& positions = mesh.positions;
    const std::size_t points = positions.count();
    PositionPlan plan;
    plan.format.narrow = positions.scalar == Scalar::f32;
    plan.values.resize(points);
    if (!options.position_bits && !options.max_error && !options.max_error_relative &&
        !options.lattice) {
        place_exactly(positions, plan);
        return plan;
    }
    const Box box = robust_box(positions, points);
    const double longest = std::isfinite(box.longest) ? box.longest : 0;
    // What rounding to the mesh's floats may add to an error.
    const double spacing =
        std::ldexp(power_above(box.farthest / 4), plan.format.narrow ? -22 : -51);
    Grid& grid = plan.grid;
    if (options.position_bits) {
        grid.step = float32_above(longest / std::ldexp(1.0, *options.position_bits));
    } else if (options.lattice) {
        grid.step = *options.lattice;
    } else {
        plan.bound = options.max_error.value_or(0);
        if (options.max_error_relative) {
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                square += (box.high[axis] - box.low[axis]) * (box.high[axis] - box.low[axis]);
            plan.bound = few_bits_below(*options.max_error_relative * std::sqrt(square));
            if (!(plan.bound > 0) || !std::isfinite(plan.bound)) plan.bound = 1;
        }
        grid.step = float32_below(2 * plan.bound);
    }
    if (!(grid.step > 0)) grid.step = 1;
    if (options.position_bits || options.lattice)
        plan.bound = float32_above(grid.step / 2 + 2 * spacing);
    double asked = grid.step;
    const double own = options.lattice ? 0 : own_step(positions, box, asked);
    if (own > 0) grid.step = own;
    if (longest / grid.step >= static_cast<double>(kMostGrid) ||
        (options.lattice && box.farthest / grid.step >= 0x1p52))
        return Error{Code::bad_option, 0,
                     "the largest error (or the lattice) asked for is too small for a grid over "
                     "this mesh; leave it out to store positions exactly"};
    const auto place = [&] {
        for (std::size_t axis = 0; axis < 3; ++axis)
            grid.origin[axis] = options.lattice
                                    ? std::floor(box.low[axis] / grid.step) * grid.step
                                    : origin_on(positions, box, axis, grid.step, asked, own > 0);
        if (!options.lattice) shorten_origin(grid, asked);
        plan.bits = static_cast<std::uint8_t>(options.position_bits.value_or(
            std::bit_width(static_cast<std::uint64_t>(std::ceil(longest / grid.step)))));
        coarsen_origin(grid, plan.bits, longest);
        place_on_grid(positions, box, options.lattice.has_value(), plan);
    };
    place();
    if (plan.format.has_escapes && own == 0 && (options.max_error || options.max_error_relative)) {
        // Rounding pushed some over the bound; a slightly finer grid has room for it.
        asked = grid.step = few_bits_below(2 * std::max(plan.bound - spacing, plan.bound / 2));
        place();
    }
    if (!options.max_error && !options.max_error_relative && plan.error <= grid.step / 2)
        plan.bound = grid.step / 2;
    plan.error = kept_error(plan.error, plan.bound);
    return plan;
}

std::vector<Point3> plan_places(const Mesh& mesh, PositionPlan& plan) {
    const std::size_t points = mesh.positions.count();
    std::vector<Point3> places(points);
    Point3 low{}, high{};
    std::array<bool, 3> any{};
    for (std::size_t p = 0; p < points; ++p) {
        places[p] = units_of(plan.format.numbers, plan.values[p]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (plan.values[p][axis].escaped) continue;
            low[axis] = any[axis] ? std::min(low[axis], places[p][axis]) : places[p][axis];
            high[axis] = any[axis] ? std::max(high[axis], places[p][axis]) : places[p][axis];
            any[axis] = true;
        }
    }
    plan.format.has_stand_ins = mesh.kind == CellKind::tet && !plan.format.grid();
    if (!plan.format.has_stand_ins) return places;
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        longest = std::max(longest, high[axis] - low[axis]);
    plan.format.place_origin = low;
    const double scale = 0x1p16 / longest;
    plan.format.place_scale = std::isfinite(scale) && scale > 0 ? scale : 1;
    for (Point3& place : places) place = place_of(plan.format, place);
    return places;
}

}  // namespace ravel
