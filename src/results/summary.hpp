// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stltsa.h"

namespace stltsa::results {

/// Parts of one kind and how the body travels during each.
struct Parts {
    std::span<const stltsa_part> parts;
    std::span<const stltsa_travel> travels;
};

/// How often and how fast, for each label of which there are cycles or repetitions. Parts are in
/// temporal order, those of each segment one after another.
std::vector<stltsa_summary> summaries_of(std::span<const stltsa_segment> segments,
                                         std::span<const stltsa_part> cycles,
                                         std::span<const stltsa_part> repetitions);

/// Of the parts of one label; those whose quantity is unknown are left out. side -1: of both sides.
stltsa_statistics statistics_of(std::span<const stltsa_segment> segments, const Parts& all,
                                std::int32_t label, std::int32_t side, std::int32_t quantity);

/// For the parts of one label: half the width of the 95 % confidence interval of the trend of their
/// lengths; NaN for fewer than three parts.
double trend_margin(std::span<const stltsa_segment> segments, std::span<const stltsa_part> parts,
                    std::int32_t label);

} // namespace stltsa::results
