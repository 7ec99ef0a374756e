// SPDX-License-Identifier: BSD-3-Clause
// The result of a fit and measures of its quality.
#pragma once

#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::ltsa {

/// The error estimate of an embedding with unknown error: a right angle.
inline constexpr double unknown_error = 0.5 * std::numbers::pi;

/// A connected component of the neighborhood graph; each is embedded separately.
struct Component {
    std::int64_t frames = 0;         ///< distinct frames in it
    std::vector<double> eigenvalues; ///< ascending, the zero one first: 0, lambda_2, lambda_3, ...
    double residual = 0;             ///< max over wanted u of ||B u - lambda u|| / k
    double error_estimate = 0; ///< estimated largest principal angle to the exact subspace, radians
    double gap = 0;            ///< lambda_{d+2} / lambda_{d+1}; near 1: the subspace is ill-defined
    std::int64_t rank_deficient_windows = 0;
    std::int64_t solves = 0; ///< applications of the inverse operator by ARPACK
};

struct Model {
    Parameters parameters;
    std::int64_t features = 0;
    std::vector<std::int64_t> lengths; ///< frames of each clip
    Matrix coords;                     ///< frames x d; per component: centered, unit norm columns
    UnsetVector<std::int64_t> component_of; ///< per frame, 0-based, numbered by first frame
    std::vector<Component> components;
    std::int64_t repeated_frames = 0; ///< frames equal to the previous one, removed before the fit
    /// |Rank correlation| of coordinate 1 with time; near 1: the coordinate only follows time.
    double time_correlation = 0;
    Warnings warnings;
};

/// The first frame in another component than the previous frame of its clip; -1: none.
std::int64_t first_cut(const Model& model);

} // namespace stltsa::ltsa
