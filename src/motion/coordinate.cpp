// SPDX-License-Identifier: BSD-3-Clause
#include "motion/coordinate.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa::motion {
namespace {

/// A model with more dimensions is less simple: its cyclicity must be higher by this.
constexpr double clearly_better = 0.1;

/// Correlation of the coordinate with itself `lag` samples later; each of the two has its own mean.
double autocorrelation(std::span<const double> u, std::span<const double> level, std::size_t lag) {
    if (lag + 1 >= u.size())
        return 0;
    double weight = 0, early = 0, late = 0;
    for (std::size_t t = 0; t + lag < u.size(); ++t) {
        const double w = std::sqrt(level[t] * level[t + lag]);
        weight += w;
        early += w * u[t];
        late += w * u[t + lag];
    }
    if (!(weight > 0))
        return 0;
    early /= weight;
    late /= weight;
    double both = 0, early_square = 0, late_square = 0;
    for (std::size_t t = 0; t + lag < u.size(); ++t) {
        const double w = std::sqrt(level[t] * level[t + lag]);
        both += w * (u[t] - early) * (u[t + lag] - late);
        early_square += w * (u[t] - early) * (u[t] - early);
        late_square += w * (u[t + lag] - late) * (u[t + lag] - late);
    }
    const double scale = std::sqrt(early_square * late_square);
    return scale > 0 ? both / scale : 0;
}

/// The same for a fractional lag, by linear interpolation.
double autocorrelation_at(std::span<const double> u, std::span<const double> level, double lag) {
    const auto below = static_cast<std::size_t>(lag);
    const double fraction = lag - std::floor(lag);
    return (1 - fraction) * autocorrelation(u, level, below) +
           fraction * autocorrelation(u, level, below + 1);
}

/// Of two columns of a loop either may be a little more cyclic, depending on noise; the earlier
/// one, which changes more slowly, is chosen unless the other is better by this. With 5 to 20 % of
/// the samples of markers missing, it keeps the choice (measure/gaps); without it, 3 of 10 clips
/// change coordinate, and all their borders move by a quarter of a cycle.
constexpr double little_better = 0.01;

struct Column {
    std::int64_t column;
    double cyclicity;
};

/// The columns in order of decreasing cyclicity.
std::vector<Column> by_cyclicity(ConstMatrixView coords, std::span<const double> level,
                                 double period) {
    std::vector<Column> columns;
    for (std::int64_t c = 0; c < coords.cols; ++c)
        columns.push_back({c, cyclicity(column_of(coords, c), level, period)});
    std::stable_sort(columns.begin(), columns.end(),
                     [](const Column& a, const Column& b) { return a.cyclicity > b.cyclicity; });
    return columns;
}

} // namespace

double cyclicity(std::span<const double> coordinate, std::span<const double> level, double period) {
    return 0.5 * (autocorrelation_at(coordinate, level, period) -
                  autocorrelation_at(coordinate, level, period / 2));
}

Coordinate choose_coordinate(const std::vector<ltsa::Model>& models, std::optional<int> dimension,
                             std::span<const double> level, double period) {
    std::optional<Coordinate> chosen;
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (dimension && models[m].coords.cols() != *dimension)
            continue;
        const auto columns = by_cyclicity(models[m].coords.view(), level, period);
        const Column best = *std::ranges::min_element(columns, {}, [&](const Column& each) {
            const bool close = each.cyclicity >= columns.front().cyclicity - little_better;
            return close ? each.column : models[m].coords.cols();
        });
        if (!chosen || best.cyclicity > chosen->cyclicity + clearly_better)
            chosen = {m, best.column, best.cyclicity};
    }
    return chosen.value_or(Coordinate{});
}

std::optional<Loop> choose_loop(const std::vector<ltsa::Model>& models,
                                std::span<const double> level, double period) {
    std::optional<Loop> chosen;
    double score = 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
        if (models[m].coords.cols() < 2)
            continue;
        const auto columns = by_cyclicity(models[m].coords.view(), level, period);
        if (chosen && columns[1].cyclicity <= score + clearly_better)
            continue;
        score = columns[1].cyclicity;
        const auto [first, second] = std::minmax(columns[0].column, columns[1].column);
        chosen = {m, first, second};
    }
    return chosen;
}

std::vector<double> column_of(ConstMatrixView matrix, std::int64_t column) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(matrix.rows));
    for (std::int64_t i = 0; i < matrix.rows; ++i)
        values.push_back(matrix(i, column));
    return values;
}

} // namespace stltsa::motion
