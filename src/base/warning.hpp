// SPDX-License-Identifier: BSD-3-Clause
// Warnings about a result.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace stltsa {

/// Same values as STLTSA_WARNING_* in stltsa.h (checked in src/capi).
enum class WarningCode : std::int32_t {
    follows_time = 1,
    rank_deficient = 2,
    small_gap = 3,
    unscaled = 4,
    inaccurate = 5,
    disconnected = 6,
    jump = 7,
    separate_motion = 8,
    offsets_differ = 9,
    resampled = 10,
    seam_posture = 11,
    seam_speed = 12,
    seam_acceleration = 13,
    not_blended = 14,
    no_order = 15,
    linear_phase = 16,
    several_places = 17,
    not_found = 18,
    few_cycles = 19,
    not_alike = 20,
    uncertain_shift = 21,
    sizes_differ = 22,
};

inline constexpr double no_time = std::numeric_limits<double>::quiet_NaN();

struct Warning {
    WarningCode code = WarningCode::follows_time;
    std::string text;
    double begin_s = no_time; ///< seconds in the source (of a seam, in the new clip)
    double end_s = no_time;   ///< the same as begin_s for a moment
};
using Warnings = std::vector<Warning>;

} // namespace stltsa
