// SPDX-License-Identifier: BSD-3-Clause
// The leading eigenpairs of a symmetric matrix: all of them by Jacobi rotations; in double by
// LAPACK; and in double-double LAPACK's, corrected until the residual is that of double-double.
#pragma once

#include "dd.hpp"
#include "jacobi.hpp"
#include "table.hpp"

namespace reference {

/// The `count` largest eigenvalues and their vectors, at least.
template <class T>
SymmetricEigen<T> leading_eigenpairs(const Table<T>& a, std::size_t) {
    return symmetric_eigen(a);
}

template <>
SymmetricEigen<double> leading_eigenpairs(const Table<double>& a, std::size_t count);

/// Throws std::runtime_error where an eigenpair stays uncertain, as equal eigenvalues make it.
template <>
SymmetricEigen<dd> leading_eigenpairs(const Table<dd>& a, std::size_t count);

} // namespace reference
