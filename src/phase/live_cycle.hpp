// SPDX-License-Identifier: BSD-3-Clause
// The mean cycle that streams are compared with.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "phase/phases.hpp"

namespace stltsa::phase {

/// Even phases at which the mean cycle is kept.
inline constexpr std::int64_t place_count = 100;

/// What a stream is compared with. Learned through the same causal filter that the stream goes
/// through, so that the delay of the filter is in the mean cycle, and cancels.
struct LiveCycle {
    double rate = 0;             ///< frames per second
    double period = 0;           ///< seconds
    double turns_per_second = 0; ///< median of the cycles
    double variance = 0;         ///< of the filtered pose and velocity
    double typical = 0;          ///< median squared whitened distance of the cycle's own frames
    double usual_speed = 0;      ///< root mean square of the filtered velocity, scaled
    std::vector<double> weights; ///< of the features; 0: one that drifts
    std::vector<double> mean;    ///< of pose and velocity
    Matrix directions;           ///< principal directions, a row each
    Matrix places;               ///< mean cycle in these directions, at even phases
    Matrix rests;                ///< the same of a body that rests in these poses
    Matrix whitening;            ///< lower triangular: whitened = whitening * coordinates

    std::int64_t features() const { return static_cast<std::int64_t>(weights.size()); }
};

/// `rows`: features, not smoothed. `drifting`: columns to leave out. The phases are cyclic.
LiveCycle learn_live(ConstMatrixView rows, double rate, const Phases& phases,
                     std::span<const std::int64_t> drifting);

/// whitening * values.
void whiten(const Matrix& whitening, const double* values, double* whitened);

} // namespace stltsa::phase
