// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stltsa.h"

namespace stltsa::results {

/// How often and how fast, for each label of which there are cycles or repetitions.
std::vector<stltsa_summary> summaries_of(std::span<const stltsa_part> cycles,
                                         std::span<const stltsa_part> steps,
                                         std::span<const stltsa_part> repetitions);

/// Of the parts of one label; those whose quantity is unknown are left out. side -1: of both sides.
/// quantity: STLTSA_QUANTITY_*.
stltsa_statistics statistics_of(std::span<const stltsa_part> parts, std::int64_t label,
                                std::int64_t side, std::int32_t quantity);

/// For the parts of one label: half the width of the 95 % confidence interval of the trend of their
/// lengths; NaN for fewer than three parts.
double trend_margin(std::span<const stltsa_part> parts, std::int64_t label);

} // namespace stltsa::results
