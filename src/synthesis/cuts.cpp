// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/progress.hpp"

namespace stltsa::synthesis {
namespace {

/// A cut removes at most a quarter of a run, and a crossfade covers at most a quarter, so that the
/// two ends of a run never affect each other.
std::int64_t quarter(std::int64_t length) {
    return length / 4;
}

/// Range of each cut, both ends included.
struct Reach {
    std::int64_t first_end, last_end;
    std::int64_t first_begin, last_begin;

    Reach(const Join& join, std::int64_t search) {
        first_end = join.end - std::min(search, quarter(join.earlier_length));
        last_end = std::min(join.end + search, join.earlier->frames());
        last_begin = std::min(join.begin + std::min(search, quarter(join.later_length)),
                              join.later->frames() - 1);
        first_begin = std::max<std::int64_t>(join.begin - search, 0);
        if (join.later->first <= last_begin) // avoid a T-pose if possible
            first_begin = std::max(first_begin, join.later->first);
    }
};

/// The requested crossfade, limited by the available frames of the clips.
std::int64_t crossfade_at(const Join& join, std::int64_t wanted, std::int64_t end,
                          std::int64_t begin) {
    return std::max<std::int64_t>(
        0, std::min({wanted, quarter(join.earlier_length), quarter(join.later_length),
                     join.earlier->frames() - end, join.later->frames() - begin,
                     begin - join.later->first}));
}

/// Squared distance of two postures and velocities, averaged over the frames that the crossfade
/// blends, weighted by the slope of smoothstep, x (1 - x). Frame b of the later run replaces frame
/// e of the earlier one.
double squared_distance_around(const Join& join, std::int64_t e, std::int64_t b,
                               std::int64_t crossfade, double velocity_s) {
    double sum = 0;
    double weights = 0;
    for (std::int64_t i = -crossfade; i <= crossfade; ++i) {
        if (e + i < 0 || e + i > join.earlier->frames() || b + i < 0 ||
            b + i >= join.later->frames())
            continue;
        const double x =
            static_cast<double>(i + crossfade + 1) / static_cast<double>(2 * crossfade + 2);
        const double weight = x * (1 - x);
        sum += weight * squared_distance(*join.earlier, e + i, *join.later, b + i, velocity_s);
        weights += weight;
    }
    return sum / weights;
}

/// The cut between frames `end` and `begin`, with the longest possible crossfade.
Cut cut_at(const Join& join, const CutOptions& options, std::int64_t end, std::int64_t begin) {
    const std::int64_t crossfade = crossfade_at(join, options.crossfade, end, begin);
    return {end, begin, crossfade,
            std::sqrt(squared_distance_around(join, end, begin, crossfade, options.velocity_s))};
}

/// Contribution of a cut to each step from frame to frame.
double added(const Cut& cut) {
    return cut.distance / static_cast<double>(2 * cut.crossfade + 1);
}

} // namespace

Lengths lengths_repeated(std::int64_t length) {
    constexpr double share = 0.08;
    const auto change = static_cast<std::int64_t>(share * static_cast<double>(length));
    return {length - change, length + change};
}

Lengths lengths_left_out(std::int64_t length, double cycle) {
    const double asked = std::abs(static_cast<double>(length));
    const auto least =
        static_cast<std::int64_t>(std::ceil(std::max(asked / 2, std::min(asked, cycle / 2))));
    Lengths lengths;
    if (length < 0)
        lengths.most = -least;
    if (length > 0)
        lengths.least = least;
    return lengths;
}

Cut find_cut(const Join& join, const CutOptions& options) {
    const Reach reach(join, options.search);
    std::optional<Cut> best;
    for (std::int64_t end = reach.first_end; end <= reach.last_end; ++end) {
        report_progress(Stage::synthesis, 0);
        for (std::int64_t begin = reach.first_begin; begin <= reach.last_begin; ++begin) {
            if (!join.lengths.allow(end - begin))
                continue;
            const Cut cut = cut_at(join, options, end, begin);
            if (!best || added(cut) < added(*best))
                best = cut;
        }
    }
    return best ? *best : cut_at(join, options, join.end, join.begin);
}

} // namespace stltsa::synthesis
