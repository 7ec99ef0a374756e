// SPDX-License-Identifier: BSD-3-Clause
#include "results/facts.hpp"

#include "clip/body/heading.hpp"
#include "clip/features/points.hpp"
#include "clip/features/tpose.hpp"

namespace stltsa::results {

double rows_of_period(const PeriodFacts& period, const SampleFacts& samples) {
    return samples.fps > 0 ? period.period * samples.fps : period.period;
}

PeriodFacts in_seconds(const PeriodFacts& period, const SampleFacts& samples) {
    return samples.fps > 0 ? period : PeriodFacts{0, period.lag_quality, 0, 0};
}

ClipFacts clip_facts(const clip::Clip& clip) {
    return {clip.path, clip.format, clip.frames(), clip.fps, clip.notes, 0, 1};
}

clip::Features default_features(const clip::Clip& clip) {
    return clip::feature_kind(clip, {});
}

clip::Axis default_up(const clip::Clip& clip) {
    if (default_features(clip) == clip::Features::points)
        return clip::points_up(clip);
    return clip.skeleton ? clip::up_axis(clip, {}) : clip::Axis::none;
}

std::int64_t default_first_frame(const clip::Clip& clip) {
    if (!clip.skeleton)
        return 0;
    return clip::tpose_frames(clip::features(clip, {}, default_up(clip)).view());
}

std::int64_t default_root(const clip::Clip& clip) {
    return clip.skeleton ? static_cast<std::int64_t>(clip::body_root(clip)) : 0;
}

} // namespace stltsa::results
