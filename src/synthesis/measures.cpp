// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/measures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "clip/features/features.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"
#include "synthesis/splice.hpp"

namespace stltsa::synthesis {
namespace {

constexpr double near_s = 0.125;
constexpr double usual = 0.95;
/// Steps below this share of the size of a posture are rounding.
constexpr double step_rounding = 1e-6;

struct Differences {
    std::vector<double> steps;
    std::vector<double> accelerations;
};

/// Steps and second differences entirely within frames [begin, end), which may lie beyond the
/// `frames` of a loop.
Differences differences(const Matrix& x, std::int64_t frames, std::int64_t begin,
                        std::int64_t end) {
    Differences result;
    const auto row = [&](std::int64_t t) { return x.row((t % frames + frames) % frames); };
    for (std::int64_t t = begin + 1; t < end; ++t)
        result.steps.push_back(std::sqrt(stltsa::squared_distance(row(t), row(t - 1), x.cols())));
    for (std::int64_t t = begin + 1; t + 1 < end; ++t) {
        double sum = 0;
        for (std::int64_t c = 0; c < x.cols(); ++c) {
            const double d = row(t + 1)[c] - 2 * row(t)[c] + row(t - 1)[c];
            sum += d * d;
        }
        result.accelerations.push_back(std::sqrt(sum));
    }
    return result;
}

double largest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

std::int64_t reach_of(double fps) {
    return std::max<std::int64_t>(1, std::llround(near_s * fps));
}

} // namespace

double wrap_step(const clip::Clip& loop, std::int64_t crossfade) {
    const Matrix positions = clip::positions(loop);
    const std::int64_t end = loop.frames();
    const std::int64_t reach = reach_of(loop.fps);
    const double usual_step =
        motion::quantile(differences(positions, end, crossfade, end - crossfade).steps, usual);
    const double found =
        largest(differences(positions, end, end - 1 - reach, end + reach + 1).steps);
    return found > 0 ? found / usual_step : 0;
}

double visible_posture(const Options& options) {
    return (options.posture_limit > 0 ? options.posture_limit : Options{}.posture_limit) / 2;
}

Roughness usual_roughness(const Track& track, std::int64_t begin, std::int64_t end) {
    const Differences found = differences(track.postures, track.frames(), begin, end);
    const double least = step_rounding * posture_size(track, begin);
    return {std::max(motion::quantile(found.steps, usual), least),
            std::max(motion::quantile(found.accelerations, usual), least)};
}

Roughness roughness_near(const Track& track, std::int64_t seam, bool loop) {
    const std::int64_t reach = reach_of(track.fps);
    // The step into the seam starts at the frame before it.
    const std::int64_t begin = seam - 1 - reach;
    const std::int64_t end = seam + reach + 1;
    const Differences found =
        differences(track.postures, track.frames(), loop ? begin : std::max<std::int64_t>(0, begin),
                    loop ? end : std::min(track.frames(), end));
    return {largest(found.steps), largest(found.accelerations)};
}

Roughness roughness_across(const Track& track, const Cut& cut) {
    const std::int64_t w = cut.crossfade;
    const std::int64_t earlier = std::min(w + 2, cut.end); // frames before the seam, and after it
    const std::int64_t later = std::min(w + 2, track.frames() - cut.begin);
    Matrix postures(earlier + later, track.postures.cols());
    for (std::int64_t i = -earlier; i < later; ++i) {
        const double weight = i < -w ? 0 : i >= w ? 1 : crossfade_weight(i, w);
        double* row = postures.row(earlier + i);
        if (weight < 1)
            axpy(1 - weight, track.postures.row(cut.end + i), row, postures.cols());
        if (weight > 0)
            axpy(weight, track.postures.row(cut.begin + i), row, postures.cols());
    }
    const Differences found = differences(postures, postures.rows(), 0, postures.rows());
    return {largest(found.steps), largest(found.accelerations)};
}

} // namespace stltsa::synthesis
