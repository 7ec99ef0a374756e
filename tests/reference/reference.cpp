// SPDX-License-Identifier: BSD-3-Clause
#include "reference.hpp"

namespace reference {
namespace {

/// Angle of the last step at which the iteration ends: above the rounding of one application of
/// the inverse, about (condition of B') * (rounding unit).
template <class T>
constexpr double converged = 1e-13;
template <>
constexpr double converged<dd> = 1e-25;

} // namespace

template <class T>
std::vector<Spectrum<T>> embed(const Frames& frames, const Neighbors& neighbors, std::size_t most) {
    const Tangents<T> local = tangents<T>(frames, neighbors, most);
    std::vector<Spectrum<T>> result;
    for (std::size_t d = 1; d <= most; ++d) {
        Band<T> matrix = differenced_alignment(neighbors, local, d);
        matrix.factor();
        result.push_back(smallest_eigenpairs(matrix, d, converged<T>));
    }
    return result;
}

template std::vector<Spectrum<dd>> embed(const Frames&, const Neighbors&, std::size_t);
template std::vector<Spectrum<double>> embed(const Frames&, const Neighbors&, std::size_t);

} // namespace reference
