// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/blas_integers.hpp"

#include <cstdint>

#include <lapacke.h>

#include "base/error.hpp"

// Declared here because cblas.h takes integers by value.
extern "C" double ddot_(const std::int32_t* count, const double* x, const std::int32_t* step_of_x,
                        const double* y, const std::int32_t* step_of_y);

namespace stltsa {
namespace {

bool blas_is_32_bit() {
    // Read as a 64-bit integer, the number of elements is negative, and the function returns 0.
    constexpr std::int32_t two_or_negative[] = {2, -1}, one[] = {1, 0};
    const double x[] = {3, 4};
    return ddot_(two_or_negative, x, one, x, one) == 25;
}

bool lapack_is_32_bit() {
    constexpr lapack_int kept = -1;
    lapack_int version[3][2] = {{0, kept}, {0, kept}, {0, kept}};
    LAPACKE_ilaver(version[0], version[1], version[2]); // 64-bit integers overwrite two entries
    return version[0][1] == kept && version[1][1] == kept && version[2][1] == kept;
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
