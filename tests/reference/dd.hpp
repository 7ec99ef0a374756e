// SPDX-License-Identifier: BSD-3-Clause
// Double-double arithmetic: a number is the unevaluated sum hi + lo with |lo| <= ulp(hi) / 2, about
// 32 decimal digits. Dekker, Numer. Math. 18, 1971; Knuth, TAOCP 2, section 4.2.2; Hida, Li,
// Bailey, "Algorithms for quad-double precision floating point arithmetic", ARITH-15, 2001; error
// bounds: Joldes, Muller, Popescu, ACM TOMS 44, 2017. Needs IEEE rounding and no contraction.
#pragma once

#include <cmath>

#ifdef __FAST_MATH__
#error "double-double arithmetic is destroyed by fast-math"
#endif

namespace reference {

struct dd {
    double hi = 0;
    double lo = 0;

    constexpr dd() = default;
    constexpr dd(double x) : hi(x) {} // implicit: every double is a dd
    constexpr dd(double high, double low) : hi(high), lo(low) {}
    explicit constexpr operator double() const { return hi; }
};

/// a + b exactly (Knuth).
inline dd two_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// a + b exactly, if |a| >= |b| or a = 0 (Dekker).
inline dd quick_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a * b exactly, unless it underflows.
inline dd two_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

inline dd operator-(dd a) {
    return {-a.hi, -a.lo};
}

inline dd operator+(dd a, dd b) {
    dd sum = two_sum(a.hi, b.hi);
    const dd tail = two_sum(a.lo, b.lo);
    sum = quick_two_sum(sum.hi, sum.lo + tail.hi);
    return quick_two_sum(sum.hi, sum.lo + tail.lo);
}

inline dd operator-(dd a, dd b) {
    return a + -b;
}

inline dd operator*(dd a, dd b) {
    const dd product = two_product(a.hi, b.hi);
    return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// Long division with two digits of 53 bits.
inline dd operator/(dd a, dd b) {
    const double first = a.hi / b.hi;
    const double second = (a - b * first).hi / b.hi;
    return quick_two_sum(first, second);
}

inline dd& operator+=(dd& a, dd b) {
    return a = a + b;
}
inline dd& operator-=(dd& a, dd b) {
    return a = a - b;
}
inline dd& operator*=(dd& a, dd b) {
    return a = a * b;
}
inline dd& operator/=(dd& a, dd b) {
    return a = a / b;
}

inline bool operator==(dd a, dd b) {
    return a.hi == b.hi && a.lo == b.lo;
}
inline bool operator<(dd a, dd b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}
inline bool operator>(dd a, dd b) {
    return b < a;
}
inline bool operator<=(dd a, dd b) {
    return !(b < a);
}
inline bool operator>=(dd a, dd b) {
    return !(a < b);
}

inline dd abs(dd a) {
    return a.hi < 0 ? -a : a;
}

/// One Newton step from the double root doubles its 53 digits (Karp's form).
inline dd sqrt(dd a) {
    if (a.hi <= 0)
        return std::sqrt(a.hi); // 0, or the NaN of a negative number
    const double root = std::sqrt(a.hi);
    return two_sum(root, (a - two_product(root, root)).hi / (2 * root));
}

} // namespace reference
