// SPDX-License-Identifier: BSD-3-Clause
// The largest eigenpairs of a symmetric operator, by ARPACK.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "linalg/machine.hpp"
#include "linalg/matrix.hpp"

namespace stltsa {

/// Vector j is the sum of coefficients(m, j) times row m of the basis: it takes a pass over memory
/// to write it out, which is the caller's to share among threads.
struct Eigenpairs {
    Matrix basis;               ///< orthonormal rows
    Matrix coefficients;        ///< a column for each pair that was asked for
    std::vector<double> values; ///< descending; those beyond the pairs are rough, from below
    std::vector<double> errors; ///< the residual of each pair, but for rounding
    std::int64_t applications = 0;
};

/// y = A x, both of the operator's order.
using Operator = std::function<void(std::span<const double> x, std::span<double> y)>;

/// Writes a vector, the same one each time.
using Start = std::function<void(std::span<double> x)>;

/// The `count` algebraically largest eigenpairs of a symmetric operator, with residuals of at most
/// 1e-7 of their eigenvalue, also where this is many powers of ten below the largest (but not below
/// 1e-10, where ARPACK's tolerance ends). `start` writes ARPACK's start vector, which decides, with
/// the operator, every bit of the result; it must not be an eigenvector. `poll` is called between
/// applications and may throw. Small orders are solved densely, by LAPACK. Needs count < order.
/// Throws Status::not_converged.
Eigenpairs largest_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                              std::int64_t count, const Machine& machine,
                              const std::function<void()>& poll);

} // namespace stltsa
