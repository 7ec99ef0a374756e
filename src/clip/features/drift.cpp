// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/drift.hpp"

#include <algorithm>

#include "linalg/gaussian.hpp"

namespace stltsa::clip {
namespace {

/// Sigma of the slow part; sways and strides are faster.
constexpr double slow_s = 1.5;
/// A column drifts if its slow part goes one way for this long at a time, in all for this share of
/// the time, and is most of its variance.
constexpr double one_way_s = 8;
constexpr double one_way_share = 0.9;
constexpr double slow_share = 0.5;
/// A column that only drifts leaves rounding errors, in which cycles were found: 7 of them in 300
/// rows of a straight line, whose rounding errors are 3e-32 of its variance.
constexpr double rounding_share = 1e-24;

double variance(ConstMatrixView rows, std::int64_t column) {
    const auto n = static_cast<double>(rows.rows);
    double mean = 0, squares = 0;
    for (std::int64_t i = 0; i < rows.rows; ++i)
        mean += rows(i, column) / n;
    for (std::int64_t i = 0; i < rows.rows; ++i)
        squares += (rows(i, column) - mean) * (rows(i, column) - mean) / n;
    return squares;
}

/// Steps from knot to knot in runs of one sign that have at least `least` of them.
std::int64_t one_way_steps(const Matrix& knots, std::int64_t column, double least) {
    std::int64_t covered = 0, run = 0;
    double sign = 0;
    const auto close = [&] {
        if (static_cast<double>(run) >= least)
            covered += run;
        run = 0;
    };
    for (std::int64_t k = 1; k < knots.rows(); ++k) {
        const double step = knots(k, column) - knots(k - 1, column);
        if (step * sign <= 0)
            close();
        sign = step;
        run += step != 0 ? 1 : 0;
    }
    close();
    return covered;
}

void subtract(const Matrix& knots, std::int64_t step, std::int64_t column, Matrix& samples) {
    for (std::int64_t i = 0; i < samples.rows(); ++i) {
        const std::int64_t k = std::min(i / step, knots.rows() - 2);
        const double part = static_cast<double>(i - k * step) / static_cast<double>(step);
        samples(i, column) -= (1 - part) * knots(k, column) + part * knots(k + 1, column);
    }
}

} // namespace

std::vector<std::int64_t> remove_drift(Matrix& samples, double fps) {
    const double sigma = slow_s * fps;
    if (static_cast<double>(samples.rows()) < one_way_s * fps)
        return {};
    const auto step = std::max<std::int64_t>(1, static_cast<std::int64_t>(sigma / 8));
    const Matrix knots = gaussian_smoothed(samples.view(), sigma, Beyond::reflection, step);
    const double least = one_way_s * fps / static_cast<double>(step) - 1;
    std::vector<std::int64_t> drifting;
    for (std::int64_t c = 0; c < samples.cols() && knots.rows() > 1; ++c) {
        const double all = variance(samples.view(), c);
        if (!(all > 0) || variance(knots.view(), c) < slow_share * all)
            continue;
        if (static_cast<double>(one_way_steps(knots, c, least)) <
            one_way_share * static_cast<double>(knots.rows() - 1))
            continue;
        subtract(knots, step, c, samples);
        if (variance(samples.view(), c) < rounding_share * all)
            for (std::int64_t i = 0; i < samples.rows(); ++i)
                samples(i, c) = 0;
        drifting.push_back(c);
    }
    return drifting;
}

} // namespace stltsa::clip
