// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/likeness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/curve/statistics.hpp"
#include "motion/period/period.hpp"

namespace stltsa::synthesis {
namespace {

/// Seconds around a piece in which to look for repetitions: three cycles of gait.
constexpr double context_s = 4;
/// Search range for the next cycle, as a share of the period to each side.
constexpr double lateness = 0.3;
/// Largest number of frames for the median.
constexpr std::int64_t most_frames = 200;
/// Without repetitions, the frame this many seconds later substitutes for one: in walking and
/// running, a repetition is as distant as the frame 0.02 to 0.04 s later; in slower actions, as the
/// frame up to 0.1 s later.
constexpr double stand_in_s = 0.04;
/// Differences below this share of the size of a posture are rounding.
constexpr double posture_rounding = 1e-4;

double nearest(const Track& track, std::int64_t frame, std::int64_t first, std::int64_t last,
               double velocity_s) {
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t other = std::max(first, track.first);
         other <= std::min(last, track.frames() - 1); ++other)
        least = std::min(least, squared_distance(track, frame, track, other, velocity_s));
    return std::sqrt(least);
}

double to_neighbor_cycle(const Track& track, std::int64_t frame, double period_s,
                         double velocity_s) {
    const double period = period_s * track.fps;
    const std::int64_t early = std::llround((1 - lateness) * period);
    const std::int64_t late = std::llround((1 + lateness) * period);
    return std::min(nearest(track, frame, frame - late, frame - early, velocity_s),
                    nearest(track, frame, frame + early, frame + late, velocity_s));
}

void append_finite(std::vector<double>& values, double value) {
    if (std::isfinite(value))
        values.push_back(value);
}

} // namespace

double period_near(const Track& track, std::int64_t begin, std::int64_t end) {
    const auto context = static_cast<std::int64_t>(context_s * track.fps);
    const std::int64_t more = std::max<std::int64_t>(0, (context - (end - begin) + 1) / 2);
    const std::int64_t first = std::clamp(begin - more, std::min(track.first, begin), begin);
    const std::int64_t last = std::min(end + more, track.frames());
    return motion::find_period(track.postures.view().block(first, last - first), track.fps, {})
               .samples /
           track.fps;
}

double repetition_distance(const Track& track, std::int64_t begin, std::int64_t end,
                           double period_s, double velocity_s) {
    const std::int64_t stride = 1 + (end - begin - 1) / most_frames;
    std::vector<double> repetitions;
    std::vector<double> later;
    std::vector<double> steps;
    const std::int64_t stand_in = std::llround(stand_in_s * track.fps);
    for (std::int64_t frame = begin; frame < end; frame += stride) {
        if (period_s > 0)
            append_finite(repetitions, to_neighbor_cycle(track, frame, period_s, velocity_s));
        append_finite(later, nearest(track, frame, frame + stand_in, frame + stand_in, velocity_s));
        append_finite(steps, nearest(track, frame, frame + 1, frame + 1, velocity_s));
    }
    const double common = motion::median(repetitions.empty() ? later : repetitions);
    // Cuts lie on frames, so even identical repetitions may be half a frame apart.
    return std::max(
        {common, motion::median(steps) / 2, posture_rounding * posture_size(track, begin)});
}

} // namespace stltsa::synthesis
