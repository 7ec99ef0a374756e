// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stltsa::synthesis {
namespace {

/// A repeated stretch may become this much shorter or longer, as a share of its length.
constexpr double length_change = 0.08;

/// A quarter of a stretch is the most that a cut takes from it, and that a crossfade covers: then
/// what happens at one of its ends never reaches what happens at the other.
std::int64_t quarter(std::int64_t length) {
    return length / 4;
}

/// The pairs of cuts that are allowed; ranges with their ends.
struct Allowed {
    std::int64_t first_end, last_end;
    std::int64_t first_begin, last_begin;
    std::int64_t shortest, longest; ///< a repeated stretch, from begin to end

    Allowed(const Join& join, std::int64_t search) {
        first_end = join.end - std::min(search, quarter(join.earlier_length));
        last_end = std::min(join.end + search, join.earlier->frames());
        last_begin = std::min(join.begin + std::min(search, quarter(join.later_length)),
                              join.later->frames() - 1);
        first_begin = std::max<std::int64_t>(join.begin - search, 0);
        if (join.later->first <= last_begin) // not into a T-pose, where it can be helped
            first_begin = std::max(first_begin, join.later->first);
        constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max() / 2;
        const std::int64_t length = join.end - join.begin;
        const auto change =
            join.repeats ? static_cast<std::int64_t>(length_change * static_cast<double>(length))
                         : any;
        shortest = length - change;
        longest = length + change;
    }

    bool length(std::int64_t frames) const { return frames >= shortest && frames <= longest; }
};

/// As much of the wanted crossfade as the clips have frames for.
std::int64_t crossfade_at(const Join& join, std::int64_t wanted, std::int64_t end,
                          std::int64_t begin) {
    return std::max<std::int64_t>(
        0, std::min({wanted, quarter(join.earlier_length), quarter(join.later_length),
                     join.earlier->frames() - end, join.later->frames() - begin,
                     begin - join.later->first}));
}

/// Squared distance of two postures and velocities and of those around them that a crossfade mixes,
/// each counting as much as the crossfade changes there: as the slope of smoothstep, x (1 - x).
/// What the later frame takes the place of is the earlier stretch's frame e.
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

} // namespace

Cut find_cut(const Join& join, const CutOptions& options, const Progress& progress) {
    const Allowed allowed(join, options.search);
    Cut best;
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t end = allowed.first_end; end <= allowed.last_end; ++end) {
        progress.report(Stage::synthesis, 0);
        for (std::int64_t begin = allowed.first_begin; begin <= allowed.last_begin; ++begin) {
            if (!allowed.length(end - begin))
                continue;
            const std::int64_t crossfade = crossfade_at(join, options.crossfade, end, begin);
            const double distance =
                std::sqrt(squared_distance_around(join, end, begin, crossfade, options.velocity_s));
            // What is added to each step from frame to frame.
            const double added = distance / static_cast<double>(2 * crossfade + 1);
            if (added < least) {
                least = added;
                best = {end, begin, crossfade, distance};
            }
        }
    }
    return best;
}

} // namespace stltsa::synthesis
