// SPDX-License-Identifier: BSD-3-Clause
// The source of a result: clips, working samples, period.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/features.hpp"

namespace stltsa::results {

/// What a result says of its clip.
struct ClipFacts {
    std::string path; ///< empty: from memory
    clip::Format format = clip::Format::matrix;
    std::int64_t frames = 0;
    double fps = 0; ///< 0: unknown
    std::vector<std::string> notes;
    std::int64_t first = 0; ///< row i that comes from it is its frame first + i * step
    std::int64_t step = 1;
};

/// How the frames of a clip became the working samples: sample i is frame first + i * step. Of
/// several clips first and step are the first one's.
struct SampleFacts {
    std::int64_t count = 0;
    std::int64_t first = 0;
    std::int64_t step = 1;
    double fps = 0; ///< of the samples; 0: unknown
    clip::Features features = clip::Features::raw;
    std::int64_t feature_count = 0;
    clip::Axis up = clip::Axis::none; ///< none: none was needed
    double smoothing = 0;             ///< seconds
};

/// The period that the number of neighbors was chosen by. In seconds; in rows if the rate is
/// unknown.
struct PeriodFacts {
    double period = 0;      ///< 0: none found
    double lag_quality = 0; ///< match of the velocities one period apart; 0 without a period
    double shortest = 0;    ///< of the search; 0: no search was made
    double longest = 0;
};

/// The period in rows; 0: none.
double rows_of_period(const PeriodFacts& period, const SampleFacts& samples);

/// The same facts with all lengths in seconds, which are 0 if the rate is unknown.
PeriodFacts in_seconds(const PeriodFacts& period, const SampleFacts& samples);

/// The clips and working samples of a result, and the period.
struct Source {
    std::vector<ClipFacts> clips; ///< none: a matrix
    SampleFacts samples;
    PeriodFacts period;
};

ClipFacts clip_facts(const clip::Clip& clip);

/// How a clip is read without options: features, the axis that points up (none: bare
/// numbers), the first frame after a T-pose, and the joint that turns the body (0 without a
/// skeleton).
clip::Features default_features(const clip::Clip& clip);
clip::Axis default_up(const clip::Clip& clip);
std::int64_t default_first_frame(const clip::Clip& clip);
std::int64_t default_root(const clip::Clip& clip);

} // namespace stltsa::results
