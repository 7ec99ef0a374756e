// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/turning.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/splice.hpp"

namespace stltsa::synthesis {
namespace {

/// Unwrapped headings of frames [first, last], starting at 0.
std::vector<double> headings(const Body& body, const Track& track, std::int64_t first,
                             std::int64_t last) {
    std::vector<double> result{0};
    for (std::int64_t frame = first + 1; frame <= last; ++frame)
        result.push_back(result.back() + step_to(body, track, frame).turn);
    return result;
}

/// Turn of one repetition as played, including its crossfade.
double turn_of_repetition(const Body& body, const Track& track, const Cut& cut) {
    const auto turn = [&](std::int64_t frame) { return step_to(body, track, frame).turn; };
    const std::int64_t w = cut.crossfade;
    double sum = w > 0 ? 0 : (turn(cut.end) + turn(cut.begin)) / 2;
    for (std::int64_t i = -w; i < w; ++i) {
        const double weight = crossfade_weight(i, w);
        sum += (1 - weight) * turn(cut.end + i) + weight * turn(cut.begin + i);
    }
    for (std::int64_t frame = cut.begin + std::max<std::int64_t>(w, 1); frame < cut.end - w;
         ++frame)
        sum += turn(frame);
    return sum;
}

/// Range of the heading after subtracting the steady turn.
double swing(const double* heading, std::int64_t count) {
    const double steady = (heading[count - 1] - heading[0]) / static_cast<double>(count - 1);
    double least = heading[0];
    double most = heading[0];
    for (std::int64_t i = 0; i < count; ++i) {
        const double deviation = heading[i] - steady * static_cast<double>(i);
        least = std::min(least, deviation);
        most = std::max(most, deviation);
    }
    return most - least;
}

} // namespace

double stray_turn(const Body& body, const Track& track, const Cut& cut) {
    const std::int64_t length = cut.end - cut.begin;
    const std::int64_t first = std::max(std::min(track.first, cut.begin), cut.begin - length);
    const std::int64_t last = std::min(track.frames() - 1, cut.end + length);
    if (length < 2 || last - first < length)
        return 0;
    const std::vector<double> heading = headings(body, track, first, last);
    const double turn = turn_of_repetition(body, track, cut);
    if (std::abs(turn) >= swing(heading.data() + (cut.begin - first), length))
        return 0;
    bool left = false;
    bool right = false;
    for (std::int64_t i = 0; i + length <= last - first; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double turned = heading[at + static_cast<std::size_t>(length)] - heading[at];
        left = left || turned > 0;
        right = right || turned < 0;
    }
    return left && right ? turn : 0;
}

} // namespace stltsa::synthesis
