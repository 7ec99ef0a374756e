// SPDX-License-Identifier: BSD-3-Clause
#include "reference.hpp"

#include <cmath>

#include "qr.hpp"

namespace reference {
namespace {

/// The iteration ends when a step turns the space by less than this angle. It is above the rounding
/// error of one application of the inverse, about (condition of B') * (rounding unit).
template <class T>
double converged(std::size_t) {
    return 1e-25;
}
template <>
double converged<double>(std::size_t frames) {
    return 1e-15 * std::sqrt(static_cast<double>(std::max<std::size_t>(frames, 10000)));
}

} // namespace

template <class T>
Tangents<T> local_tangents(const Frames& frames, const Neighbors& neighbors, std::size_t d) {
    return tangents<T>(frames, neighbors, d);
}

template <class T>
Spectrum<T> embed(const Neighbors& neighbors, const Tangents<T>& tangents, std::size_t d) {
    Band<T> matrix = differenced_alignment(neighbors, tangents, d);
    matrix.factor();
    return smallest_eigenpairs<T>(matrix, d, converged<T>(neighbors.rows));
}

Spectrum<double> embed_by_rotations(const Neighbors& neighbors, const Tangents<double>& tangents,
                                    std::size_t d) {
    return smallest_eigenpairs<double>(triangle_of(neighbors, tangents, d), d,
                                       converged<double>(neighbors.rows));
}

template Tangents<dd> local_tangents(const Frames&, const Neighbors&, std::size_t);
template Tangents<double> local_tangents(const Frames&, const Neighbors&, std::size_t);
template Spectrum<dd> embed(const Neighbors&, const Tangents<dd>&, std::size_t);
template Spectrum<double> embed(const Neighbors&, const Tangents<double>&, std::size_t);

} // namespace reference
