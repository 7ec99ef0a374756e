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

/// By how much the weight rises in frame i of a crossfade.
double weight_gained(std::int64_t i, std::int64_t crossfade) {
    return crossfade_weight(i, crossfade) -
           (i > -crossfade ? crossfade_weight(i - 1, crossfade) : 0);
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

/// The state after the last one.
RootState Splicer::blended(const Mixture& mixture, double weight_gained, double turn) const {
    const auto& [earlier, a, later, b, weight] = mixture;
    const RootState& from = earlier.root(a);
    const RootState& to = later.root(b);
    RootState state =
        body_.after(last_, mix(step_to(body_, earlier, a), step_to(body_, later, b), weight));
    state = body_.after(state, {turn, -weight_gained * standing_offset(earlier, a, later, b)});
    const auto up = static_cast<std::size_t>(body_.up());
    state.position[up] = (1 - weight) * from.position[up] + weight * to.position[up];
    state.tilt = slerp(from.tilt, to.tilt, weight);
    return state;
}

void Splicer::blend(const Mixture& mixture, double weight_gained, double turn) {
    const auto& [earlier, a, later, b, weight] = mixture;
    last_ = blended(mixture, weight_gained, turn);
    double* row = new_row();
    blend_poses(body_.skeleton(), body_.root() + 1, earlier.values.row(a), later.values.row(b),
                weight, row);
    body_.write(last_, row);
}

void Splicer::blend_all(const Track& earlier, const Track& later, const Cut& cut, std::int64_t from,
                        std::int64_t to, double turn) {
    const std::int64_t w = cut.crossfade;
    for (std::int64_t i = from; i < to; ++i)
        blend({earlier, cut.end + i, later, cut.begin + i, crossfade_weight(i, w)},
              weight_gained(i, w), turn);
}

/// Nothing is blended: the step across the seam is the mean of those on both sides.
RootState Splicer::unblended(const Track& earlier, const Track& later, const Cut& cut) const {
    return body_.after(
        last_, mix(step_to(body_, earlier, cut.end), step_to(body_, later, cut.begin), 0.5));
}

void Splicer::cross(const Track& earlier, const Track& later, const Cut& cut, double turn) {
    const std::int64_t w = cut.crossfade;
    blend_all(earlier, later, cut, -w, w, turn);
    in_place_ = false;
    placement_ = w > 0 ? body_.placement(later.root(cut.begin + w - 1), last_)
                       : body_.placement(later.root(cut.begin), unblended(earlier, later, cut));
}

void Splicer::enter_loop(const Track& earlier, const Track& later, const Cut& cut, double turn) {
    const std::int64_t w = cut.crossfade;
    first_ = later.root(cut.begin);
    if (w == 0) {
        in_place_ = turn == 0;
        first_ = body_.after(first_, {turn, {}}); // as play() does
        return;
    }
    last_ = first_;
    const RootState next = blended({earlier, cut.end, later, cut.begin, crossfade_weight(0, w)},
                                   weight_gained(0, w), turn);
    last_ = body_.moved(body_.placement(next, first_), last_);
    std::copy_n(later.values.row(cut.begin), values_.cols(), values_.row(0)); // for its angles
    blend_all(earlier, later, cut, 0, w, turn);
    in_place_ = false;
    placement_ = body_.placement(later.root(cut.begin + w - 1), last_);
}

Step Splicer::close_loop(const Track& earlier, const Track& later, const Cut& cut, double turn) {
    const std::int64_t w = cut.crossfade;
    blend_all(earlier, later, cut, -w, 0, turn);
    const RootState next =
        w > 0 ? blended({earlier, cut.end, later, cut.begin, crossfade_weight(0, w)},
                        weight_gained(0, w), turn)
              : body_.after(unblended(earlier, later, cut), {turn, {}});
    return body_.step(first_, next);
}

} // namespace stltsa::synthesis
