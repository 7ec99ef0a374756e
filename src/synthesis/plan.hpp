// SPDX-License-Identifier: BSD-3-Clause
// Merges adjacent pieces into runs, which are played one after another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "synthesis/track.hpp"

namespace stltsa::synthesis {

/// A piece on its track.
struct Part {
    std::size_t track = 0;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t repeat = 1;
    std::int64_t cycles = 0; ///< 0: unknown
};

/// Consecutive frames of one track, played without a seam.
struct Run {
    std::size_t track = 0;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    std::int64_t first_piece = 0;
    std::int64_t last_piece = 0;
};

/// The runs, with a seam between each and the next. Repetitions of a piece are separate runs (the
/// self-connection of the paper, section 4).
std::vector<Run> make_runs(std::span<const Part> parts);

} // namespace stltsa::synthesis
