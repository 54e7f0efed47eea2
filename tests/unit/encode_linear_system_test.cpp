#include "encode/linear_system.h"

#include <catch2/catch.hpp>

#include <random>

using namespace ravel;

namespace {

// The sum of so many random rows' squares.
template <std::size_t N>
Rows<N> squares(std::mt19937& random, int rows) {
    Rows<N> a{};
    for (int i = 0; i < rows; ++i) {
        Row<N> row;
        for (double& x : row) x = static_cast<double>(random() % 2001) / 1000 - 1;
        add_square(a, row);
    }
    return a;
}

template <std::size_t N>
Row<N> product(const Rows<N>& a, const Row<N>& x) {
    Row<N> y{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) y[i] += a[i][j] * x[j];
    return y;
}

}  // namespace

TEST_CASE("what solves a system gives its right side") {
    std::mt19937 random(1);
    for (int round = 0; round < 50; ++round) {
        const Rows<6> a = squares<6>(random, 20);
        Row<6> wanted;
        for (double& x : wanted) x = static_cast<double>(random() % 100);
        const Row<6> got = product(a, solve(a, wanted, 6));
        for (std::size_t i = 0; i < 6; ++i) CHECK(got[i] == Approx(wanted[i]).margin(1e-8));
    }
}

TEST_CASE("the least eigenvector is stretched by its value, and no vector by less") {
    std::mt19937 random(2);
    for (int round = 0; round < 50; ++round) {
        // Fewer rows than unknowns: the least value is 0.
        const int rows = round % 5 == 0 ? 4 : 12;
        const Rows<6> a = squares<6>(random, rows);
        const LeastEigen<6> least = least_eigen(a);
        const Row<6> stretched = product(a, least.vector);
        double square = 0;
        for (std::size_t i = 0; i < 6; ++i) {
            CHECK(stretched[i] == Approx(least.value * least.vector[i]).margin(1e-9));
            square += least.vector[i] * least.vector[i];
        }
        CHECK(square == Approx(1));
        if (rows == 4) CHECK(least.value == Approx(0).margin(1e-9));
        for (int other = 0; other < 20; ++other) {
            Row<6> x;
            double all = 0, by = 0;
            for (double& v : x) v = static_cast<double>(random() % 2001) / 1000 - 1;
            const Row<6> y = product(a, x);
            for (std::size_t i = 0; i < 6; ++i) all += x[i] * x[i], by += x[i] * y[i];
            CHECK(by >= least.value * all - 1e-9);
        }
    }
}
