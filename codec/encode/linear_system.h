// Small symmetric linear systems.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace ravel {

template <std::size_t N>
using Row = std::array<double, N>;
template <std::size_t N>
using Rows = std::array<Row<N>, N>;

// Solves A w = b by elimination, A being n by n, symmetric and positive definite.
template <std::size_t N>
Row<N> solve(Rows<N> a, Row<N> b, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t r = i + 1; r < n; ++r) {
            const double f = a[r][i] / a[i][i];
            for (std::size_t c = i; c < n; ++c) a[r][c] -= f * a[i][c];
            b[r] -= f * b[i];
        }
    Row<N> w{};
    for (std::size_t i = n; i-- > 0;) {
        double sum = b[i];
        for (std::size_t c = i + 1; c < n; ++c) sum -= a[i][c] * w[c];
        w[i] = sum / a[i][i];
    }
    return w;
}

// Adds the product of a row with itself.
template <std::size_t N>
void add_square(Rows<N>& a, const Row<N>& row) {
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) a[i][j] += row[i] * row[j];
}

// The least eigenvalue of a symmetric matrix and its vector, by Jacobi's rotations.
template <std::size_t N>
struct LeastEigen {
    double value = 0;
    Row<N> vector{};
};
template <std::size_t N>
LeastEigen<N> least_eigen(Rows<N> a) {
    constexpr int kSweeps = 12;
    Rows<N> v{};  // columns are vectors
    for (std::size_t i = 0; i < N; ++i) v[i][i] = 1;
    const auto turn = [](double& x, double& y, double c, double s) {
        const double was = x;
        x = c * was - s * y;
        y = s * was + c * y;
    };
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (std::size_t p = 0; p < N; ++p)
            for (std::size_t q = p + 1; q < N; ++q) {
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t =
                    (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                for (std::size_t k = 0; k < N; ++k) turn(a[k][p], a[k][q], c, s);
                for (std::size_t k = 0; k < N; ++k) turn(a[p][k], a[q][k], c, s);
                for (std::size_t k = 0; k < N; ++k) turn(v[k][p], v[k][q], c, s);
            }
    std::size_t least = 0;
    for (std::size_t i = 1; i < N; ++i)
        if (a[i][i] < a[least][least]) least = i;
    LeastEigen<N> found{a[least][least], {}};
    for (std::size_t i = 0; i < N; ++i) found.vector[i] = v[i][least];
    return found;
}

}  // namespace ravel
