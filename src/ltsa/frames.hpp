// SPDX-License-Identifier: BSD-3-Clause
// Checks of the frames before any work, and removal of repeated frames.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::ltsa {

/// Throws if a number is NaN, infinite, or so large that distances would be infinite.
void check_numbers(ConstMatrixView numbers, const char* name, int threads = 1);

/// Checks the numbers, that there are frames, and that the lengths sum to the rows.
void check_frames(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                  const char* name = "frames", int threads = 1);

/// The frames without those that equal their predecessor in every feature: a window of equal frames
/// has no tangent, and a hold longer than the window would split the clip.
struct DistinctFrames {
    Matrix storage; ///< used only if something repeats or is scaled
    ConstMatrixView x;
    std::vector<std::int64_t> lengths;
    UnsetVector<std::int32_t> row_of; ///< distinct row of each frame
    std::int64_t repeated = 0;
};

DistinctFrames collapse_repeats(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                                int threads);

/// Throws for a frame that has changed since check_frames(): another thread may write to the
/// caller's array, which is read in place.
[[noreturn]] void fail_changed(std::int64_t frame);

/// If squared distances would underflow, the power of two that makes the spread of the frames about
/// 1; else 0, also for equal frames. To scale by a power of two is exact.
int power_if_tiny(ConstMatrixView x);

/// x times 2^power.
Matrix scaled(ConstMatrixView x, int power);

/// Scales frames that are tiny; the embedding does not depend on the scale.
void scale_tiny(DistinctFrames& frames);

/// Throws if parameters contradict each other or do not fit the distinct frames.
void check_parameters(const Parameters& parameters, const DistinctFrames& frames);

} // namespace stltsa::ltsa
