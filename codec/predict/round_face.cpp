#include "predict/round_face.h"

#include <cmath>

namespace ravel {

RoundShape shape_of(const RoundFace& face) {
    RoundShape shape{face.kind,
                     {},
                     {},
                     static_cast<double>(face.radius) / 16,
                     static_cast<double>(face.ring) / 16};
    for (std::size_t k = 0; k < 3; ++k) {
        shape.centre[k] = static_cast<double>(face.centre[k]) / 16;
        shape.axis[k] = static_cast<double>(face.axis[k]);
    }
    shape.axis = unit(shape.axis);
    return shape;
}

Outside outside_of(const RoundShape& shape, const Point3& p) {
    Point3 q = minus(p, shape.centre);
    double h = 0;
    if (shape.kind != RoundKind::sphere) {
        h = dot(q, shape.axis);
        for (std::size_t k = 0; k < 3; ++k) q[k] = q[k] - h * shape.axis[k];
    }
    const double l = length(q);
    q = unit(q);
    if (shape.kind != RoundKind::torus) return {l - shape.radius, q};
    const double s = l - shape.ring, t = std::sqrt(s * s + h * h);
    for (std::size_t k = 0; k < 3; ++k) q[k] = t > 0 ? (s * q[k] + h * shape.axis[k]) / t : 0;
    return {t - shape.radius, q};
}

Point3 moved_onto(const RoundShape& shape, const Point3& p) {
    const Outside outside = outside_of(shape, p);
    Point3 q;
    for (std::size_t k = 0; k < 3; ++k) q[k] = p[k] - outside.distance * outside.way[k];
    return q;
}

double coordinate_on(const RoundShape& shape, Point3 p, std::size_t axis) {
    constexpr int kSteps = 8;
    constexpr double kSteep = 1.0 / 16, kNear = 1.0 / 16;
    const double start = p[axis];
    for (int i = 0; i < kSteps; ++i) {
        const Outside outside = outside_of(shape, p);
        if (std::abs(outside.way[axis]) < kSteep) return start;
        const double step = outside.distance / outside.way[axis];
        p[axis] = p[axis] - step;
        if (std::abs(step) < kNear) return p[axis];
    }
    return start;
}

}  // namespace ravel
