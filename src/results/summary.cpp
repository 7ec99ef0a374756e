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

double quantity_of(const stltsa_part& part, std::int32_t quantity) {
    switch (quantity) {
    case STLTSA_QUANTITY_TIME:
        return part.end_s - part.begin_s;
    case STLTSA_QUANTITY_PATH_LENGTH:
        return part.path_length;
    case STLTSA_QUANTITY_STRIDE:
        return part.stride;
    case STLTSA_QUANTITY_SPEED:
        return part.speed;
    default:
        return part.turn_deg;
    }
}

/// Of a label with cycles here and pauses there, both.
stltsa_statistics lengths_of(std::span<const stltsa_part> cycles,
                             std::span<const stltsa_part> repetitions, std::int64_t label) {
    Values lengths;
    for (const auto parts : {cycles, repetitions})
        for (const stltsa_part& part : parts)
            if (part.label == label)
                lengths.add(part.end_s - part.begin_s, part);
    return statistics_of(lengths, true);
}

} // namespace

std::vector<stltsa_summary> summaries_of(std::span<const stltsa_part> cycles,
                                         std::span<const stltsa_part> steps,
                                         std::span<const stltsa_part> repetitions) {
    std::map<std::int64_t, const char*> labels;
    for (const auto parts : {cycles, repetitions})
        for (const stltsa_part& part : parts)
            labels.emplace(part.label, part.letters);
    std::vector<stltsa_summary> summaries;
    for (const auto& [label, letters] : labels) {
        const auto parts =
            statistics_of(cycles, label, -1, STLTSA_QUANTITY_TIME).count > 0 ? cycles : repetitions;
        const auto of = [&, label = label](std::int32_t quantity) {
            return statistics_of(parts, label, -1, quantity);
        };
        const auto of_steps = [&, label = label](std::int64_t side) {
            return statistics_of(steps, label, side, STLTSA_QUANTITY_TIME);
        };
        stltsa_summary summary{};
        summary.label = label;
        summary.letters = letters;
        summary.cycle_time_s = lengths_of(cycles, repetitions, label);
        summary.count = summary.cycle_time_s.count;
        summary.cycles_per_min = minute / summary.cycle_time_s.mean;
        summary.step_time_s = of_steps(-1);
        summary.steps_per_min = minute / summary.step_time_s.mean;
        summary.step_time_side_0_s = of_steps(0).mean;
        summary.step_time_side_1_s = of_steps(1).mean;
        summary.path_length = of(STLTSA_QUANTITY_PATH_LENGTH);
        summary.stride = of(STLTSA_QUANTITY_STRIDE);
        summary.speed = of(STLTSA_QUANTITY_SPEED);
        summary.turn_deg = of(STLTSA_QUANTITY_TURN);
        summaries.push_back(summary);
    }
    return summaries;
}

stltsa_statistics statistics_of(std::span<const stltsa_part> parts, std::int64_t label,
                                std::int64_t side, std::int32_t quantity) {
    Values values;
    for (const stltsa_part& part : parts)
        if (const double value = quantity_of(part, quantity);
            part.label == label && (side < 0 || part.side == side) && std::isfinite(value))
            values.add(value, part);
    return statistics_of(values, quantity != STLTSA_QUANTITY_TURN);
}

double trend_margin(std::span<const stltsa_part> parts, std::int64_t label) {
    Values lengths;
    for (const stltsa_part& part : parts)
        if (part.label == label)
            lengths.add(part.end_s - part.begin_s, part);
    if (lengths.value.size() < 3)
        return none;
    const Line line = line_through(lengths);
    const auto freedom = static_cast<double>(lengths.value.size() - 2);
    const double error = std::sqrt(std::max(0.0, line.squares_left()) / freedom / line.spread);
    return minute * motion::t_quantile(freedom) * error / line.mean;
}

} // namespace stltsa::results
