// SPDX-License-Identifier: BSD-3-Clause
// What a decomposition finds, and its options. Everything counts in samples; the room results maps
// them to frames of the source.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/warning.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/dimension.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::motion {

/// Same values as STLTSA_UNIT_* (checked in capi).
enum class UnitKind : std::int32_t {
    preparing = 1,
    initial = 2,
    cyclic = 3,
    final = 4,
    wind_up = 5,
    action = 6, ///< motion without claimed cycles
    hold = 8,   ///< keeping a posture between motions that is not the one at rest
};

/// [begin, end) in samples, not rounded.
struct Unit {
    UnitKind kind = UnitKind::action;
    double begin = 0;
    double end = 0;
};

struct Cycle {
    double begin = 0;
    double end = 0;
};

struct DecomposeOptions {
    std::optional<std::int64_t> neighbors; ///< empty: choose_neighbors()
    std::optional<std::int64_t> window;    ///< empty: same as neighbors
    std::optional<int> dimension;          ///< tangent dimension; empty: the best of 1 to 3
    ltsa::Mode mode = ltsa::Mode::temporal;
    double shortest_period = 0.3; ///< seconds
    double longest_period = 6.0;  ///< seconds
    /// How to estimate the intrinsic dimension; empty: not estimated.
    std::optional<ltsa::DimensionOptions> estimate;
    // For messages only.
    double first_s = 0; ///< time of the first sample
    std::string jump;   ///< where the pose jumps; empty: nowhere
    double jump_s = no_time;
    bool in_space = false; ///< the samples may contain the body's path through space
    int threads = 1;
};

struct Decomposition {
    // Units and cycles.
    double period = 0;           ///< samples; 0: no cycle is claimed
    std::vector<Unit> units;     ///< cover [0, samples) without gap or overlap
    std::vector<double> margins; ///< of the cycles: cycle i lasts from margin 2 i to 2 i + 2
    std::vector<Cycle> cycles;
    std::int64_t representative = -1; ///< index of the cycle from the first to the third candidate
    std::int64_t best = -1;           ///< index of the cycle most similar to the others
    std::string reason;               ///< why no cycle is claimed, with numbers; empty if one is

    // Evidence and embedding.
    ltsa::Parameters parameters; ///< of the fit that was used
    int coordinate = 0;          ///< 1-based column of coords that `curve` shows; 0: no embedding
    double cyclicity = 0;        ///< of that coordinate, at most 1; 0 without a period
    double lag_quality = 0;      ///< 1 - D(T) of the best lag T; 0 without a period
    std::optional<ltsa::Dimension> intrinsic; ///< of the embedded samples, if requested
    Matrix coords;                            ///< samples x d, of the fit used; zeros without a fit
    Matrix loop;               ///< samples x 2, the two coordinates that form a loop (Fig. 1)
    std::vector<double> curve; ///< smoothed coordinate from which the units follow
    std::vector<double> eigenvalues;
    double residual = 0, error_estimate = 0; ///< largest values of all components
    Warnings warnings;
};

} // namespace stltsa::motion
