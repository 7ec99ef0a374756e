// SPDX-License-Identifier: BSD-3-Clause
// Eigenvalues and eigenvectors of a small symmetric matrix by cyclic Jacobi rotations, in any
// precision (Rutishauser, Numer. Math. 9, 1966; Golub and Van Loan, section 8.5).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "scalar.hpp"
#include "table.hpp"

namespace reference {

template <class T>
struct SymmetricEigen {
    std::vector<T> values; ///< descending
    Table<T> vectors;      ///< row v is the eigenvector of values[v]
};

namespace detail {

/// Rotates rows p and q (columns of a, rows of v) so that entry (p, q) becomes zero.
template <class T>
void rotate(Table<T>& a, Table<T>& v, std::size_t p, std::size_t q) {
    const T theta = (a(q, q) - a(p, p)) / (T(2) * a(p, q));
    const T size = T(1) / (abs(theta) + sqrt(theta * theta + T(1)));
    const T t = theta < T(0) ? -size : size;
    const T c = T(1) / sqrt(t * t + T(1));
    const T s = t * c;
    const auto turn = [c, s](T& x, T& y) {
        const T old = x;
        x = c * old - s * y;
        y = s * old + c * y;
    };
    for (std::size_t i = 0; i < a.rows; ++i)
        turn(a(i, p), a(i, q));
    for (std::size_t i = 0; i < a.rows; ++i)
        turn(a(p, i), a(q, i));
    for (std::size_t i = 0; i < a.rows; ++i)
        turn(v(p, i), v(q, i));
    a(p, q) = a(q, p) = T(0);
}

/// Runs one sweep over all pairs; returns false if every entry was already negligible.
template <class T>
bool sweep(Table<T>& a, Table<T>& v, T negligible) {
    bool rotated = false;
    for (std::size_t p = 0; p + 1 < a.rows; ++p)
        for (std::size_t q = p + 1; q < a.rows; ++q)
            if (abs(a(p, q)) > negligible) {
                rotate(a, v, p, q);
                rotated = true;
            }
    return rotated;
}

} // namespace detail

template <class T>
SymmetricEigen<T> symmetric_eigen(Table<T> a) {
    const std::size_t n = a.rows;
    Table<T> v(n, n);
    T norm(0);
    for (std::size_t i = 0; i < n; ++i) {
        v(i, i) = T(1);
        for (std::size_t j = 0; j < n; ++j)
            norm += a(i, j) * a(i, j);
    }
    norm = sqrt(norm);
    int sweeps = 0;
    while (detail::sweep(a, v, norm * T(negligible<T>)))
        if (++sweeps > 60)
            throw std::runtime_error("Jacobi rotations did not converge");

    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&a](std::size_t i, std::size_t j) { return a(i, i) > a(j, j); });
    SymmetricEigen<T> result{{}, Table<T>(n, n)};
    for (std::size_t r = 0; r < n; ++r) {
        result.values.push_back(a(order[r], order[r]));
        std::copy_n(v.row(order[r]), n, result.vectors.row(r));
    }
    return result;
}

} // namespace reference
