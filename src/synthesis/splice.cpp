// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/splice.hpp"

#include <algorithm>

#include "synthesis/blend.hpp"
#include "synthesis/footing.hpp"

namespace stltsa::synthesis {
namespace {

/// Rises from 0 to 1 with zero slope at both ends.
double smoothstep(double x) {
    return x * x * (3 - 2 * x);
}

} // namespace

double crossfade_weight(std::int64_t i, std::int64_t crossfade) {
    return smoothstep((static_cast<double>(i + crossfade) + 0.5) /
                      static_cast<double>(2 * crossfade));
}

Splicer::Splicer(const Body& body, std::int64_t frames)
    : body_(body), values_(frames, body.channels()) {}

/// The next row, initialized with the previous one, which selects among equivalent angles.
double* Splicer::new_row() {
    double* row = values_.row(next_);
    if (next_ > 0)
        std::copy_n(values_.row(next_ - 1), values_.cols(), row);
    ++next_;
    return row;
}

void Splicer::play(const Track& track, std::int64_t begin, std::int64_t end, double turn) {
    for (std::int64_t frame = begin; frame < end; ++frame) {
        const double* source = track.values.row(frame);
        double* row = new_row();
        last_ = track.root(frame);
        std::int64_t kept = 0;
        if (!in_place_) {
            last_ = body_.moved(placement_, last_);
            if (turn != 0) {
                last_ = body_.after(last_, {turn, {}});
                placement_ = body_.placement(track.root(frame), last_);
            }
            body_.write(last_, row);
            kept = body_.root_channels();
        }
        std::copy(source + kept, source + values_.cols(), row + kept);
    }
}

void Splicer::blend(const Mixture& mixture, double weight_gained, double turn) {
    const auto& [earlier, a, later, b, weight] = mixture;
    const RootState& from = earlier.root(a);
    const RootState& to = later.root(b);
    last_ = body_.after(last_, mix(step_to(body_, earlier, a), step_to(body_, later, b), weight));
    last_ = body_.after(last_, {turn, -weight_gained * standing_offset(earlier, a, later, b)});
    const auto up = static_cast<std::size_t>(body_.up());
    last_.position[up] = (1 - weight) * from.position[up] + weight * to.position[up];
    last_.tilt = slerp(from.tilt, to.tilt, weight);
    double* row = new_row();
    blend_poses(body_.skeleton(), body_.root() + 1, earlier.values.row(a), later.values.row(b),
                weight, row);
    body_.write(last_, row);
}

void Splicer::cross(const Track& earlier, const Track& later, const Cut& cut, double turn) {
    const std::int64_t w = cut.crossfade;
    double before = 0;
    for (std::int64_t i = -w; i < w; ++i) {
        const double weight = crossfade_weight(i, w);
        blend({earlier, cut.end + i, later, cut.begin + i, weight}, weight - before, turn);
        before = weight;
    }
    in_place_ = false;
    if (w > 0) {
        placement_ = body_.placement(later.root(cut.begin + w - 1), last_);
        return;
    }
    // Nothing is blended: the step across the seam is the mean of those on both sides.
    const Step step = mix(step_to(body_, earlier, cut.end), step_to(body_, later, cut.begin), 0.5);
    placement_ = body_.placement(later.root(cut.begin), body_.after(last_, step));
}

} // namespace stltsa::synthesis
