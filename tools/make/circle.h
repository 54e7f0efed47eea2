// Points on the unit circle from +, -, * alone: the C library's sine differs between machines in
// the last bit, and a corpus mesh must not.
#pragma once

namespace ravel::make {

struct CirclePoint {
    double cosine = 1;
    double sine = 0;
};

// The point after `turns` full turns. Correct to about 1e-15.
CirclePoint circle_point(double turns);

}  // namespace ravel::make
