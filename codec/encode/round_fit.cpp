#include "encode/round_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "encode/linear_system.h"

namespace ravel {
namespace {

// Unknowns: the centre, the axis, the radius, the ring.
constexpr std::size_t kUnknowns = 8;
using Unknowns = Row<kUnknowns>;

// In place of a torus' centre stands the middle of its tube on the side `aside`: a little more or
// less of a ring then moves nothing near by.
Point3 to_tube(const Point3& axis, const Point3& aside) {
    const double h = dot(aside, axis);
    return unit({aside[0] - h * axis[0], aside[1] - h * axis[1], aside[2] - h * axis[2]});
}
Unknowns unknowns_of(const RoundShape& s, const Point3& aside) {
    const Point3 way = to_tube(s.axis, aside);
    return {s.centre[0] + s.ring * way[0],
            s.centre[1] + s.ring * way[1],
            s.centre[2] + s.ring * way[2],
            s.axis[0],
            s.axis[1],
            s.axis[2],
            s.radius,
            s.ring};
}
RoundShape shape_with(RoundKind kind, const Unknowns& x, const Point3& aside) {
    const Point3 axis = unit({x[3], x[4], x[5]}), way = to_tube(axis, aside);
    return {
        kind, {x[0] - x[7] * way[0], x[1] - x[7] * way[1], x[2] - x[7] * way[2]}, axis, x[6], x[7]};
}
// Which of them a kind has: the first so many of these.
constexpr std::array<std::size_t, kUnknowns> kOrder{0, 1, 2, 6, 3, 4, 5, 7};
std::size_t unknown_count(RoundKind kind) {
    return kind == RoundKind::sphere ? 4 : kind == RoundKind::cylinder ? 7 : 8;
}

double squares(const RoundShape& shape, const std::vector<Point3>& points) {
    double sum = 0;
    for (const Point3& p : points) {
        const double d = outside_of(shape, p).distance;
        sum += d * d;
    }
    return sum;
}

// The sphere through points, or the circle through points of a plane, by |p|^2 = 2 c p + k.
struct Ball {
    Point3 centre{};
    double radius = 0;
};
std::optional<Ball> ball_through(const std::vector<Point3>& points, std::size_t dimensions) {
    Rows<4> a{};
    Row<4> b{};
    for (const Point3& p : points) {
        Row<4> row{};
        for (std::size_t k = 0; k < dimensions; ++k) row[k] = 2 * p[k];
        row[dimensions] = 1;
        add_square(a, row);
        for (std::size_t i = 0; i < 4; ++i) b[i] += row[i] * dot(p, p);
    }
    const Row<4> w = solve(a, b, dimensions + 1);
    Ball ball;
    double square = w[dimensions];
    for (std::size_t k = 0; k < dimensions; ++k) {
        ball.centre[k] = w[k];
        square += w[k] * w[k];
    }
    if (!(square > 0) || !std::isfinite(square)) return std::nullopt;
    ball.radius = std::sqrt(square);
    return ball;
}

// Any two directions across an axis and each other.
std::array<Point3, 2> across(const Point3& axis) {
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(axis[k]) < std::abs(axis[least])) least = k;
    Point3 other{};
    other[least] = 1;
    const Point3 u = unit(cross(axis, other));
    return {u, cross(axis, u)};
}

std::optional<RoundShape> cylinder_near(const Patch& patch) {
    Rows<3> a{};
    for (const Patch::Facet& facet : patch.facets) add_square(a, facet.normal);
    const Point3 axis = least_eigen(a).vector;
    const auto [u, v] = across(axis);
    std::vector<Point3> section;
    for (const Point3& p : patch.points) section.push_back({dot(p, u), dot(p, v), 0});
    const auto circle = ball_through(section, 2);
    if (!circle) return std::nullopt;
    RoundShape shape{RoundKind::cylinder, {}, axis, circle->radius, 0};
    for (std::size_t k = 0; k < 3; ++k)
        shape.centre[k] = circle->centre[0] * u[k] + circle->centre[1] * v[k];
    return shape;
}

// The lines along the normals of whatever is turned about an axis meet that axis. With n the
// direction of a line and m its moment, d that of the axis and e its moment, n e + m d = 0.
std::optional<RoundShape> torus_near(const Patch& patch) {
    Rows<6> a{};
    for (const auto& [middle, n] : patch.facets) {
        const Point3 m = cross(middle, n);
        add_square<6>(a,
                      {m[0] / patch.size, m[1] / patch.size, m[2] / patch.size, n[0], n[1], n[2]});
    }
    const Row<6> x = least_eigen(a).vector;
    const Point3 along{x[0], x[1], x[2]};
    const double l = length(along);
    if (!(l > 0)) return std::nullopt;
    const Point3 axis = unit(along);
    const double scale = patch.size / l;
    const Point3 foot = cross(axis, {x[3] * scale, x[4] * scale, x[5] * scale});
    std::vector<Point3> section;  // from the axis, along it
    for (const Point3& p : patch.points) {
        const Point3 q = minus(p, foot);
        const double h = dot(q, axis);
        section.push_back({std::sqrt(std::max(0.0, dot(q, q) - h * h)), h, 0});
    }
    const auto circle = ball_through(section, 2);
    if (!circle) return std::nullopt;
    RoundShape shape{RoundKind::torus, foot, axis, circle->radius, circle->centre[0]};
    for (std::size_t k = 0; k < 3; ++k) shape.centre[k] += circle->centre[1] * axis[k];
    return shape;
}

// The middle line of a cylinder that is bent a little lies off its axis by a + b s + k s^2 / 2, s
// along it; so the cylinder's face lies off by that along its normal.
std::optional<RoundShape> torus_of_bent(RoundShape cylinder, const Patch& patch) {
    refine(cylinder, patch.points, patch.size, 4);
    const auto [u, v] = across(cylinder.axis);
    Rows<7> rows{};
    Row<7> wanted{};
    for (const Point3& p : patch.points) {
        const Outside outside = outside_of(cylinder, p);
        const double s = dot(minus(p, cylinder.centre), cylinder.axis) / patch.size;
        const double x = dot(outside.way, u), y = dot(outside.way, v);
        const Row<7> row{1, x, y, s * x, s * y, s * s / 2 * x, s * s / 2 * y};
        add_square(rows, row);
        for (std::size_t i = 0; i < 7; ++i) wanted[i] += row[i] * outside.distance;
    }
    for (std::size_t i = 0; i < 7; ++i) rows[i][i] *= 1 + 1e-9;
    const Row<7> w = solve(rows, wanted, 7);
    const double k = std::sqrt(w[5] * w[5] + w[6] * w[6]), square = patch.size * patch.size;
    if (!(k * 1000 > patch.size)) return std::nullopt;  // as good as straight
    const double ring = square / k;
    Point3 inwards;
    for (std::size_t i = 0; i < 3; ++i) inwards[i] = (w[5] * u[i] + w[6] * v[i]) / k;
    RoundShape torus{RoundKind::torus, cylinder.centre, cross(cylinder.axis, inwards),
                     cylinder.radius, ring};
    for (std::size_t i = 0; i < 3; ++i) torus.centre[i] += ring * inwards[i];
    return torus;
}

}  // namespace

