#include "make/circle.h"

#include <cmath>

namespace ravel::make {

CirclePoint circle_point(double turns) {
    const double eighths = std::floor(turns * 8 + 0.5);
    const double angle = (turns * 8 - eighths) * 0.78539816339744830962;  // within 22.5 degrees
    const double square = angle * angle;
    double sine = 0, cosine = 0;
    for (int k = 17; k >= 3; k -= 2) sine = (1 + sine) * -square / (k * (k - 1));
    for (int k = 18; k >= 2; k -= 2) cosine = (1 + cosine) * -square / (k * (k - 1));
    CirclePoint point{1 + cosine, angle * (1 + sine)};
    const double diagonal = 0.70710678118654752440;
    const auto eighth = static_cast<long long>(eighths);
    for (long long i = ((eighth % 8) + 8) % 8; i > 0; --i)
        point = {(point.cosine - point.sine) * diagonal, (point.cosine + point.sine) * diagonal};
    return point;
}

}  // namespace ravel::make
