// SPDX-License-Identifier: BSD-3-Clause
#include "phase/compare.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "linalg/simd.hpp"
#include "phase/lag.hpp"

namespace stltsa::phase {
namespace {

constexpr Estimate unknown{none, none, none, none, none, none, none, none, false};

using Columns = std::vector<std::int64_t>;

/// Mean curve of some columns, and the curve of each cycle.
struct Curves {
    ConstMatrixView mean;
    std::vector<ConstMatrixView> each;
    std::vector<Matrix> chosen; ///< what the views refer to, unless all columns were chosen
};

Curves curves_of(const Resampled& from, const Columns& columns) {
    Curves curves;
    const auto view_of = [&](const Matrix& samples) -> ConstMatrixView {
        if (std::ssize(columns) == samples.cols())
            return once_around(samples);
        return curves.chosen.emplace_back(chosen(once_around(samples), columns)).view();
    };
    curves.mean = view_of(from.mean);
    for (const Matrix& cycle : from.each)
        curves.each.push_back(view_of(cycle));
    return curves;
}

double inner(ConstMatrixView a, ConstMatrixView b) {
    double sum = 0;
    for (std::int64_t s = 0; s < a.rows; ++s) {
        sum += dot(a.row(s), b.row(s), a.cols);
        checkpoint(2 * a.cols);
    }
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
    const double lag = timing.lag.samples, count = static_cast<double>(first.mean.rows);
    const Matrix rise = slope(first.mean), other_rise = slope(later(second.mean, lag).view());
    const Matrix rise_there = later(rise.view(), -lag);
    const double bend = -inner(rise.view(), other_rise.view()) * count;
    const double level = inner(first.mean, other_rise.view());
    for (const ConstMatrixView& cycle : first.each)
        timing.first.deviations.push_back((inner(cycle, other_rise.view()) - level) / bend);
    const double other_level = inner(second.mean, rise_there.view());
    for (const ConstMatrixView& cycle : second.each)
        timing.second.deviations.push_back((inner(cycle, rise_there.view()) - other_level) / bend);
    timing.second.value = lag / count;
    return timing;
}

/// Removes the timing of the whole body from that of a part.
void subtract(const Quantity& whole, Quantity& part) {
    part.value -= whole.value;
    for (std::size_t k = 0; k < part.deviations.size(); ++k)
        part.deviations[k] -= whole.deviations[k];
}

double squared_distance_between(ConstMatrixView curve, std::int64_t a, std::int64_t b) {
    double sum = 0;
    for (std::int64_t c = 0; c < curve.cols; ++c)
        sum += (curve(a, c) - curve(b, c)) * (curve(a, c) - curve(b, c));
    return sum;
}

/// The distance between the two points of the mean curve that are farthest apart; for a cycle, the
/// distance between the same two points in that direction.
Quantity amplitude_of(const Curves& curves) {
    std::int64_t from = 0, to = 0;
    double most = 0;
    for (std::int64_t a = 0; a < curves.mean.rows; ++a)
        for (std::int64_t b = 0; b < a; ++b) {
            if (const double found = squared_distance_between(curves.mean, a, b); found > most) {
                most = found;
                from = a;
                to = b;
            }
            checkpoint(curves.mean.cols);
        }
    Quantity amplitude{std::sqrt(most), {}};
    for (const ConstMatrixView& cycle : curves.each) {
        double along = 0;
        for (std::int64_t c = 0; c < cycle.cols && most > 0; ++c)
            along += (curves.mean(from, c) - curves.mean(to, c)) / amplitude.value *
                     (cycle(from, c) - cycle(to, c));
        amplitude.deviations.push_back(along - amplitude.value);
    }
    return amplitude;
}

/// The ratio of two amplitudes, by the difference of their logarithms.
Estimate ratio_of(const Quantity& first, const Quantity& second, const Dependence& dependence) {
    if (!(first.value > 0 && second.value > 0))
        return unknown;
    const auto logarithm = [](const Quantity& of) {
        Quantity result{std::log(of.value), {}};
        for (const double deviation : of.deviations)
            result.deviations.push_back(deviation / of.value);
        return result;
    };
    const Estimate of_logarithms = estimate(logarithm(first), logarithm(second), dependence);
    Estimate ratio = unknown;
    ratio.difference = second.value / first.value;
    ratio.low = std::exp(of_logarithms.low);
    ratio.high = std::exp(of_logarithms.high);
    return ratio;
}

double mean_of(ConstMatrixView column) {
    double sum = 0;
    for (std::int64_t s = 0; s < column.rows; ++s)
        sum += column(s, 0);
    return sum / static_cast<double>(column.rows);
}

Quantity level_of(const Curves& curves) {
    Quantity level{mean_of(curves.mean), {}};
    for (const ConstMatrixView& cycle : curves.each)
        level.deviations.push_back(mean_of(cycle) - level.value);
    return level;
}

/// Root mean square, over the samples, of the length of each row, without the last sample, which
/// repeats the first.
double rms_of(const Matrix& values, const Columns& columns) {
    double squares = 0;
    for (std::int64_t s = 0; s + 1 < values.rows(); ++s)
        for (const std::int64_t c : columns)
            squares += values(s, c) * values(s, c);
    return std::sqrt(squares / static_cast<double>(values.rows() - 1));
}

/// One value of the mean cycle, and how each cycle deviates from it.
Quantity sample_of(const Resampled& cycles, std::int64_t index) {
    Quantity sample{cycles.mean.data()[index], {}};
    for (const Matrix& cycle : cycles.each)
        sample.deviations.push_back(cycle.data()[index] - sample.value);
    return sample;
}

void set_pointwise(const Resampled& first, const Resampled& second, bool paired,
                   Differences& result) {
    const std::int64_t rows = first.mean.rows(), cols = first.mean.cols();
    const auto for_each = [&](auto use) {
        for (std::int64_t i = 0; i < rows * cols; ++i) {
            use(i, sample_of(first, i), sample_of(second, i));
            checkpoint(4 * (std::ssize(first.each) + std::ssize(second.each)));
        }
    };
    Dependences all(paired);
    for_each(
        [&](std::int64_t, const Quantity& one, const Quantity& other) { all.add(one, other); });
    const Dependence dependence = all.value();
    for (Matrix* matrix : {&result.difference, &result.error, &result.margin})
        *matrix = Matrix::unset(rows, cols);
    for_each([&](std::int64_t i, const Quantity& one, const Quantity& other) {
        const Estimate found = estimate(one, other, dependence);
        result.difference.data()[i] = found.difference;
        result.error.data()[i] = found.error;
        result.margin.data()[i] = found.high - found.difference;
    });
}

/// What is measured of some columns.
struct Measured {
    Timing timing;
    Quantity amplitude, other_amplitude;
    Quantity level, other_level; ///< means over the cycle; only of a single column
};

/// `whole`: the timing of all columns, which is subtracted; null: nothing is.
Measured measured(const Resampled& first, const Resampled& second, const Columns& columns,
                  const Timing* whole) {
    const Curves one = curves_of(first, columns), other = curves_of(second, columns);
    Measured made;
    made.timing = timing_of(one, other, one.mean.rows / 4, least_correlation);
    if (whole != nullptr && !std::isnan(made.timing.lag.samples)) {
        subtract(whole->first, made.timing.first);
        subtract(whole->second, made.timing.second);
    }
    made.amplitude = amplitude_of(one);
    made.other_amplitude = amplitude_of(other);
    if (columns.size() == 1) {
        made.level = level_of(one);
        made.other_level = level_of(other);
    }
    return made;
}

/// The dependence of one kind of quantity, from all parts.
template <class First, class Second>
Dependence dependence_in(const std::vector<Measured>& all, bool paired, First first,
                         Second second) {
    Dependences of(paired);
    for (const Measured& each : all)
        of.add(first(each), second(each));
    return of.value();
}

std::vector<PartDifference> differences_of(const std::vector<Measured>& all,
                                           const std::vector<Columns>& columns,
                                           const Differences& pointwise, bool paired) {
    const auto first_timing = [](const Measured& of) -> auto& {
        return of.timing.first;
    };
    const auto second_timing = [](const Measured& of) -> auto& {
        return of.timing.second;
    };
    const Dependence timing = dependence_in(all, paired, first_timing, second_timing);
    const Dependence size = dependence_in(
        all, paired, [](const Measured& of) -> auto& { return of.amplitude; },
        [](const Measured& of) -> auto& { return of.other_amplitude; });
    const Dependence level = dependence_in(
        all, paired, [](const Measured& of) -> auto& { return of.level; },
        [](const Measured& of) -> auto& { return of.other_level; });
    std::vector<PartDifference> parts;
    for (std::size_t p = 0; p < all.size(); ++p) {
        const Measured& of = all[p];
        PartDifference& part = parts.emplace_back();
        part.rms = rms_of(pointwise.difference, columns[p]);
        part.chance = rms_of(pointwise.error, columns[p]);
        part.correlation = of.timing.lag.correlation;
        part.lag = std::isnan(of.timing.lag.samples)
                       ? unknown
                       : estimate(of.timing.first, of.timing.second, timing);
        part.amplitude = estimate(of.amplitude, of.other_amplitude, size);
        part.ratio = ratio_of(of.amplitude, of.other_amplitude, size);
        part.mean =
            of.level.deviations.empty() ? unknown : estimate(of.level, of.other_level, level);
        checkpoint(8 * pointwise.difference.rows() * std::ssize(columns[p]));
    }
    return parts;
}

} // namespace

Matrix chosen(ConstMatrixView from, const std::vector<std::int64_t>& columns) {
    Matrix result = Matrix::unset(from.rows, std::ssize(columns));
    for (std::int64_t s = 0; s < from.rows; ++s) {
        for (std::size_t c = 0; c < columns.size(); ++c)
            result(s, static_cast<std::int64_t>(c)) = from(s, columns[c]);
        checkpoint(2 * std::ssize(columns));
    }
    return result;
}

ConstMatrixView once_around(const Matrix& samples) {
    return samples.view().block(0, samples.rows() - 1);
}

Differences compare(const Resampled& first, const Resampled& second,
                    std::span<const std::int64_t> groups, bool paired) {
    Differences result;
    set_pointwise(first, second, paired, result);
    Columns all;
    std::vector<Columns> parts(static_cast<std::size_t>(std::ranges::max(groups) + 1)), single;
    for (std::size_t c = 0; c < groups.size(); ++c) {
        all.push_back(static_cast<std::int64_t>(c));
        single.push_back({all.back()});
        parts[static_cast<std::size_t>(groups[c])].push_back(all.back());
    }
    const Curves body = curves_of(first, all), other = curves_of(second, all);
    const Timing whole = timing_of(body, other, body.mean.rows / 2, -1);
    result.likeness = whole.lag.correlation;
    result.runner_up = whole.lag.runner_up;
    const bool aligned = !paired && !std::isnan(whole.lag.samples);
    result.whole = unknown;
    if (aligned)
        result.whole =
            estimate(whole.first, whole.second, dependence_of(whole.first, whole.second, false));
    result.shift = aligned ? whole.second.value : 0;
    const auto of = [&](const std::vector<Columns>& chosen) {
        std::vector<Measured> made;
        for (const Columns& columns : chosen)
            made.push_back(measured(first, second, columns, aligned ? &whole : nullptr));
        return differences_of(made, chosen, result, paired);
    };
    result.parts = of(parts);
    // Columns of plain numbers are parts of their own.
    result.columns = parts == single ? result.parts : of(single);
    return result;
}

} // namespace stltsa::phase
