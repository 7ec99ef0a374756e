// SPDX-License-Identifier: BSD-3-Clause
#include "results/summary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::results {
namespace {

constexpr double minute = 60;

/// One quantity of several parts, and their middles in seconds.
struct Values {
    std::vector<double> value, middle;

    void add(double of_part, const stltsa_part& part) {
        value.push_back(of_part);
        middle.push_back((part.begin_s + part.end_s) / 2);
    }
};

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

/// The least-squares line through the values over time.
struct Line {
    double mean = 0, slope = 0;
    double squares = 0; ///< sum of squared deviations of the values from their mean
    double spread = 0;  ///< the same of the times

    double squares_left() const { return squares - slope * slope * spread; }
};

Line line_through(const Values& all) {
    Line line{mean_of(all.value)};
    const double center = mean_of(all.middle);
    double product = 0;
    for (std::size_t i = 0; i < all.value.size(); ++i) {
        const double apart = all.value[i] - line.mean, at = all.middle[i] - center;
        line.squares += apart * apart;
        product += apart * at;
        line.spread += at * at;
    }
    line.slope = line.spread > 0 ? product / line.spread : 0;
    return line;
}

/// `ratios`: the values have a zero, so that their spread can be divided by their mean.
stltsa_statistics statistics_of(const Values& all, bool ratios) {
    if (all.value.empty())
        return {0, none, none, none, none};
    stltsa_statistics found{};
    found.count = static_cast<std::int64_t>(all.value.size());
    const Line line = line_through(all);
    found.mean = line.mean;
    found.cv = found.trend = ratios ? 0 : none;
    if (found.count < 2)
        return found;
    found.sd = std::sqrt(line.squares / static_cast<double>(found.count - 1));
    if (ratios && found.mean > 0) {
        found.cv = found.sd / found.mean;
        found.trend = minute * line.slope / found.mean;
    }
    return found;
}

stltsa_summary summary_of(int32_t label, const Values& all) {
    const stltsa_statistics lengths = statistics_of(all, true);
    stltsa_summary summary{};
    summary.label = label;
    summary.count = lengths.count;
    summary.mean_s = lengths.mean;
    summary.per_minute = minute / lengths.mean;
    summary.sd_s = lengths.sd;
    summary.cv = lengths.cv;
    summary.trend = lengths.trend;
    return summary;
}

double quantity_of(const stltsa_part& part, const stltsa_travel& travel, std::int32_t quantity) {
    switch (quantity) {
    case STLTSA_QUANTITY_TIME:
        return part.end_s - part.begin_s;
    case STLTSA_QUANTITY_WAY:
        return travel.way;
    case STLTSA_QUANTITY_STRIDE:
        return travel.stride;
    case STLTSA_QUANTITY_SPEED:
        return travel.speed;
    default:
        return travel.turn;
    }
}

} // namespace

std::vector<stltsa_summary> summaries_of(std::span<const stltsa_segment> segments,
                                         std::span<const stltsa_part> cycles,
                                         std::span<const stltsa_part> repetitions) {
    std::map<int32_t, Values> labels;
    for (const auto parts : {cycles, repetitions})
        for (const stltsa_part& part : parts)
            labels[segments[static_cast<std::size_t>(part.segment)].label].add(
                part.end_s - part.begin_s, part);
    std::vector<stltsa_summary> summaries;
    for (const auto& [label, lengths] : labels)
        summaries.push_back(summary_of(label, lengths));
    return summaries;
}

stltsa_statistics statistics_of(std::span<const stltsa_segment> segments, const Parts& all,
                                std::int32_t label, std::int32_t side, std::int32_t quantity) {
    const auto& [parts, travels] = all;
    Values values;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto segment = static_cast<std::size_t>(parts[i].segment);
        const double value = quantity_of(parts[i], travels[i], quantity);
        if (segments[segment].label == label && (side < 0 || parts[i].side == side) &&
            std::isfinite(value))
            values.add(value, parts[i]);
    }
    return statistics_of(values, quantity != STLTSA_QUANTITY_TURN);
}

double trend_margin(std::span<const stltsa_segment> segments, std::span<const stltsa_part> parts,
                    std::int32_t label) {
    Values lengths;
    for (const stltsa_part& part : parts)
        if (segments[static_cast<std::size_t>(part.segment)].label == label)
            lengths.add(part.end_s - part.begin_s, part);
    if (lengths.value.size() < 3)
        return none;
    const Line line = line_through(lengths);
    const auto freedom = static_cast<double>(lengths.value.size() - 2);
    const double error = std::sqrt(std::max(0.0, line.squares_left()) / freedom / line.spread);
    return minute * motion::t_quantile(freedom) * error / line.mean;
}

} // namespace stltsa::results
