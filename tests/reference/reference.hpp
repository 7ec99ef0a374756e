// SPDX-License-Identifier: BSD-3-Clause
// STLTSA once more, plainly, in any precision: double-double is the truth the library is measured
// against, double shows what plain arithmetic gives. All of it throws std::runtime_error for a
// disconnected or rank-deficient problem.
#pragma once

#include <cstddef>
#include <optional>

#include "local.hpp"
#include "subspace.hpp"

namespace reference {

/// Of the first d dimensions; one call serves embeddings of 1 .. d.
template <class T>
Tangents<T> local_tangents(const Frames& frames, const Neighbors& neighbors, std::size_t d);

/// The embedding of dimension d, by Cholesky's factor of B'.
template <class T>
Spectrum<T> embed(const Neighbors& neighbors, const Tangents<T>& tangents, std::size_t d);

/// The same by an orthogonal triangularization, without B'.
Spectrum<double> embed_by_rotations(const Neighbors& neighbors, const Tangents<double>& tangents,
                                    std::size_t d);

/// What is usual: B itself, assembled, plus a shift on its diagonal, factored by LAPACK, and
/// ARPACK on its inverse; d x frames. Nothing where the factor does not exist or ARPACK does not
/// converge.
std::optional<Table<double>> embed_by_shift(const Neighbors& neighbors,
                                            const Tangents<double>& tangents, std::size_t d,
                                            double shift);

} // namespace reference
