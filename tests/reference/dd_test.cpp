// SPDX-License-Identifier: BSD-3-Clause
// Compares double-double arithmetic with binary128, and checks exact identities.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "scalar.hpp"
#include "synthetic.hpp"

namespace {

using reference::dd;
using reference::Random;

int failures = 0;

void check(bool ok, const char* what, dd a, dd b) {
    if (ok)
        return;
    ++failures;
    std::fprintf(stderr, "FAILED %s: a = %a + %a, b = %a + %a\n", what, a.hi, a.lo, b.hi, b.lo);
}

/// A random number of either sign with a magnitude of 2^-21 .. 2^20.
double number(Random& random) {
    const double mantissa = 0.5 + 0.5 * random.uniform();
    const int exponent = static_cast<int>(random.bits() % 41) - 20;
    return std::ldexp(random.bits() & 1 ? mantissa : -mantissa, exponent);
}

dd wide(Random& random) {
    const double high = number(random);
    return reference::quick_two_sum(high, high * 0x1p-54 * (number(random) * 0x1p-20));
}

void exact_identities(dd a, dd b) {
    check(a - a == dd(0), "a - a = 0", a, b);
    check(a + b == b + a, "a + b = b + a", a, b);
    check(a * b == b * a, "a * b = b * a", a, b);
    check(a / a == dd(1), "a / a = 1", a, b);
    check(-(a - b) == b - a, "-(a - b) = b - a", a, b);
    check((a < b) == (b > a) && (a <= b) == !(a > b), "order", a, b);
    check(abs(a) >= dd(0) && abs(a) == abs(-a), "absolute value", a, b);
    check(sqrt(dd(a.hi) * dd(a.hi)) == abs(dd(a.hi)), "sqrt(a^2) = |a|", a, b);
    const dd sum = reference::two_sum(a.hi, b.hi);
    check(sum - dd(a.hi) == dd(b.hi), "two_sum is exact", a, b);
}

/// 1 + 2^-80 is not representable in double or long double, but must be here.
void known_values() {
    const dd tiny = dd(0x1p-80);
    check((dd(1) + tiny) - dd(1) == tiny, "1 + 2^-80 - 1", dd(1), tiny);
    check((dd(1) + tiny) * (dd(1) - tiny) == dd(1), "(1 + e)(1 - e) = 1 to 2^-160", dd(1), tiny);
    check(reference::dd(1) < dd(1) + tiny, "1 < 1 + 2^-80", dd(1), tiny);
    const dd third = dd(1) / dd(3);
    check(third.hi == 1.0 / 3.0 && third.lo == 0x1.5555555555555p-56, "1 / 3", dd(1), dd(3));
}

#ifdef REFERENCE_QUAD
using reference::quad;

quad exactly(dd a) {
    return static_cast<quad>(a.hi) + static_cast<quad>(a.lo);
}

/// High parts first: before they cancel, a sum may need more than 113 bits.
quad exact_sum(dd a, dd b) {
    return (static_cast<quad>(a.hi) + static_cast<quad>(b.hi)) +
           (static_cast<quad>(a.lo) + static_cast<quad>(b.lo));
}

/// The proven bounds are below 10 u^2, u = 2^-53; binary128 itself adds 2^-113.
void check_close(dd got, quad want, const char* what, dd a, dd b) {
    const quad error = reference::abs(exactly(got) - want);
    check(error <= reference::abs(want) * static_cast<quad>(10 * 0x1p-106), what, a, b);
}

void against_binary128(dd a, dd b) {
    const quad x = exactly(a);
    const quad y = exactly(b);
    check_close(a + b, exact_sum(a, b), "a + b", a, b);
    check_close(a - b, exact_sum(a, -b), "a - b", a, b);
    check_close(a * b, x * y, "a * b", a, b);
    check_close(a / b, x / y, "a / b", a, b);
    check_close(sqrt(abs(a)), reference::sqrt(reference::abs(x)), "sqrt(|a|)", a, b);
}
#endif

} // namespace

int main() {
    known_values();
    Random random(1);
    for (int i = 0; i < 200000; ++i) {
        const dd a = wide(random);
        const dd b = i % 4 == 0 ? a * dd(1 + 0x1p-40 * number(random)) : wide(random);
        exact_identities(a, b);
#ifdef REFERENCE_QUAD
        against_binary128(a, b);
#endif
        if (failures > 10)
            break;
    }
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
