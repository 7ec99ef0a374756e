// SPDX-License-Identifier: BSD-3-Clause
#include "phase/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "phase/lag.hpp"

namespace stltsa::phase {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr Estimate unknown{none, none, none, none, none, none, none, none, false};

using Columns = std::vector<std::int64_t>;

Matrix chosen(const Matrix& from, const Columns& columns) {
    Matrix result =
        Matrix::unset(from.rows() - 1, static_cast<std::int64_t>(columns.size()));
    for (std::int64_t s = 0; s < result.rows(); ++s)
        for (std::int64_t c = 0; c < result.cols(); ++c)
            result(s, c) = from(s, columns[static_cast<std::size_t>(c)]);
    return result;
}

/// Mean curve of some columns, and the curve of each cycle.
struct Curves {
    Matrix mean;
    std::vector<Matrix> each;
};

Curves curves_of(const Resampled& from, const Columns& columns) {
    Curves curves{chosen(from.mean, columns), {}};
    for (const Matrix& cycle : from.each)
        curves.each.push_back(chosen(cycle, columns));
    return curves;
}

double inner(const Matrix& a, const Matrix& b) {
    double sum = 0;
    for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
        sum += a.data()[i] * b.data()[i];
    return sum;
}

/// The lag of two curves, and by how much the cycles of each would move it.
struct Timing {
    Lag lag;
    Quantity first, second; ///< as shares of the cycle
};

/// The lag is where <A(s), B(s + lag)> is greatest, so <A'(s), B(s + lag)> = 0 there: a cycle that
/// deviates from B by b moves it by -<A', b> / <A', B'>, one that deviates from A by a by
/// <a, B'> / <A', B'>.
Timing timing_of(const Curves& first, const Curves& second, std::int64_t most, double least) {
    Timing timing;
    timing.lag = lag_between(first.mean, second.mean, most);
    if (!(timing.lag.correlation >= least))
        timing.lag.samples = none;
    if (std::isnan(timing.lag.samples))
        return timing;
    const double lag = timing.lag.samples, count = static_cast<double>(first.mean.rows());
    const Matrix rise = slope(first.mean), other_rise = slope(later(second.mean, lag));
    const Matrix rise_there = later(rise, -lag);
    const double bend = -inner(rise, other_rise) * count;
    const double level = inner(first.mean, other_rise);
    for (const Matrix& cycle : first.each)
        timing.first.deviations.push_back((inner(cycle, other_rise) - level) / bend);
    const double other_level = inner(second.mean, rise_there);
    for (const Matrix& cycle : second.each)
        timing.second.deviations.push_back((inner(cycle, rise_there) - other_level) / bend);
    timing.second.value = lag / count;
    return timing;
}

/// Removes the timing of the whole body from that of a part.
void subtract(const Quantity& whole, Quantity& part) {
    part.value -= whole.value;
    for (std::size_t k = 0; k < part.deviations.size(); ++k)
        part.deviations[k] -= whole.deviations[k];
}

double squared_distance_between(const Matrix& curve, std::int64_t a, std::int64_t b) {
    double sum = 0;
    for (std::int64_t c = 0; c < curve.cols(); ++c)
        sum += (curve(a, c) - curve(b, c)) * (curve(a, c) - curve(b, c));
    return sum;
}

/// The distance of the places of the mean curve that are farthest apart; of a cycle, the distance of
/// the same places in that direction.
Quantity amplitude_of(const Curves& curves) {
    std::int64_t from = 0, to = 0;
    double most = 0;
    for (std::int64_t a = 0; a < curves.mean.rows(); ++a)
        for (std::int64_t b = 0; b < a; ++b)
            if (const double found = squared_distance_between(curves.mean, a, b); found > most) {
                most = found;
                from = a;
                to = b;
            }
    Quantity amplitude{std::sqrt(most), {}};
    for (const Matrix& cycle : curves.each) {
        double along = 0;
        for (std::int64_t c = 0; c < cycle.cols() && most > 0; ++c)
            along += (curves.mean(from, c) - curves.mean(to, c)) / amplitude.value *
                     (cycle(from, c) - cycle(to, c));
        amplitude.deviations.push_back(along - amplitude.value);
    }
    return amplitude;
}

/// The ratio of two amplitudes, by the difference of their logarithms.
Estimate ratio_of(const Quantity& first, const Quantity& second, bool paired) {
    if (!(first.value > 0 && second.value > 0))
        return unknown;
    const auto logarithm = [](const Quantity& of) {
        Quantity result{std::log(of.value), {}};
        for (const double deviation : of.deviations)
            result.deviations.push_back(deviation / of.value);
        return result;
    };
    Estimate of_logarithms = estimate(logarithm(first), logarithm(second), paired);
    Estimate ratio = unknown;
    ratio.difference = second.value / first.value;
    ratio.low = std::exp(of_logarithms.low);
    ratio.high = std::exp(of_logarithms.high);
    return ratio;
}

double mean_of(const Matrix& values) {
    double sum = 0;
    for (std::int64_t i = 0; i < values.rows() * values.cols(); ++i)
        sum += values.data()[i];
    return sum / static_cast<double>(values.rows() * values.cols());
}

Quantity level_of(const Curves& curves) {
    Quantity level{mean_of(curves.mean), {}};
    for (const Matrix& cycle : curves.each)
        level.deviations.push_back(mean_of(cycle) - level.value);
    return level;
}

/// Root mean square over the samples of the sum over the columns of squares, without the last
/// sample, which is the first again.
double rms_of(const Matrix& values, const Columns& columns) {
    double squares = 0;
    for (std::int64_t s = 0; s + 1 < values.rows(); ++s)
        for (const std::int64_t c : columns)
            squares += values(s, c) * values(s, c);
    return std::sqrt(squares / static_cast<double>(values.rows() - 1));
}

void set_pointwise(const Resampled& first, const Resampled& second, bool paired,
                   Differences& result) {
    const std::int64_t rows = first.mean.rows(), cols = first.mean.cols();
    const auto n = static_cast<double>(first.each.size());
    const auto m = static_cast<double>(second.each.size());
    for (Matrix* matrix : {&result.difference, &result.error, &result.margin})
        *matrix = Matrix::unset(rows, cols);
    std::vector<double> differences;
    for (std::int64_t i = 0; i < rows * cols; ++i) {
        differences.clear();
        for (std::size_t k = 0; paired && k < first.each.size(); ++k)
            differences.push_back(second.each[k].data()[i] - first.each[k].data()[i]);
        const Uncertainty error =
            paired ? paired_error(deviation_of(differences), n)
                   : welch(first.deviation.data()[i], n, second.deviation.data()[i], m);
        result.difference.data()[i] = second.mean.data()[i] - first.mean.data()[i];
        result.error.data()[i] = error.standard;
        result.margin.data()[i] = error.margin;
    }
}

/// What all parts have in common.
struct Compared {
    const Resampled& first;
    const Resampled& second;
    const Timing* whole; ///< null: lags count from the cycle
    bool paired = false;
    const Differences& pointwise;
};

PartDifference part_difference(const Compared& of, const Columns& columns) {
    const Curves first = curves_of(of.first, columns), second = curves_of(of.second, columns);
    PartDifference part;
    part.rms = rms_of(of.pointwise.difference, columns);
    part.chance = rms_of(of.pointwise.error, columns);
    Timing timing = timing_of(first, second, first.mean.rows() / 4, least_correlation);
    part.correlation = timing.lag.correlation;
    part.lag = part.mean = unknown;
    if (!std::isnan(timing.lag.samples)) {
        if (of.whole != nullptr) {
            subtract(of.whole->first, timing.first);
            subtract(of.whole->second, timing.second);
        }
        part.lag = estimate(timing.first, timing.second, of.paired);
    }
    const Quantity amplitude = amplitude_of(first), other = amplitude_of(second);
    part.amplitude = estimate(amplitude, other, of.paired);
    part.ratio = ratio_of(amplitude, other, of.paired);
    if (columns.size() == 1)
        part.mean = estimate(level_of(first), level_of(second), of.paired);
    return part;
}

} // namespace

