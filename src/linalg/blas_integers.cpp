// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/blas_integers.hpp"

#include <cstddef>
#include <cstdint>

#include "base/error.hpp"

// Declared here because the headers declare other integer types.
extern "C" {
double ddot_(const std::int32_t* count, const double* x, const std::int32_t* step_of_x,
             const double* y, const std::int32_t* step_of_y);
void dlacpy_(const char* part, const std::int32_t* rows, const std::int32_t* cols, const double* a,
             const std::int32_t* stride_of_a, double* b, const std::int32_t* stride_of_b,
             std::size_t);
}

namespace stltsa {
namespace {

/// 2 and 1 as 32-bit integers; read as 64-bit integers, the first is negative, so the functions do
/// nothing.
constexpr std::int32_t two_or_negative[] = {2, -1};
constexpr std::int32_t one[] = {1, 0};
constexpr std::int32_t two[] = {2, 0};

bool blas_is_32_bit() {
    const double x[] = {3, 4};
    return ddot_(two_or_negative, x, one, x, one) == 25;
}

bool lapack_is_32_bit() {
    const double from[] = {3, 4};
    double to[] = {0, 0};
    dlacpy_("A", two_or_negative, one, from, two, to, two, 1);
    return to[0] == 3 && to[1] == 4;
}

} // namespace

void check_blas_integers() {
    if (!blas_is_32_bit() || !lapack_is_32_bit())
        fail(Status::unsupported,
             "the {} library that this process loaded takes 64-bit integers (ILP64), but libstltsa "
             "needs one with 32-bit integers: check LD_LIBRARY_PATH and LD_PRELOAD",
             blas_is_32_bit() ? "LAPACK" : "BLAS");
}

} // namespace stltsa
