// Weights are whole numbers up to kHeaviest: sums, products, quotients and square roots of doubles
// are the same on every machine, so the weights are, too.
// Cost: linear in corners.
#include "ravel/objective.h"

#include <algorithm>
#include <cmath>

namespace ravel::tool {
namespace {

constexpr std::uint32_t kHeaviest = 65535;
constexpr double kDegrees = 57.29577951308232;

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Of length one, or not finite.
Vector unit(const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

// Middles of cells, and normals of polygons.
struct Shapes {
    std::vector<Vector> middle, normal;
};

template <class Float>
Shapes shapes_of(const Mesh& mesh, const Complex& complex) {
    const auto positions = mesh.positions.as<Float>();
    const auto at = [&](Id corner) {
        const std::size_t p = 3 * std::size_t{complex.point[complex.vertex[corner]]};
        return Vector{static_cast<double>(positions[p]), static_cast<double>(positions[p + 1]),
                      static_cast<double>(positions[p + 2])};
    };
    const Id cells = complex.cell_count();
    Shapes shapes{std::vector<Vector>(cells), std::vector<Vector>(cells)};
    for (Id c = 0; c < cells; ++c) {
        Vector sum{}, twice{};
        for (Id i = complex.first[c]; i < complex.first[c + 1]; ++i) {
            const Vector p = at(i);
            for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k];
            if (complex.kind == CellKind::tet) continue;
            // Newell's normal, from the first corner to keep large coordinates from cancelling.
            const Vector a = minus(p, at(complex.first[c])),
                         b = minus(at(complex.next_in_cell(i)), at(complex.first[c]));
            twice[0] += a[1] * b[2] - a[2] * b[1];
            twice[1] += a[2] * b[0] - a[0] * b[2];
            twice[2] += a[0] * b[1] - a[1] * b[0];
        }
        const double degree = complex.degree(c);
        shapes.middle[c] = {sum[0] / degree, sum[1] / degree, sum[2] / degree};
        shapes.normal[c] = unit(twice);
    }
    return shapes;
}

Shapes shapes_of(const Mesh& mesh, const Complex& complex) {
    return mesh.positions.scalar == Scalar::f32 ? shapes_of<float>(mesh, complex)
                                                : shapes_of<double>(mesh, complex);
}

}  // namespace

const std::vector<std::string>& objective_names() {
    static const std::vector<std::string> names{"turns", "normals", "axis=x", "axis=y", "axis=z"};
    return names;
}

std::optional<Objective> objective_of(const std::string& name) {
    const auto& names = objective_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<Objective>(found - names.begin());
}

std::vector<std::uint32_t> facet_weights(const Mesh& mesh, const Complex& complex,
                                         Objective objective) {
    std::vector<std::uint32_t> weights;
    if (objective == Objective::turns) return weights;
    const Shapes shapes = shapes_of(mesh, complex);
    weights.assign(complex.twin.size(), kHeaviest);
    for (Id f = 0; f < weights.size(); ++f) {
        const Id g = complex.twin[f];
        if (g == kNone || g < f) continue;
        const Id a = complex.cell_of[f], b = complex.cell_of[g];
        double off = 1;  // 0 as well as can be .. 1 not at all
        if (objective == Objective::normals) {
            const Vector change = minus(shapes.normal[b], shapes.normal[a]);
            off = std::sqrt(dot(change, change)) / 2;  // the sine of half the angle
        } else {
            const auto axis =
                static_cast<std::size_t>(objective) - static_cast<std::size_t>(Objective::axis_x);
            off = 1 - std::fabs(unit(minus(shapes.middle[b], shapes.middle[a]))[axis]);
        }
        if (!(off < 1)) continue;
        weights[f] = weights[g] = static_cast<std::uint32_t>(kHeaviest * std::max(off, 0.0) + 0.5);
    }
    return weights;
}

StepFacts measure_steps(const Mesh& mesh, const Complex& complex, const Strip& strip) {
    const Shapes shapes = shapes_of(mesh, complex);
    StepFacts facts;
    double angles = 0;
    std::uint64_t bends = 0, passed = 0, turns = 0;
    std::array<std::uint64_t, 3> along{};
    for (Id f = 0; f < complex.twin.size(); ++f) {
        const Id g = complex.twin[f];
        if (g == kNone || strip.role[f] != FacetRole::strip) continue;
        if (complex.kind == CellKind::polygon && complex.degree(complex.cell_of[f]) > 2) {
            for (Id e = complex.next_in_cell(f); e != f; e = complex.next_in_cell(e)) {
                if (strip.role[e] != FacetRole::strip || e < f) continue;
                ++passed;
                turns += complex.next_in_cell(f) == e || complex.next_in_cell(e) == f;
            }
        }
        if (g < f) continue;
        ++facts.steps;
        const Id a = complex.cell_of[f], b = complex.cell_of[g];
        const Vector step = minus(shapes.middle[b], shapes.middle[a]);
        const double cosine = dot(shapes.normal[a], shapes.normal[b]);
        if (complex.kind == CellKind::polygon && cosine >= -2) {
            angles += kDegrees * std::acos(std::clamp(cosine, -1.0, 1.0));
            ++bends;
        }
        if (!(dot(step, step) > 0)) continue;
        std::size_t axis = 0;
        for (const std::size_t k : {std::size_t{1}, std::size_t{2}})
            if (std::fabs(step[k]) > std::fabs(step[axis])) axis = k;
        ++along[axis];
    }
    const auto percent = [](std::uint64_t part, std::uint64_t whole) {
        return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    };
    facts.normal_change_degrees = bends == 0 ? 0 : angles / static_cast<double>(bends);
    facts.turn_percent = percent(turns, passed);
    for (std::size_t k = 0; k < 3; ++k) facts.axis_percent[k] = percent(along[k], facts.steps);
    return facts;
}

}  // namespace ravel::tool
