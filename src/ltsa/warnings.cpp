// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/random.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

/// Above this rank correlation with time, a coordinate has no significant turning point.
constexpr double largest_time_correlation = 0.98;
/// Below this ratio of eigenvalues the embedding may mix with the next eigenvector.
constexpr double small_gap = 1.05;
/// A larger estimated error is visible in a plot.
constexpr double large_error = 1e-6;
/// Above this angle, which corresponds to 2e-7 of a window's first eigenvalue, features probably
/// have different units: in recorded motion it stayed below 1e-10.
constexpr double large_rounding = 1e-9;
/// Frames in random order stay below this share_in_order() in 99 of 100 cases if there are 100.
constexpr double least_order = 0.58;
constexpr std::int64_t least_ordered = 50;
constexpr std::int64_t most_compared = 1024;
/// Frames whose rank correlation is computed.
constexpr std::size_t most_ranked = 1 << 14;

} // namespace

double time_correlation(const Graph& graph, const Matrix& coords) {
    const auto& members =
        *std::max_element(graph.components.members.begin(), graph.components.members.end(),
                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
    // A sample of a long clip is enough: sorting all frames would not be linear.
    const std::size_t step = (members.size() + most_ranked - 1) / most_ranked;
    std::vector<std::size_t> order((members.size() + step - 1) / step);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return coords(members[a * step], 0) < coords(members[b * step], 0);
    });
    double squares = 0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const double d = static_cast<double>(order[rank]) - static_cast<double>(rank);
        squares += d * d;
    }
    const auto n = static_cast<double>(order.size());
    return std::abs(1 - 6 * squares / (n * (n * n - 1)));
}

double share_in_order(const DistinctFrames& frames) {
    const std::int64_t rows = frames.x.rows;
    if (rows < least_ordered)
        return 1;
    Random random(1);
    const auto any_row = [&] {
        const auto row =
            static_cast<std::int64_t>((random.symmetric() + 1) / 2 * static_cast<double>(rows));
        return std::min(row, rows - 1);
    };
    const std::int64_t compared = std::min(rows, most_compared);
    std::int64_t closer = 0, pairs = 0;
    std::size_t clip = 0;
    std::int64_t end = frames.lengths[0];
    for (std::int64_t i = 0; i < compared; ++i) {
        const std::int64_t row = i * rows / compared;
        while (row >= end)
            end += frames.lengths[++clip];
        if (row + 1 == end)
            continue;
        ++pairs;
        const auto distance = [&](std::int64_t a, std::int64_t b) {
            return squared_distance(frames.x.row(a), frames.x.row(b), frames.x.cols);
        };
        const std::int64_t one = any_row(), other = any_row();
        // Not the other way around: with a missing value there is no distance, and no evidence.
        if (!(distance(row, row + 1) >= distance(one, other)))
            ++closer;
    }
    return pairs < least_ordered / 2 ? 1 : static_cast<double>(closer) / static_cast<double>(pairs);
}

std::optional<Warning> order_warning(double share) {
    if (!(share < least_order))
        return std::nullopt;
    return Warning{WarningCode::no_order,
                   format_text("the rows show no order in time: consecutive rows are closer than "
                               "two random rows in only {:.0f} % of cases (50 % at random; motion: "
                               "above 75 %); if they are not frames in order of time, fit with "
                               "option mode spatial and option include_self off",
                               100 * share)};
}

Warnings warnings_of(const Graph& graph, const Model& model) {
    Warnings warnings;
    const auto warn = [&](WarningCode code, std::string text) {
        warnings.push_back({code, std::move(text)});
    };
    const double order = model.parameters.mode == Mode::spatial ? 1 : share_in_order(graph.frames);
    if (auto warning = order_warning(order))
        warnings.push_back(*std::move(warning));
    else if (model.parameters.mode == Mode::temporal &&
             model.time_correlation > largest_time_correlation)
        warn(WarningCode::follows_time,
             format_text(
                 "coordinate 1 only follows time and does not turn back (its rank correlation with "
                 "time is {:.3f}; 1: it always grows or always shrinks), so the curve shows no "
                 "cycle; if the motion is cyclic, use as many neighbors as there are frames in 1.2 "
                 "cycles instead of {}",
                 model.time_correlation, model.parameters.neighbors));
    std::int64_t deficient = 0;
    double gap = INFINITY;
    double error = 0;
    for (const Component& component : model.components) {
        deficient += component.rank_deficient_windows;
        if (component.gap > 0)
            gap = std::min(gap, component.gap);
        error = std::max(error, component.error_estimate);
    }
    if (deficient > 0)
        warn(WarningCode::rank_deficient,
             format_text(
                 "{} of {} windows, each a frame with its neighbors, vary in fewer directions "
                 "than the dimension, {}, as at rest: these windows constrain the curve less",
                 deficient, graph.frames.x.rows, model.parameters.dimension));
    if (gap < small_gap)
        warn(WarningCode::small_gap,
             format_text(
                 "dimension {} is poorly defined: the next coordinate would fit the neighborhoods "
                 "nearly as well (the eigenvalues, which measure the misfit, differ by {:.2g} %), "
                 "so small changes of the data may change the curve; try another dimension",
                 model.parameters.dimension, 100 * (gap - 1)));
    const auto last = static_cast<std::size_t>(model.parameters.dimension - 1);
    if (graph.tangents.rounding[last] > large_rounding)
        warn(
            WarningCode::unscaled,
            format_text(
                "direction {} of the windows is so small compared with the first that rounding may "
                "turn it by {:.1g} radians: if features have different units, scale them to "
                "similar ranges",
                last + 1, graph.tangents.rounding[last]));
    if (error >= unknown_error)
        warn(
            WarningCode::inaccurate,
            "the error of the curve is unknown, because its eigenvalues, which measure the misfit, "
            "are rounding noise; if features differ greatly in magnitude, scale them");
    else if (error > large_error)
        warn(WarningCode::inaccurate,
             format_text("rounding errors may turn the curve by {:.1g} radians: its eigenvalues, "
                         "which measure the misfit, are hardly larger than rounding noise; if "
                         "features differ greatly in magnitude, scale them",
                         error));
    return warnings;
}

Warning parts_warning(const Model& model, const std::string& cut, double cut_s) {
    return {WarningCode::disconnected,
            format_text("the frames fall into {} parts that share no neighbors{}; each part has "
                        "its own coordinates (if the clip has no cut, use mode recurrent or more "
                        "neighbors)",
                        model.components.size(), cut.empty() ? "" : ", cut at " + cut),
            cut_s, cut_s};
}

} // namespace stltsa::ltsa
