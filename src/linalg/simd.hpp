// SPDX-License-Identifier: BSD-3-Clause
// Loops over two rows with eight partial sums in fixed order, which the compiler vectorizes for the
// baseline of the build without reordering sums. The most expensive loops of a fit use packs
// (pack.hpp).
#pragma once

#include <cstdint>

namespace stltsa {

inline constexpr std::int64_t lanes = 8;

inline double sum_lanes(const double (&s)[lanes]) {
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

/// Sum of term(i) over i < count.
template <class Term>
double sum_of(std::int64_t count, const Term& term) {
    double s[lanes] = {};
    std::int64_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::int64_t l = 0; l < lanes; ++l)
            s[l] += term(i + l);
    for (std::int64_t l = 0; i < count; ++i, ++l)
        s[l] += term(i);
    return sum_lanes(s);
}

/// squared_distance() of rows of eight, without a call.
[[gnu::always_inline]] inline double squared_distance_of_lanes(const double* a, const double* b) {
    double s[lanes];
    for (std::int64_t l = 0; l < lanes; ++l) {
        const double d = a[l] - b[l];
        s[l] = d * d;
    }
    return sum_lanes(s);
}

/// |a - b|^2 by subtraction: exactly zero for equal frames, without cancellation of large norms.
inline double squared_distance(const double* a, const double* b, std::int64_t count) {
    return sum_of(count, [=](std::int64_t i) {
        const double d = a[i] - b[i];
        return d * d;
    });
}

inline double dot(const double* a, const double* b, std::int64_t count) {
    return sum_of(count, [=](std::int64_t i) { return a[i] * b[i]; });
}

inline double sum(const double* a, std::int64_t count) {
    return sum_of(count, [=](std::int64_t i) { return a[i]; });
}

/// y += alpha x
inline void axpy(double alpha, const double* x, double* y, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i)
        y[i] += alpha * x[i];
}

} // namespace stltsa
