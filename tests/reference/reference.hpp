// SPDX-License-Identifier: BSD-3-Clause
// STLTSA once more, plainly, in any precision: double-double is the truth the library is measured
// against, double shows what plain arithmetic gives.
#pragma once

#include <cstddef>
#include <vector>

#include "subspace.hpp"

namespace reference {

/// Embeddings of dimension 1 .. most from the same frames and neighbors; element d - 1 has
/// dimension d. Throws std::runtime_error for a disconnected or rank-deficient problem.
template <class T>
std::vector<Spectrum<T>> embed(const Frames& frames, const Neighbors& neighbors, std::size_t most);

} // namespace reference
