// Fits a sphere, a cylinder or a torus to points.
#pragma once

#include <vector>

#include "predict/round_face.h"

namespace ravel {

// A piece of a surface, about a point near it; `size`: how far off that point it reaches.
struct Patch {
    struct Facet {
        Point3 middle, normal;  // of length 1, either way
    };
    std::vector<Point3> points;
    std::vector<Facet> facets;
    double size = 0;
};

// Shapes that come near the patch, the simplest first: the sphere and the circle of the cylinder by
// linear least squares, the cylinder's axis across the facets' normals; a torus whose axis meets
// the lines along the normals best, and one that is the cylinder, bent.
std::vector<RoundShape> rounds_near(const Patch& patch);

// Least squares of how far off the points are, by Levenberg and Marquardt's method in at most
// `steps` steps; `size` is about that of the points' box. Returns the root of the mean square.
// O(steps * points).
double refine(RoundShape& shape, const std::vector<Point3>& points, double size, int steps);

}  // namespace ravel
