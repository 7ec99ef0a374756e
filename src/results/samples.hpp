// SPDX-License-Identifier: BSD-3-Clause
// Makes the working samples of clips, which are fitted or decomposed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/side_name.hpp"
#include "clip/features/prepare.hpp"
#include "results/facts.hpp"

namespace stltsa::results {

using Clips = std::span<const clip::Clip* const>;

/// Numbers of consecutive rows.
struct Lengths {
    std::vector<std::int64_t> clips; ///< of each clip
    std::vector<std::int64_t> runs;  ///< without a break; neighbors in time are of the same run
};

/// Working samples of clips, one clip after another, and their source.
struct ClipSamples {
    Matrix samples;
    Matrix rows; ///< of a single clip: see clip::Prepared
    Lengths lengths;
    Source source;
    std::int64_t jump = 0;           ///< of a single clip: see clip::Prepared
    std::vector<clip::Frames> holes; ///< of a single clip: see clip::Prepared
    bool turned = false;             ///< of the first clip: see clip::Prepared
};

/// Takes at least one clip. Throws Status::shape if joints, channels, features or the rate of the
/// samples differ from the first clip's. The kind of features and the axis that points up are the
/// first clip's.
ClipSamples prepare_clips(Clips clips, clip::PrepareOptions options);

/// The two sides of the body, from the skeleton or from the names of points.
struct BodySides {
    std::vector<double> weights;    ///< motion::Options::side
    std::vector<double> one, other; ///< motion::Options::one_side, other_side
    std::optional<bool> forward;    ///< motion::Options::forward; unset: the names do not tell them
    Side name = Side::neither;      ///< the side that moves forward while the weighted sum of
                                    ///< velocities is positive; it is side 1 of cycles and steps
};

/// Assumes right-handed axes.
BodySides body_sides(const clip::Clip& clip, const SampleFacts& facts, ConstMatrixView samples);

/// The source of a matrix, which has no clips. fps 0: unknown.
Source matrix_source(ConstMatrixView frames, double fps);

} // namespace stltsa::results
