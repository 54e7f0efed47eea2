// How much each known value around an element counts in the guess of its value. Places are known
// when values are coded, so the guess follows them: a base (a parallelogram where the mesh has one,
// else the mean of what is near) is carried from where the base lies to where the element lies,
// along the slope of the known values. The slope is a least-squares fit weighted by nearness
// [LancasterSalkauskas1981], held by a small ridge where the places don't tell it.
#pragma once

#include <array>
#include <cmath>

#include "predict/around.h"

namespace ravel {

// The last: values are normals of the surface.
enum class Guess : std::uint8_t { nearest, mean, linear, normal };

using Shares = std::array<double, kMostBeside>;

namespace detail {

// Solves the symmetric system A s = b; A is positive.
inline Point3 solve3(std::array<Point3, 3> a, Point3 b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t r = i + 1; r < 3; ++r) {
            const double f = a[r][i] / a[i][i];
            for (std::size_t c = i; c < 3; ++c) a[r][c] -= f * a[i][c];
            b[r] -= f * b[i];
        }
    for (std::size_t i = 3; i-- > 0;) {
        for (std::size_t c = i + 1; c < 3; ++c) b[i] -= a[i][c] * b[c];
        b[i] /= a[i][i];
    }
    return b;
}

}  // namespace detail

// Constant time. The shares of a linear guess sum to 1, but for rounding.
inline Shares shares_of(Guess guess, const Beside& beside, const Around& around, Id element) {
    Shares shares{};
    const std::size_t n = beside.count;
    if (n == 0) return shares;
    if (guess == Guess::nearest || guess == Guess::normal) {
        shares[0] = 1;
        return shares;
    }
    if (guess == Guess::mean) {
        for (std::size_t i = 0; i < n; ++i) shares[i] = 1 / static_cast<double>(n);
        return shares;
    }
    const Point3 here = around.place(element);
    std::array<Point3, kMostBeside> way;
    double nearest = 0, based = 0;
    for (std::size_t i = 0; i < n; ++i) {
        way[i] = minus(around.place(beside.at[i]), here);
        const double square = dot(way[i], way[i]);
        if (i == 0 || square < nearest) nearest = square;
        based += beside.share[i];
    }
    Shares weight;
    double all = 0;
    Point3 middle{};
    for (std::size_t i = 0; i < n; ++i) {
        weight[i] = 1 / (dot(way[i], way[i]) + nearest / 8);
        all += weight[i];
        for (std::size_t k = 0; k < 3; ++k) middle[k] += weight[i] * way[i][k];
    }
    for (double& x : middle) x /= all;
    std::array<Point3, 3> spread{};
    for (std::size_t i = 0; i < n; ++i) {
        const Point3 e = minus(way[i], middle);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c) spread[r][c] += weight[i] * e[r] * e[c];
    }
    const double ridge = (spread[0][0] + spread[1][1] + spread[2][2]) / 8192;
    for (std::size_t k = 0; k < 3; ++k) spread[k][k] += ridge;
    // From where the base lies to the element.
    Point3 carry{};
    for (std::size_t i = 0; i < n; ++i) {
        shares[i] = based > 0 ? beside.share[i] / based : weight[i] / all;
        for (std::size_t k = 0; k < 3; ++k) carry[k] -= shares[i] * way[i][k];
    }
    const Point3 slope = detail::solve3(spread, carry);
    for (std::size_t i = 0; i < n; ++i) {
        const double more = weight[i] * dot(minus(way[i], middle), slope);
        // Places that are equal, or not finite, tell of no slope.
        if (std::isfinite(more)) shares[i] += more;
        if (!std::isfinite(shares[i])) shares[i] = i == 0;
    }
    return shares;
}

}  // namespace ravel
