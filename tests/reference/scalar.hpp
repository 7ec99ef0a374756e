// SPDX-License-Identifier: BSD-3-Clause
// Scalars for the templates of this folder: double, double-double and, as a second opinion, IEEE
// binary128 if the compiler supports it.
#pragma once

#include <cfloat>
#include <cmath>

#include "dd.hpp"

namespace reference {

inline double abs(double a) {
    return std::abs(a);
}
inline double sqrt(double a) {
    return std::sqrt(a);
}

/// Off-diagonal entries below this share of the norm count as zero.
template <class T>
inline constexpr double negligible = 0;
template <>
inline constexpr double negligible<double> = 1e-17;
template <>
inline constexpr double negligible<dd> = 1e-33;

#if defined(__SIZEOF_FLOAT128__)
#define REFERENCE_QUAD 1
__extension__ typedef __float128 quad;
#elif LDBL_MANT_DIG == 113
#define REFERENCE_QUAD 1
using quad = long double;
#endif

#ifdef REFERENCE_QUAD
inline quad abs(quad a) {
    return a < 0 ? -a : a;
}

/// Two Newton steps from the root in double: 53, 106, 212 digits.
inline quad sqrt(quad a) {
    if (a <= 0)
        return 0;
    quad root = std::sqrt(static_cast<double>(a));
    for (int step = 0; step < 2; ++step)
        root = (root + a / root) / 2;
    return root;
}

template <>
inline constexpr double negligible<quad> = 1e-34;
#endif

} // namespace reference
