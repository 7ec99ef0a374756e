// SPDX-License-Identifier: BSD-3-Clause
// Checks of the frames before any work, and frames that repeat the one before.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/parameters.hpp"

namespace stltsa::ltsa {

/// Throws for a number that is NaN or infinite, or so large that distances would be.
void check_numbers(ConstMatrixView numbers, const char* name, int threads = 1);

/// The same for frames, and for none of them and for lengths that do not sum to the rows.
void check_frames(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                  const char* name = "frames", int threads = 1);

/// The frames without those that equal their predecessor in every feature. A window of held
/// frames has no tangent, and a hold longer than the window would cut the clip in two.
struct DistinctFrames {
    Matrix storage; ///< used only if something repeats or is scaled
    ConstMatrixView x;
    std::vector<std::int64_t> lengths;
    UnsetVector<std::int32_t> row_of; ///< distinct row of each frame
    std::int64_t repeated = 0;
};

DistinctFrames collapse_repeats(ConstMatrixView frames, std::span<const std::int64_t> lengths,
                                int threads);

/// Throws for a frame whose numbers are no longer those that check_frames() passed: another thread
/// of the caller's may write into an array that is read in place.
[[noreturn]] void fail_changed(std::int64_t frame);

/// Scales frames that all lie so close together that squares of their distances would underflow, by
/// a power of two, which is exact; the embedding does not depend on it. They vary, which
/// check_parameters() has made sure of.
void scale_tiny(DistinctFrames& frames);

/// Throws for parameters that do not fit each other or the distinct frames.
void check_parameters(const Parameters& parameters, const DistinctFrames& frames);

} // namespace stltsa::ltsa
