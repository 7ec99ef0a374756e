// SPDX-License-Identifier: BSD-3-Clause
// A BLAS with 64-bit integers is refused before it is used.
#include "../assertions.hpp"

#include <cstdint>
#include <cstring>
#include <string>

#include "base/error.hpp"
#include "linalg/blas_integers.hpp"

namespace {

/// Whether the functions below take integers of 8 bytes instead of 4.
bool long_blas = false, long_lapack = false;

} // namespace

// These replace the functions of the same names in BLAS and LAPACK, also for LAPACKE.
extern "C" {
[[gnu::visibility("default")]] double ddot_(const std::int32_t* count, const double* x,
                                            const std::int32_t*, const double* y,
                                            const std::int32_t*) {
    std::int64_t elements = *count;
    if (long_blas)
        std::memcpy(&elements, count, sizeof elements);
    double sum = 0;
    for (std::int64_t i = 0; i < elements; ++i)
        sum += x[i] * y[i];
    return sum;
}
[[gnu::visibility("default")]] void ilaver_(std::int32_t* major, std::int32_t* minor,
                                            std::int32_t* patch) {
    const std::int64_t number = 3;
    for (std::int32_t* part : {major, minor, patch})
        std::memcpy(part, &number, long_lapack ? sizeof number : sizeof *part);
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