std::vector<RoundShape> rounds_near(const Patch& patch) {
    std::vector<RoundShape> shapes;
    if (const auto ball = ball_through(patch.points, 3))
        shapes.push_back({RoundKind::sphere, ball->centre, {}, ball->radius, 0});
    const auto cylinder = cylinder_near(patch);
    if (cylinder) shapes.push_back(*cylinder);
    if (const auto torus = torus_near(patch)) shapes.push_back(*torus);
    if (cylinder)
        if (const auto torus = torus_of_bent(*cylinder, patch)) shapes.push_back(*torus);
    return shapes;
}

double refine(RoundShape& shape, const std::vector<Point3>& points, double size, int steps) {
    constexpr double kStep = 1e-6, kDone = 0.999;
    constexpr int kTries = 4;
    const std::size_t n = unknown_count(shape.kind);
    Point3 mean{};
    for (const Point3& p : points)
        for (std::size_t k = 0; k < 3; ++k) mean[k] += p[k] / static_cast<double>(points.size());
    double now = squares(shape, points), damping = 1e-3;
    bool goes_on = true;
    for (int step = 0; step < steps && goes_on; ++step) {
        const Point3 aside = minus(mean, shape.centre);
        const Unknowns x = unknowns_of(shape, aside);
        std::array<RoundShape, kUnknowns> moved;
        std::array<double, kUnknowns> by{};
        for (std::size_t i = 0; i < n; ++i) {
            by[i] = kOrder[i] >= 3 && kOrder[i] < 6 ? kStep : kStep * size;
            Unknowns y = x;
            y[kOrder[i]] += by[i];
            moved[i] = shape_with(shape.kind, y, aside);
        }
        Rows<kUnknowns> a{};
        Unknowns b{};
        for (const Point3& p : points) {
            const double d = outside_of(shape, p).distance;
            Unknowns slope{};
            for (std::size_t i = 0; i < n; ++i)
                slope[i] = (outside_of(moved[i], p).distance - d) / by[i];
            add_square(a, slope);
            for (std::size_t i = 0; i < n; ++i) b[i] -= slope[i] * d;
        }
        goes_on = false;
        for (int tries = 0; tries < kTries; ++tries, damping *= 10) {
            Rows<kUnknowns> damped = a;
            for (std::size_t i = 0; i < n; ++i)
                damped[i][i] += damping * a[i][i] + 1e-12 * (1 + a[i][i]);
            const Unknowns w = solve(damped, b, n);
            Unknowns y = x;
            for (std::size_t i = 0; i < n; ++i) y[kOrder[i]] += w[i];
            const RoundShape then = shape_with(shape.kind, y, aside);
            const double left = squares(then, points);
            if (!(left < now)) continue;
            goes_on = left < now * kDone;
            shape = then;
            now = left;
            damping *= 0.1;
            break;
        }
    }
    return std::sqrt(now / static_cast<double>(points.size()));
}

}  // namespace ravel
