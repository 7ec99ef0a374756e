// SPDX-License-Identifier: BSD-3-Clause
// What patches add to B' = S^T B S, the alignment matrix in differences z_c = x_{c+1} - x_c (S the
// running sum). Every row of (I - e e^T/k - G G^T) sums to zero, so it can be written down patch by
// patch: for frames p_0 < ... < p_{k-1} and p_0 <= c <= c' < p_{k-1}, with a(c) the number of
// frames beyond c and h_l(c) the sum of g_l over them,
//     B'(c', c) += a(c') (k - a(c)) / k - sum_l h_l(c') h_l(c).
#pragma once

#include <cstdint>
#include <vector>

#include "linalg/block_envelope.hpp"
#include "linalg/envelope.hpp"
#include "ltsa/patches.hpp"

namespace stltsa::ltsa {

/// Read backwards, a patch is one of the clip read backwards: what is beyond a difference then is
/// what was before it.
enum class Order { of_time, reversed };

/// Writes a at the differences that a patch covers.
void spread_counts(const Patches& patches, std::int64_t patch, Order order, double* to);

/// Writes h_0, h_1, ..., each `stride` entries after the one before.
void spread_directions(const Patches& patches, std::int64_t patch, Order order, double* to,
                       std::int64_t stride);

/// The last row of each column of B'.
using Envelope = std::vector<std::int64_t>;
Envelope envelope_of(const Patches& patches, const Machine& machine);

/// matrix = B', for narrow bands and for wide ones. Every entry receives the patches in the same
/// order whatever the number of threads.
void assemble(const Patches& patches, const Machine& machine, EnvelopeMatrix& matrix);
void assemble(const Patches& patches, const Machine& machine, BlockEnvelopeMatrix& matrix);

} // namespace stltsa::ltsa
