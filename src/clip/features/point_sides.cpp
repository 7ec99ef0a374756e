// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/point_sides.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/side_name.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/points.hpp"
#include "linalg/principal.hpp"

namespace stltsa::clip {
namespace {

/// Points in this lowest share of the height are of the legs; hands hang higher.
constexpr double low_share = 1.0 / 3;

/// The horizontal line along which the points of the pairs lie apart: the first principal direction
/// of their differences, in which the first point of the first pair is positive.
struct Line {
    double a = 1, b = 0;
};

Line lateral(const std::vector<SidePair>& pairs, const std::vector<double>& mean, std::size_t first,
             std::size_t second) {
    double aa = 0, ab = 0, bb = 0;
    const auto apart = [&](const SidePair& pair) {
        return Line{mean[3 * pair.one + first] - mean[3 * pair.other + first],
                    mean[3 * pair.one + second] - mean[3 * pair.other + second]};
    };
    for (const SidePair& pair : pairs) {
        const Line d = apart(pair);
        aa += d.a * d.a, ab += d.a * d.b, bb += d.b * d.b;
    }
    const double angle = std::atan2(2 * ab, aa - bb) / 2;
    const Line line{std::cos(angle), std::sin(angle)};
    const Line d = apart(pairs.front());
    return d.a * line.a + d.b * line.b < 0 ? Line{-line.a, -line.b} : line;
}

/// The line across the direction in which the points of the pairs swing against each other, if it
/// is near the line along which they lie apart: of a body that moves forward. It is the better one
/// of the two, because lateral motion is the same for both sides of a step: at a degree of
/// difference, equal steps of 0.55 s seem to last 0.547 and 0.553 s.
Line across_swing(const std::vector<SidePair>& pairs, ConstMatrixView samples, std::size_t first,
                  std::size_t second, const Line& apart) {
    constexpr double near = 0.87; // cosine of 30 degrees
    double aa = 0, ab = 0, bb = 0;
    for (std::int64_t i = 1; i < samples.rows; ++i)
        for (const SidePair& pair : pairs) {
            const auto swing = [&](std::size_t axis) {
                const auto one = static_cast<std::int64_t>(3 * pair.one + axis);
                const auto other = static_cast<std::int64_t>(3 * pair.other + axis);
                return samples(i, one) - samples(i, other) - samples(i - 1, one) +
                       samples(i - 1, other);
            };
            const double a = swing(first), b = swing(second);
            aa += a * a, ab += a * b, bb += b * b;
        }
    const double angle = std::atan2(2 * ab, aa - bb) / 2;
    Line line{-std::sin(angle), std::cos(angle)};
    const double along = line.a * apart.a + line.b * apart.b;
    if (along < 0)
        line = {-line.a, -line.b};
    return std::abs(along) > near ? line : apart;
}

} // namespace

std::vector<SidePair> side_pairs(const Clip& clip) {
    const auto space = static_cast<std::size_t>(point_columns(clip));
    std::vector<std::string> names;
    for (std::size_t c = 0; c + space <= clip.channel_names.size(); c += space) {
        if (clip.channel_names[c].empty())
            return {};
        names.emplace_back(point_name(clip.channel_names[c]));
    }
    std::vector<SidePair> pairs;
    const std::vector<Sided> sides = sides_of(names);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (sides[i].partner > i)
            pairs.push_back({i, sides[i].partner});
    return pairs;
}

std::vector<double> point_side_weights(const Clip& clip, Axis up, ConstMatrixView samples) {
    const std::vector<SidePair> pairs = side_pairs(clip);
    if (pairs.empty() || point_columns(clip) != 3 || up == Axis::none)
        return {};
    const auto above = static_cast<std::size_t>(up) - 1;
    const std::size_t first = (above + 1) % 3, second = (above + 2) % 3;
    const std::vector<double> mean = column_means(samples);
    std::vector<double> heights;
    for (std::size_t c = above; c < mean.size(); c += 3)
        heights.push_back(mean[c]);
    for (const auto& [one, other] : pairs) // a limp does not part a pair
        heights[one] = heights[other] = (heights[one] + heights[other]) / 2;
    const auto [least, most] = std::ranges::minmax(heights);
    const double highest = least + low_share * (most - least);
    std::vector<SidePair> legs;
    std::ranges::copy_if(pairs, std::back_inserter(legs),
                         [&](const SidePair& pair) { return heights[pair.one] <= highest; });
    if (legs.empty())
        return {};
    const Line line =
        across_swing(legs, samples, first, second, lateral(pairs, mean, first, second));
    std::vector<double> weights(mean.size());
    const auto set = [&](std::size_t point, double weight) {
        weights[3 * point + first] = -line.b * weight;
        weights[3 * point + second] = line.a * weight;
    };
    for (const auto& [one, other] : legs) {
        const double across = line.a * (mean[3 * one + first] - mean[3 * other + first]) +
                              line.b * (mean[3 * one + second] - mean[3 * other + second]);
        set(one, across > 0 ? 1 : -1);
        set(other, across > 0 ? -1 : 1);
    }
    return weights;
}

} // namespace stltsa::clip
