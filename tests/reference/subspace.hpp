// SPDX-License-Identifier: BSD-3-Clause
// Bases of column spaces, stored as one vector per row: orthonormalization, largest principal
// angle, and block inverse iteration.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "differences.hpp"
#include "jacobi.hpp"
#include "vectors.hpp"

namespace reference {

/// Projects the rows of `basis` (orthonormal) out of the vector x.
template <class T>
void project_out(const Table<T>& basis, std::size_t rows, T* x) {
    for (std::size_t r = 0; r < rows; ++r) {
        const T part = inner<T>(basis.row(r), x, basis.cols);
        add_scaled(x, -part, basis.row(r), basis.cols);
    }
}

/// Gram-Schmidt, twice (Kahan and Parlett's "twice is enough").
template <class T>
void orthonormalize(Table<T>& x) {
    for (std::size_t r = 0; r < x.rows; ++r) {
        for (int pass = 0; pass < 2; ++pass) {
            project_out(x, r, x.row(r));
            const T scale = T(1) / sqrt(inner(x.row(r), x.row(r), x.cols));
            for (std::size_t i = 0; i < x.cols; ++i)
                x.row(r)[i] *= scale;
        }
    }
}

inline Table<dd> widened(const Table<double>& table) {
    Table<dd> result(table.rows, table.cols);
    std::copy(table.values.begin(), table.values.end(), result.values.begin());
    return result;
}

/// Sine of the largest principal angle between the row spaces of a and b, of equal dimension: the
/// norm of the part of b outside a. Accurate for the smallest angles, unlike an arc cosine.
template <class T>
T largest_angle(Table<T> a, Table<T> b) {
    orthonormalize(a);
    orthonormalize(b);
    for (std::size_t r = 0; r < b.rows; ++r)
        project_out(a, a.rows, b.row(r));
    Table<T> gram(b.rows, b.rows);
    for (std::size_t i = 0; i < b.rows; ++i)
        for (std::size_t j = 0; j < b.rows; ++j)
            gram(i, j) = inner(b.row(i), b.row(j), b.cols);
    const T largest = symmetric_eigen(gram).values[0];
    return largest > T(0) ? sqrt(largest) : T(0);
}

/// rotation (rows x p) times x (p x n): a linear combination of basis vectors.
template <class T>
Table<T> combine(const Table<T>& rotation, const Table<T>& x, std::size_t rows) {
    Table<T> result(rows, x.cols);
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t s = 0; s < x.rows; ++s)
            add_scaled(result.row(r), rotation(r, s), x.row(s), x.cols);
    return result;
}

template <class T>
struct Spectrum {
    std::vector<T> lambda; ///< lambda_2, lambda_3, ..., ascending; d + 1 of them
    Table<T> coords;       ///< d x n, orthonormal rows
    int iterations = 0;
    double change = 1; ///< sine of the angle of the last step
};

/// Smooth, independent and centered: cos(pi v (i + 1/2) / n), v = 1 .. p.
template <class T>
Table<T> cosines(std::size_t p, std::size_t n) {
    Table<T> x(p, n);
    const double step = std::acos(-1.0) / static_cast<double>(n);
    for (std::size_t v = 0; v < p; ++v)
        for (std::size_t i = 0; i < n; ++i)
            x(v, i) =
                T(std::cos(step * static_cast<double>(v + 1) * (static_cast<double>(i) + 0.5)));
    orthonormalize(x);
    return x;
}

/// The d smallest nonzero eigenpairs of B by block inverse iteration on d + 5 vectors with one
/// Rayleigh-Ritz step per iteration. Stops when the d-dimensional space turns by less than
/// `tolerance`; in double also when the turn stops shrinking, because rounding keeps turning the
/// space.
template <class T, class Factor>
Spectrum<T> smallest_eigenpairs(const Factor& factor, std::size_t d, double tolerance) {
    const std::size_t n = factor.rows() + 1;
    const std::size_t p = std::min(d + 5, n - 1);
    Table<T> x = cosines<T>(p, n);
    Spectrum<T> result;
    double least = 1;
    int iterations_without_progress = 0;
    for (result.iterations = 1; result.iterations <= 2000; ++result.iterations) {
        Table<T> y = x;
        std::vector<T> column;
        for (std::size_t v = 0; v < p; ++v) {
            column.assign(x.row(v), x.row(v) + n);
            apply_pseudo_inverse(factor, column);
            std::copy(column.begin(), column.end(), y.row(v));
        }
        Table<T> projected(p, p);
        for (std::size_t u = 0; u < p; ++u)
            for (std::size_t v = 0; v <= u; ++v)
                projected(u, v) = projected(v, u) =
                    (inner(x.row(u), y.row(v), n) + inner(x.row(v), y.row(u), n)) / T(2);
        const auto eigen = symmetric_eigen(projected);
        Table<T> coords = combine(eigen.vectors, x, d);
        if (result.coords.rows == d)
            result.change = static_cast<double>(largest_angle(result.coords, coords));
        result.coords = std::move(coords);
        result.lambda.clear();
        for (std::size_t v = 0; v < std::min(p, d + 1); ++v)
            result.lambda.push_back(T(1) / eigen.values[v]);
        iterations_without_progress =
            result.change < least / 2 ? 0 : iterations_without_progress + 1;
        least = std::min(least, result.change);
        if (result.change < tolerance)
            return result;
        if (std::is_same_v<T, double> && iterations_without_progress == 20)
            return result;
        x = combine(eigen.vectors, y, p);
        orthonormalize(x);
    }
    throw std::runtime_error("block inverse iteration did not converge");
}

} // namespace reference
