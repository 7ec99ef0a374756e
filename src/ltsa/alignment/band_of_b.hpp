// SPDX-License-Identifier: BSD-3-Clause
// Builds the alignment matrix B (Table 1, step 4) in differences z_c = x_{c+1} - x_c as a band
// matrix: B' = S^T B S, with S the running sum.
#pragma once

#include <cstdint>

#include "linalg/band.hpp"
#include "ltsa/alignment/patches.hpp"

namespace stltsa::ltsa {

/// Subdiagonals of B'.
std::int64_t bandwidth_of(const Patches& patches);

/// Table 1, step 4: b := B'. Sums are in the same order for any number of threads.
void assemble_b(const Patches& patches, int threads, BandMatrix& b);

} // namespace stltsa::ltsa
