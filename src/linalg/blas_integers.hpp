// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace stltsa {

/// Throws Status::unsupported if the BLAS or LAPACK that the process loaded takes 64-bit integers.
/// Such a build with the same symbol names, for example OpenBLAS with INTERFACE64, would read
/// beyond each integer and return wrong results or crash. Takes a few nanoseconds.
void check_blas_integers();

} // namespace stltsa
