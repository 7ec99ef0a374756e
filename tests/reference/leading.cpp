// SPDX-License-Identifier: BSD-3-Clause
#include "leading.hpp"

#include <lapacke.h>

#include "vectors.hpp"

namespace reference {
namespace {

/// Norm of A v - theta v, relative to the largest eigenvalue, that counts as none.
constexpr double no_residual = 1e-30;
constexpr int most_corrections = 40;

/// All eigenpairs, by LAPACK.
SymmetricEigen<double> by_lapack(Table<double> a) {
    const std::size_t n = a.rows;
    const auto order = static_cast<lapack_int>(n);
    std::vector<double> ascending(n);
    if (LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', order, a.values.data(), order,
                       ascending.data()) != 0)
        throw std::runtime_error("LAPACK found no eigenvalues");
    SymmetricEigen<double> result{{}, Table<double>(n, n)};
    for (std::size_t r = 0; r < n; ++r) {
        result.values.push_back(ascending[n - 1 - r]);
        std::copy_n(a.row(n - 1 - r), n, result.vectors.row(r));
    }
    return result;
}

Table<double> rounded(const Table<dd>& a) {
    Table<double> result(a.rows, a.cols);
    for (std::size_t i = 0; i < a.values.size(); ++i)
        result.values[i] = static_cast<double>(a.values[i]);
    return result;
}

void normalize(dd* x, std::size_t n) {
    const dd scale = dd(1) / sqrt(inner(x, x, n));
    for (std::size_t i = 0; i < n; ++i)
        x[i] *= scale;
}

/// A x
std::vector<dd> product(const Table<dd>& a, const dd* x) {
    std::vector<dd> result(a.rows);
    for (std::size_t i = 0; i < a.rows; ++i)
        add_scaled(result.data(), x[i], a.row(i), a.cols);
    return result;
}

/// x += sum over j != l of u_j (u_j . r) / (theta_l - theta_j), which solves
/// (A - theta_l) (x + dx) = 0 to first order for the residual r = A x - theta_l x.
void correct(const SymmetricEigen<double>& start, std::size_t l, const std::vector<dd>& residual,
             dd* x) {
    const std::size_t n = residual.size();
    std::vector<double> r(n);
    for (std::size_t i = 0; i < n; ++i)
        r[i] = static_cast<double>(residual[i]);
    std::vector<double> change(n, 0.0);
    for (std::size_t j = 0; j < n; ++j)
        if (j != l) {
            const double* u = start.vectors.row(j);
            add_scaled(change.data(), inner(u, r.data(), n) / (start.values[l] - start.values[j]),
                       u, n);
        }
    for (std::size_t i = 0; i < n; ++i)
        x[i] += dd(change[i]);
    normalize(x, n);
}

/// Makes x, near eigenvector l of `start`, the eigenvector of a; its eigenvalue.
dd converge(const Table<dd>& a, const SymmetricEigen<double>& start, std::size_t l, dd* x) {
    const std::size_t n = a.rows;
    normalize(x, n);
    for (int i = 0; i < most_corrections; ++i) {
        std::vector<dd> residual = product(a, x);
        const dd value = inner(residual.data(), static_cast<const dd*>(x), n);
        add_scaled(residual.data(), -value, static_cast<const dd*>(x), n);
        const double size =
            std::sqrt(static_cast<double>(inner(residual.data(), residual.data(), n)));
        if (size <= no_residual * start.values[0])
            return value;
        correct(start, l, residual, x);
    }
    throw std::runtime_error("an eigenvector of a neighborhood did not converge");
}

} // namespace

template <>
SymmetricEigen<double> leading_eigenpairs(const Table<double>& a, std::size_t) {
    return by_lapack(a);
}

template <>
SymmetricEigen<dd> leading_eigenpairs(const Table<dd>& a, std::size_t count) {
    const SymmetricEigen<double> start = by_lapack(rounded(a));
    SymmetricEigen<dd> result{{}, Table<dd>(count, a.rows)};
    for (std::size_t l = 0; l < count; ++l) {
        std::copy_n(start.vectors.row(l), a.rows, result.vectors.row(l));
        result.values.push_back(converge(a, start, l, result.vectors.row(l)));
    }
    return result;
}

} // namespace reference
