// SPDX-License-Identifier: BSD-3-Clause
// A BLAS with 64-bit integers is refused before it is used.
#include "../assertions.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "base/error.hpp"
#include "linalg/blas_integers.hpp"

namespace {

/// Whether the functions below take integers of 8 bytes instead of 4.
bool long_blas = false, long_lapack = false;

std::int64_t integer(const std::int32_t* at, bool is_long) {
    std::int64_t value = *at;
    if (is_long)
        std::memcpy(&value, at, sizeof value);
    return value;
}

} // namespace

// These replace the functions of the same names in BLAS and LAPACK.
extern "C" {
double ddot_(const std::int32_t* count, const double* x, const std::int32_t*, const double* y,
             const std::int32_t*) {
    double sum = 0;
    for (std::int64_t i = 0; i < integer(count, long_blas); ++i)
        sum += x[i] * y[i];
    return sum;
}
void dlacpy_(const char*, const std::int32_t* rows, const std::int32_t*, const double* a,
             const std::int32_t*, double* b, const std::int32_t*, std::size_t) {
    for (std::int64_t i = 0; i < integer(rows, long_lapack); ++i)
        b[i] = a[i];
}
}

namespace {

void sixty_four_bits_are_refused(void**) {
    stltsa::check_blas_integers();
    const auto text_with = [](bool blas, bool lapack) -> std::string {
        long_blas = blas;
        long_lapack = lapack;
        try {
            stltsa::check_blas_integers();
        } catch (const stltsa::Error& error) {
            assert_true(error.status() == stltsa::Status::unsupported);
            return error.what();
        }
        return "";
    };
    assert_non_null(std::strstr(text_with(true, true).c_str(), "the BLAS library that"));
    assert_non_null(std::strstr(text_with(false, true).c_str(), "the LAPACK library that"));
    assert_true(text_with(false, false).empty());
}

} // namespace

int main() {
    const CMUnitTest tests[] = {cmocka_unit_test(sixty_four_bits_are_refused)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
