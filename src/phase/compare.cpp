// SPDX-License-Identifier: BSD-3-Clause
#include "phase/compare.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "phase/lag.hpp"

namespace stltsa::phase {
namespace {

constexpr Estimate unknown{none, none, none, none, none, none, none, none, false};

using Columns = std::vector<std::int64_t>;

Matrix chosen(const Matrix& from, const Columns& columns) {
    Matrix result = Matrix::unset(from.rows() - 1, static_cast<std::int64_t>(columns.size()));
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

/// The distance between the two points of the mean curve that are farthest apart; for a cycle, the
/// distance between the same two points in that direction.
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
    std::vector<Quantity> one, other;
    std::vector<const Quantity*> all, all_other;
    for (std::int64_t i = 0; i < rows * cols; ++i) {
        one.push_back(sample_of(first, i));
        other.push_back(sample_of(second, i));
    }
    for (std::size_t i = 0; i < one.size(); ++i) {
        all.push_back(&one[i]);
        all_other.push_back(&other[i]);
    }
    const Dependence dependence = dependence_of(all, all_other, paired);
    for (Matrix* matrix : {&result.difference, &result.error, &result.margin})
        *matrix = Matrix::unset(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Estimate found = estimate(one[at], other[at], dependence);
        result.difference.data()[i] = found.difference;
        result.error.data()[i] = found.error;
        result.margin.data()[i] = found.high - found.difference;
    }
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
    made.timing = timing_of(one, other, one.mean.rows() / 4, least_correlation);
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
    std::vector<const Quantity*> one, other;
    for (const Measured& each : all) {
        one.push_back(&first(each));
        other.push_back(&second(each));
    }
    return dependence_of(one, other, paired);
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
    }
    return parts;
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
    std::vector<Columns> parts(static_cast<std::size_t>(std::ranges::max(groups) + 1)), single;
    for (std::size_t c = 0; c < groups.size(); ++c) {
        all.push_back(static_cast<std::int64_t>(c));
        single.push_back({all.back()});
        parts[static_cast<std::size_t>(groups[c])].push_back(all.back());
    }
    const Curves body = curves_of(first, all), other = curves_of(second, all);
    const Timing whole = timing_of(body, other, body.mean.rows() / 2, -1);
    result.likeness = whole.lag.correlation;
    result.runner_up = whole.lag.runner_up;
    const bool aligned = !paired && !std::isnan(whole.lag.samples);
    result.whole = unknown;
    if (aligned)
        result.whole = estimate(whole.first, whole.second,
                                dependence_of({&whole.first}, {&whole.second}, false));
    result.shift = aligned ? whole.second.value : 0;
    const auto of = [&](const std::vector<Columns>& chosen) {
        std::vector<Measured> made;
        for (const Columns& columns : chosen)
            made.push_back(measured(first, second, columns, aligned ? &whole : nullptr));
        return differences_of(made, chosen, result, paired);
    };
    result.parts = of(parts);
    result.columns = of(single);
    return result;
}

} // namespace stltsa::phase
