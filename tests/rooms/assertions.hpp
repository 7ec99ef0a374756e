// SPDX-License-Identifier: BSD-3-Clause
// Shared by all tests of single rooms: cmocka for C++, and comparison of numbers.
#pragma once

// cmocka.h needs these headers first.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

extern "C" {
#include <cmocka.h>
}
#undef fail // a macro, but stltsa::fail is a function
#define FAIL(...) (print_error(__VA_ARGS__), print_error("\n"), _fail(__FILE__, __LINE__))

namespace testing {

inline void check_near(double actual, double expected, double tolerance, const char* file,
                       int line) {
    if (actual >= expected - tolerance && actual <= expected + tolerance)
        return;
    print_error("expected %.17g within %g, got %.17g\n", expected, tolerance, actual);
    _fail(file, line);
}
#define ASSERT_NEAR(actual, expected, tolerance)                                                   \
    testing::check_near(actual, expected, tolerance, __FILE__, __LINE__)

} // namespace testing
