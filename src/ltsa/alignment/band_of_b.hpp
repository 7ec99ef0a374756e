// SPDX-License-Identifier: BSD-3-Clause
// B of Table 1, step 4, in differences z_c = x_{c+1} - x_c: B' = S^T B S, with S the running sum.
#pragma once

#include <cstdint>

#include "linalg/band.hpp"
#include "ltsa/alignment/patches.hpp"

namespace stltsa::ltsa {

/// How far B' reaches beside its diagonal.
std::int64_t reach_of(const Patches& patches);

/// b := B'. Every entry is summed in the same order for any number of threads.
void assemble(const Patches& patches, int threads, BandMatrix& b);

} // namespace stltsa::ltsa