Matrix once_around(const Matrix& samples) {
    Matrix result = Matrix::unset(samples.rows() - 1, samples.cols());
    std::copy_n(samples.data(), result.rows() * result.cols(), result.data());
    return result;
}

Differences compare(const Resampled& first, const Resampled& second,
                    std::span<const std::int64_t> groups, bool paired) {
    Differences result;
    set_pointwise(first, second, paired, result);
    Columns all;
    std::vector<Columns> parts(static_cast<std::size_t>(std::ranges::max(groups) + 1));
    for (std::size_t c = 0; c < groups.size(); ++c) {
        all.push_back(static_cast<std::int64_t>(c));
        parts[static_cast<std::size_t>(groups[c])].push_back(static_cast<std::int64_t>(c));
    }
    const Curves body = curves_of(first, all), other = curves_of(second, all);
    const Timing whole = timing_of(body, other, body.mean.rows() / 2, -1);
    result.likeness = whole.lag.correlation;
    result.runner_up = whole.lag.runner_up;
    const bool aligned = !paired && !std::isnan(whole.lag.samples);
    result.whole = aligned ? estimate(whole.first, whole.second, false) : unknown;
    result.shift = aligned ? whole.second.value : 0;
    const Compared compared{first, second, aligned ? &whole : nullptr, paired, result};
    for (const Columns& columns : parts)
        result.parts.push_back(part_difference(compared, columns));
    for (const std::int64_t column : all)
        result.columns.push_back(part_difference(compared, {column}));
    return result;
}

} // namespace stltsa::phase
