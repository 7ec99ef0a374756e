// SPDX-License-Identifier: BSD-3-Clause
// The largest eigenpairs of a symmetric operator, by ARPACK.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"

namespace stltsa {

struct Eigenpairs {
    Matrix vectors;             ///< orthonormal rows
    std::vector<double> values; ///< descending
    std::int64_t applications = 0;
};

/// y = A x, both of the operator's order.
using Operator = std::function<void(std::span<const double> x, std::span<double> y)>;

/// Writes the start vector, the same one each time.
using Start = std::function<void(std::span<double> x)>;

/// The `count` algebraically largest eigenpairs of a symmetric operator (count < order). Residuals
/// are at most 1e-7 of the eigenvalue, even if it is many powers of ten below the largest (but not
/// below 1e-10, the limit of ARPACK's tolerance). `start` writes ARPACK's start vector, which with
/// the operator determines every bit of the result; it must not be an eigenvector. Small orders are
/// solved densely by LAPACK. Throws Status::not_converged, and Status::argument if called from
/// `apply` or at one of its checkpoints.
Eigenpairs largest_eigenpairs(const Operator& apply, std::int64_t order, const Start& start,
                              std::int64_t count);

} // namespace stltsa
