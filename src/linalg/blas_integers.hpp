// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace stltsa {

/// Throws Status::unsupported if the BLAS or LAPACK that the process loaded takes 64-bit integers:
/// another build of the same names, such as OpenBLAS with INTERFACE64, would read beyond each
/// integer, and answer with garbage or crash. Takes some nanoseconds.
void check_blas_integers();

} // namespace stltsa
