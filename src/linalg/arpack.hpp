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
    std::vector<double> values; ///< descending
    Matrix vectors;             ///< one per row, unit norm
    std::int64_t applications = 0;
};

/// y = A x, both of the operator's order.
using Operator = std::function<void(std::span<const double> x, std::span<double> y)>;

/// The `count` algebraically largest eigenpairs of a symmetric operator of order `order`, to
/// machine precision. `start` is ARPACK's start vector and decides, with the operator, every bit
/// of the result; it must not be an eigenvector. `poll` is called between applications and may
/// throw. Needs count < start.size(); small orders are solved densely by LAPACK.
/// Throws Status::not_converged.
Eigenpairs largest_eigenpairs(const Operator& apply, std::span<const double> start,
                              std::int64_t count, const std::function<void()>& poll);

} // namespace stltsa
