#include "encode/attribute_grid.h"

#include <algorithm>

#include "base/float32.h"
#include "predict/octahedron.h"

namespace ravel {
namespace {

double value_at(const Array& values, std::size_t i) {
    return values.scalar == Scalar::f32 ? static_cast<double>(values.as<float>()[i])
                                        : values.as<double>()[i];
}
void set_value(Array& values, std::size_t i, double x) {
    if (values.scalar == Scalar::f32)
        values.as<float>()[i] = static_cast<float>(x);
    else
        values.as<double>()[i] = x;
}
double stored(double x, Scalar scalar) {
    return scalar == Scalar::f32 ? to_float32(x) : x;
}

struct Range {
    double widest = 0, farthest = 0;  // of the components; absolute
};

Range range_of(const Array& values) {
    Range range;
    for (std::size_t k = 0; k < values.arity; ++k) {
        double low = INFINITY, high = -INFINITY;
        for (std::size_t i = k; i < values.count() * values.arity; i += values.arity) {
            const double x = value_at(values, i);
            if (!std::isfinite(x)) continue;
            low = std::min(low, x);
            high = std::max(high, x);
        }
        if (!(low <= high)) continue;
        range.widest = std::max(range.widest, high - low);
        range.farthest = std::max({range.farthest, std::abs(low), std::abs(high)});
    }
    return range;
}

// What the nearest value that is stored may be away by rounding alone.
double slack_of(const Range& range, Scalar scalar) {
    return range.farthest * (scalar == Scalar::f32 ? 0x1p-23 : 0x1p-51);
}

// The values a tuple comes back with, each within the bound; false where there are none.
bool round_tuple(const Array& values, std::size_t t, const AttributeGrid& grid,
                 std::vector<double>& rounded) {
    const std::size_t first = t * values.arity;
    const FieldFormat& format = grid.format;
    if (format.octahedral > 0) {
        const Point3 given{value_at(values, first), value_at(values, first + 1),
                           value_at(values, first + 2)};
        const Point3 d =
            octahedral_direction(octahedral_numbers(given, format.octahedral), format.octahedral);
        for (std::size_t k = 0; k < 3; ++k) rounded[k] = stored(d[k], values.scalar);
    } else {
        for (std::size_t k = 0; k < values.arity; ++k) {
            const double whole = std::floor(value_at(values, first + k) / format.step + 0.5);
            if (!(std::abs(whole) < static_cast<double>(kMostWhole))) return false;
            rounded[k] = grid_value(format.step, static_cast<std::int64_t>(whole), values.scalar);
        }
    }
    for (std::size_t k = 0; k < values.arity; ++k)
        if (!(std::abs(rounded[k] - value_at(values, first + k)) <= grid.bound)) return false;
    return true;
}

AttributeGrid grid_of(const Array& values, const AttributeOptions& options) {
    AttributeGrid grid;
    grid.format.numbers = FieldNumbers::grid;
    if (options.octahedral) {
        grid.format.octahedral = *options.octahedral;
        grid.bound = octahedral_bound(*options.octahedral);
        return grid;
    }
    const Range range = range_of(values);
    const double slack = slack_of(range, values.scalar);
    if (options.bits) {
        grid.format.step = std::ldexp(range.widest, -*options.bits);
        grid.bound = grid.format.step / 2 + slack;
    } else {
        grid.bound =
            options.max_error ? *options.max_error : *options.max_error_relative * range.widest;
        grid.format.step = 2 * (grid.bound - slack);
    }
    // Values that are all alike, or a bound finer than they are: nothing can be lost.
    if (!(grid.format.step > 0) || !std::isfinite(grid.format.step)) return {};
    return grid;
}

void round_values(Array& values, AttributeGrid& grid) {
    std::vector<double> rounded(values.arity);
    for (std::size_t t = 0; t < values.count(); ++t) {
        if (!round_tuple(values, t, grid, rounded)) continue;
        for (std::size_t k = 0; k < values.arity; ++k) {
            const std::size_t i = t * values.arity + k;
            grid.error = std::max(grid.error, std::abs(rounded[k] - value_at(values, i)));
            set_value(values, i, rounded[k]);
        }
    }
}

}  // namespace

Status check_attribute_options(const Mesh& mesh, const EncodeOptions& options) {
    for (const AttributeOptions& o : options.attributes) {
        const auto bad = [&](const std::string& why) {
            return Error{Code::bad_option, 0, "attribute \"" + o.name + "\": " + why};
        };
        const auto positive = [](double x) { return x > 0 && x < 1e300; };
        const int given = o.bits.has_value() + o.max_error.has_value() +
                          o.max_error_relative.has_value() + o.octahedral.has_value();
        if (given != 1) return bad("give bits, a largest error or octahedral bits, one of them");
        if (o.bits && (*o.bits < 1 || *o.bits > 30)) return bad("bits are 1 to 30");
        if (o.octahedral && (*o.octahedral < 3 || *o.octahedral > kMostOctahedralBits))
            return bad("octahedral bits are 3 to " + std::to_string(kMostOctahedralBits));
        if ((o.max_error && !positive(*o.max_error)) ||
            (o.max_error_relative && !positive(*o.max_error_relative)))
            return bad("the largest error is a number above 0");
        bool found = false;
        for (const Attribute& a : mesh.attributes) {
            if (a.name != o.name) continue;
            found = true;
            if (!is_float(a.values.scalar))
                return bad("its values are integers, which are always kept exactly");
            if (o.octahedral && a.values.arity != 3)
                return bad("octahedral bits are for unit vectors of 3 components, not of " +
                           std::to_string(a.values.arity));
        }
        if (!found) return bad("the mesh has no attribute of that name");
        for (const AttributeOptions& other : options.attributes)
            if (&other != &o && other.name == o.name) return bad("it is named twice");
    }
    return Done{};
}

std::vector<AttributeGrid> round_attributes(Mesh& mesh, const EncodeOptions& options) {
    std::vector<AttributeGrid> grids(mesh.attributes.size());
    for (const AttributeOptions& o : options.attributes)
        for (std::size_t i = 0; i < grids.size(); ++i) {
            if (mesh.attributes[i].name != o.name) continue;
            grids[i] = grid_of(mesh.attributes[i].values, o);
            if (grids[i].bound > 0) round_values(mesh.attributes[i].values, grids[i]);
        }
    return grids;
}

}  // namespace ravel
