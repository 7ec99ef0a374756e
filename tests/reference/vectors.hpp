// SPDX-License-Identifier: BSD-3-Clause
// Loops over independent entries, which the compiler vectorizes. Nearly all of the time is spent
// here.
#pragma once

#include <cstddef>

#include "scalar.hpp"

namespace reference {

/// y += a x
template <class T>
void add_scaled(T* y, T a, const T* x, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i)
        y[i] += a * x[i];
}

template <class T>
T inner(const T* a, const T* b, std::size_t n) {
    constexpr std::size_t lanes = 8;
    T sums[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= n; i += lanes)
        for (std::size_t l = 0; l < lanes; ++l)
            sums[l] += a[i + l] * b[i + l];
    for (std::size_t l = 0; i < n; ++i, ++l)
        sums[l] += a[i] * b[i];
    for (std::size_t l = 1; l < lanes; ++l)
        sums[0] += sums[l];
    return sums[0];
}

} // namespace reference
