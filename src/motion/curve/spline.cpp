// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/spline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/curve/spline_system.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Range of lambda, in powers of 10 times the data weight of a coefficient. At the lower end the
/// penalty has no effect; at the upper end details are at least 600 knots long.
constexpr double least_power = -6;
constexpr double most_power = 8;
constexpr double power_step = 0.5;
constexpr double power_precision = 0.02;
/// Residuals of values of size 1 below this are rounding.
constexpr double rounding = 1e-14;

/// Residuals have full weight up to 3 standard deviations and none beyond 6, with Tukey's bisquare
/// in between: as robust against spikes as the bisquare alone, without its loss of efficiency (5 %
/// and more) if there are none.
constexpr double full_weight = 3;
constexpr double no_weight = 6;
constexpr int reweightings = 4;
/// The standard deviation is local, over one to two blocks of this many knots to each side:
/// standing has less noise than walking, which must not look like spikes beside it.
constexpr double block_knots = 20;

using Values = std::vector<double>;

/// Subtracts the least squares line, and returns it. A second pass corrects the first's rounding.
Values subtract_line(Values& values) {
    const double middle = static_cast<double>(values.size() - 1) / 2;
    const auto place = [&](std::size_t i) { return static_cast<double>(i) / middle - 1; };
    Values line(values.size(), values.front());
    for (double& value : values)
        value -= line.front();
    for (int pass = 0; pass < 2; ++pass) {
        double sum = 0;
        double product = 0;
        double square = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            sum += values[i];
            product += place(i) * values[i];
            square += place(i) * place(i);
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double height =
                sum / static_cast<double>(values.size()) + product / square * place(i);
            values[i] -= height;
            line[i] += height;
        }
    }
    return line;
}

double largest_size(std::span<const double> values) {
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

struct Candidate {
    double power = 0;
    double score = INFINITY;
    SplineSystem::Fit fit;
};

/// Generalized cross-validation of weighted values; a weight of 0 removes the value.
class CrossValidation {
  public:
    CrossValidation(SplineSystem& system, const Values& values, const Values& weights)
        : system_(system), values_(values), weights_(weights) {
        system.set_data(values, weights);
        for (const double weight : weights)
            count_ += weight;
    }

    Candidate candidate(double power) const {
        Candidate c{power, INFINITY, system_.fit(lambda(power))};
        double squares = 0;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const double residual = values_[i] - c.fit.curve[i];
            squares += weights_[i] * residual * residual;
        }
        const double residual_share = 1 - c.fit.degrees_of_freedom / count_;
        if (residual_share > 0)
            c.score = squares / count_ / (residual_share * residual_share);
        return c;
    }

    double lambda(double power) const { return system_.knot_step() * std::pow(10.0, power); }

  private:
    const SplineSystem& system_;
    const Values& values_;
    const Values& weights_;
    double count_ = 0;
};

/// The best of a grid of powers, refined by golden section search.
Candidate best_candidate(const CrossValidation& validation) {
    Candidate best = validation.candidate(most_power);
    for (double power = most_power - power_step; power >= least_power; power -= power_step)
        if (Candidate c = validation.candidate(power); c.score < best.score)
            best = std::move(c);
    constexpr double golden = 0.6180339887498949;
    double low = std::max(least_power, best.power - power_step);
    double high = std::min(most_power, best.power + power_step);
    Candidate left = validation.candidate(high - golden * (high - low));
    Candidate right = validation.candidate(low + golden * (high - low));
    while (high - low > power_precision) {
        if (left.score < right.score) {
            high = right.power;
            right = std::move(left);
            left = validation.candidate(high - golden * (high - low));
        } else {
            low = left.power;
            left = std::move(right);
            right = validation.candidate(low + golden * (high - low));
        }
    }
    Candidate& inner = left.score < right.score ? left : right;
    return std::move(inner.score < best.score ? inner : best);
}

/// Robust standard deviation (1.4826 MAD) near each row, at least that of all rows.
Values scales_of(const Values& residuals, double knot_step) {
    const auto length = static_cast<std::size_t>(std::ceil(block_knots * knot_step));
    const std::size_t blocks = std::max<std::size_t>(1, residuals.size() / length);
    const double overall = robust_deviation(residuals);
    const auto begin = [&](std::size_t block) {
        return block >= blocks ? residuals.size() : block * length;
    };
    Values of_block(blocks + 2, overall); // with a neighbor on each side
    for (std::size_t b = 0; b < blocks; ++b)
        of_block[b + 1] =
            robust_deviation(std::span(residuals).subspan(begin(b), begin(b + 1) - begin(b)));
    Values scales(residuals.size());
    for (std::size_t b = 0; b < blocks; ++b)
        std::fill(scales.begin() + static_cast<std::ptrdiff_t>(begin(b)),
                  scales.begin() + static_cast<std::ptrdiff_t>(begin(b + 1)),
                  std::max({overall, of_block[b], of_block[b + 1], of_block[b + 2]}));
    return scales;
}

double weight_of(double deviations) {
    const double excess = std::max(0.0, (deviations - full_weight) / (no_weight - full_weight));
    return excess < 1 ? (1 - excess * excess) * (1 - excess * excess) : 0;
}

/// Sets the weights from the residuals; false if the residuals are only rounding.
bool reweigh(const Values& values, const Values& curve, double knot_step, Values& weights) {
    Values residuals(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        residuals[i] = values[i] - curve[i];
    const Values scales = scales_of(residuals, knot_step);
    if (!(*std::min_element(scales.begin(), scales.end()) > rounding))
        return false;
    for (std::size_t i = 0; i < values.size(); ++i)
        weights[i] = weight_of(std::abs(residuals[i]) / scales[i]);
    return true;
}

Spline fit_about_line(const Values& values, const SplineOptions& options) {
    SplineSystem system(static_cast<std::int64_t>(values.size()), options.knot_step);
    Values weights(values.size(), 1.0);
    Candidate best = best_candidate(CrossValidation(system, values, weights));
    for (int i = 0; options.robust && i < reweightings; ++i) {
        if (!reweigh(values, best.fit.curve, system.knot_step(), weights))
            break;
        best = best_candidate(CrossValidation(system, values, weights));
    }
    return {std::move(best.fit.curve), system.knot_step() * std::pow(10.0, best.power),
            best.fit.degrees_of_freedom};
}

} // namespace

int binary_exponent(std::span<const double> values) {
    const double largest = largest_size(values);
    return largest > 0 ? std::ilogb(largest) + 1 : 0;
}

Spline fit_spline(std::span<const double> values, const SplineOptions& options) {
    const int exponent = binary_exponent(values);
    Values scaled(values.begin(), values.end());
    for (double& value : scaled)
        value = std::ldexp(value, -exponent);
    const Values line = subtract_line(scaled);
    Spline result{Values(values.size()), INFINITY, 2};
    if (largest_size(scaled) > rounding)
        result = fit_about_line(scaled, options);
    constexpr double most = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < values.size(); ++i)
        result.curve[i] = std::clamp(std::ldexp(line[i] + result.curve[i], exponent), -most, most);
    return result;
}

} // namespace stltsa::motion
