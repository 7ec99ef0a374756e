// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/least_squares.hpp"

#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

namespace stltsa::motion {

std::vector<double> least_squares(ConstMatrixView a, std::span<const double> b, double ridge) {
    const std::int64_t n = a.cols;
    TopEigenpairs normal(n, n);
    std::vector<double> right(static_cast<std::size_t>(n));
    Matrix squares(n, n);
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(b.size()); ++i) {
        axpy(b[static_cast<std::size_t>(i)], a.row(i), right.data(), n);
        for (std::int64_t c = 0; c < n; ++c)
            axpy(a(i, c), a.row(i), squares.row(c), c + 1);
    }
    double trace = 0;
    for (std::int64_t c = 0; c < n; ++c) {
        trace += squares(c, c);
        for (std::int64_t r = c; r < n; ++r)
            normal.matrix()[r + c * n] = squares(r, c);
    }
    normal.solve();
    // Directions without variance are left out.
    constexpr double rounding = 1e-12;
    std::vector<double> x(right.size());
    for (std::int64_t p = 0; p < n; ++p) {
        const double value = normal.value(p) + ridge * trace / static_cast<double>(n);
        if (value > rounding * normal.value(0))
            axpy(dot(normal.vector(p), right.data(), n) / value, normal.vector(p), x.data(), n);
    }
    return x;
}

} // namespace stltsa::motion
