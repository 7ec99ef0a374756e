// SPDX-License-Identifier: BSD-3-Clause
// A plain second implementation of STLTSA for any scalar type. In double-double it is the exact
// result that the library is compared with; in double it shows the accuracy of plain arithmetic.
// All functions throw std::runtime_error if the problem is disconnected or rank-deficient.
#pragma once

#include <cstddef>
#include <optional>

#include "local.hpp"
#include "subspace.hpp"

namespace reference {

/// Tangents of the first d dimensions; one call serves embeddings of 1 .. d.
template <class T>
Tangents<T> local_tangents(const Frames& frames, const Neighbors& neighbors, std::size_t d);

/// The embedding of dimension d, from the Cholesky factor of B'.
template <class T>
Spectrum<T> embed(const Neighbors& neighbors, const Tangents<T>& tangents, std::size_t d);

/// The same embedding from an orthogonal triangularization, without forming B'.
Spectrum<double> embed_by_rotations(const Neighbors& neighbors, const Tangents<double>& tangents,
                                    std::size_t d);

/// The usual algorithm: assembles B, adds a shift to its diagonal, factors it with LAPACK and runs
/// ARPACK on the inverse; d x frames. Empty if the factorization fails or ARPACK does not converge.
std::optional<Table<double>> embed_by_shift(const Neighbors& neighbors,
                                            const Tangents<double>& tangents, std::size_t d,
                                            double shift);

} // namespace reference
