// SPDX-License-Identifier: BSD-3-Clause
// The values of gaps, predicted from the groups that are there.
#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "clip/features/gaps.hpp"
#include "clip/features/near_groups.hpp"
#include "linalg/band.hpp"
#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

namespace stltsa::clip {
namespace {

/// Rows from which the covariance is estimated are at most so many, evenly chosen.
constexpr std::int64_t most_estimated = 5000;
/// Repetitions of the estimate: a fifth changes no border of the marker clips.
constexpr int prediction_rounds = 4;
/// Added to the variances, as a share of their mean, so that points that move together exactly
/// leave the matrix regular.
constexpr double ridge = 1e-4;
/// A prediction is from at most so many groups. Bodies have fewer markers.
constexpr std::int64_t most_near = 100;
/// Frames that are predicted at once.
constexpr std::int64_t most_at_once = 1000;

/// Some columns of the rows.
struct Columns {
    Matrix& rows;
    std::vector<std::int64_t> chosen;

    std::int64_t count() const { return std::ssize(chosen); }
    double& at(std::int64_t row, std::int64_t c) const {
        return rows(row, chosen[static_cast<std::size_t>(c)]);
    }
};

/// Mean and regularized covariance of the columns.
struct Moments {
    std::vector<double> mean;
    /// Of the rows divided by a power of two near their largest deviation from the mean, so that
    /// squares of tiny numbers do not vanish; the predictions do not depend on it.
    Matrix covariance;

    explicit Moments(const Columns& columns) : covariance(columns.count(), columns.count()) {
        const std::int64_t rows = columns.rows.rows();
        const std::int64_t cols = columns.count();
        const std::int64_t step = 1 + (rows - 1) / most_estimated;
        const std::int64_t taken = (rows - 1) / step + 1;
        const auto count = static_cast<double>(taken);
        mean.resize(static_cast<std::size_t>(cols));
        for (std::int64_t i = 0; i < rows; i += step)
            for (std::int64_t c = 0; c < cols; ++c)
                mean[static_cast<std::size_t>(c)] += columns.at(i, c) / count;
        double largest = 0;
        for (std::int64_t i = 0; i < rows; i += step)
            for (std::int64_t c = 0; c < cols; ++c)
                largest = std::max(largest, std::abs(deviation(columns, i, c)));
        if (largest == 0)
            return; // nothing varies, so there is nothing to predict
        const int exponent = -std::ilogb(largest);
        std::vector<double> row(mean.size());
        for (std::int64_t i = 0; i < rows; i += step) {
            for (std::int64_t c = 0; c < cols; ++c)
                row[static_cast<std::size_t>(c)] = std::scalbn(deviation(columns, i, c), exponent);
            for (std::int64_t a = 0; a < cols; ++a)
                axpy(row[static_cast<std::size_t>(a)] / count, row.data(), covariance.row(a), cols);
            checkpoint(cols * cols);
        }
    }

    double deviation(const Columns& columns, std::int64_t row, std::int64_t c) const {
        return columns.at(row, c) - mean[static_cast<std::size_t>(c)];
    }

    /// The inverse of the covariance, with the ridge. Of points, the place of the whole body is
    /// taken as unknown: it was found from values that include those of gaps, so it would imply
    /// these.
    Matrix precision(int width) const {
        const std::int64_t order = covariance.rows();
        double trace = 0;
        for (std::int64_t c = 0; c < order; ++c)
            trace += covariance(c, c);
        const double added = ridge * trace / static_cast<double>(order);
        Matrix vectors = copied(covariance.view());
        for (std::int64_t a = 0; a < order && width > 1; ++a)
            for (std::int64_t b = a % width; b < order; b += width)
                vectors(a, b) += trace;
        std::vector<double> values;
        symmetric_eigen(vectors, values);
        Matrix result(order, order);
        for (std::int64_t k = 0; k < order; ++k) {
            const double weight = 1 / (std::max(0.0, values[static_cast<std::size_t>(k)]) + added);
            for (std::int64_t a = 0; a < order; ++a)
                axpy(weight * vectors(k, a), vectors.row(k), result.row(a), order);
            checkpoint(order * order);
        }
        return result;
    }
};

/// Frames in which the same groups are to be predicted.
struct Pattern {
    Frames frames;
    std::vector<std::int64_t> groups;
};

std::vector<Pattern> patterns_of(const std::vector<Gap>& gaps) {
    std::vector<std::int64_t> borders;
    for (const Gap& gap : gaps) {
        for (std::int64_t frame = gap.begin; frame < gap.end; frame += most_at_once)
            borders.push_back(frame);
        borders.push_back(gap.end);
    }
    std::ranges::sort(borders);
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    std::vector<Pattern> patterns;
    for (std::size_t b = 0; b + 1 < borders.size(); ++b)
        patterns.push_back({{borders[b], borders[b + 1]}, {}});
    for (const Gap& gap : gaps) {
        const auto first = std::ranges::lower_bound(borders, gap.begin) - borders.begin();
        for (auto p = static_cast<std::size_t>(first);
             p < patterns.size() && patterns[p].frames.end <= gap.end; ++p)
            patterns[p].groups.push_back(gap.group);
    }
    std::erase_if(patterns, [](const Pattern& pattern) { return pattern.groups.empty(); });
    return patterns;
}

/// Sets the missing columns to mean - (P_mm)^-1 P_mo (x_o - mean), P the precision.
void predict(const Columns& columns, int width, const Pattern& pattern, const Moments& moments,
             const Matrix& precision) {
    std::vector<std::int64_t> missing;
    for (const std::int64_t group : pattern.groups)
        for (std::int64_t c = width * group; c < width * (group + 1); ++c)
            missing.push_back(c);
    const auto order = std::ssize(missing);
    BandMatrix system(order, order - 1);
    for (std::int64_t k = 0; k < order; ++k)
        for (std::int64_t i = k; i < order; ++i)
            system.column(k)[i - k] = precision(missing[static_cast<std::size_t>(i)],
                                                missing[static_cast<std::size_t>(k)]);
    if (!system.factor(0))
        return; // the values filled over time stay
    checkpoint(order * order * order / 3);
    Matrix right = Matrix::unset(pattern.frames.count(), order);
    std::vector<double> known(moments.mean.size());
    for (std::int64_t i = 0; i < right.rows(); ++i) {
        for (std::int64_t c = 0; c < columns.count(); ++c)
            known[static_cast<std::size_t>(c)] =
                moments.deviation(columns, pattern.frames.begin + i, c);
        for (const std::int64_t c : missing)
            known[static_cast<std::size_t>(c)] = 0;
        for (std::int64_t k = 0; k < order; ++k)
            right(i, k) = -stltsa::dot(precision.row(missing[static_cast<std::size_t>(k)]),
                                       known.data(), columns.count());
        checkpoint(order * (columns.count() + order));
    }
    system.solve(right.view(), Machine());
    for (std::int64_t i = 0; i < right.rows(); ++i)
        for (std::int64_t k = 0; k < order; ++k) {
            const std::int64_t c = missing[static_cast<std::size_t>(k)];
            columns.at(pattern.frames.begin + i, c) =
                moments.mean[static_cast<std::size_t>(c)] + right(i, k);
        }
}

/// Predicts the gaps of groups near each other. The groups of `gaps` are places in `near`.
void predict_set(Matrix& rows, int width, const std::vector<std::int64_t>& near,
                 const std::vector<Gap>& gaps) {
    std::vector<Pattern> patterns = patterns_of(gaps);
    // Where most is missing, nothing implies the rest.
    std::erase_if(patterns, [&](const Pattern& pattern) {
        return 2 * std::ssize(pattern.groups) > std::ssize(near);
    });
    if (patterns.empty())
        return;
    Columns columns{rows, {}};
    for (const std::int64_t group : near)
        for (int c = 0; c < width; ++c)
            columns.chosen.push_back(width * group + c);
    for (int round = 0; round < prediction_rounds; ++round) {
        const Moments moments(columns);
        const Matrix precision = moments.precision(width);
        for (const Pattern& pattern : patterns)
            predict(columns, width, pattern, moments, precision);
    }
}

} // namespace

void predict_gaps(Matrix& rows, int width, const Gaps& gaps) {
    if (gaps.predicted.empty())
        return;
    for (const std::vector<std::int64_t>& near : near_groups(rows, width, gaps.seen, most_near)) {
        std::vector<Gap> own;
        for (std::size_t k = 0; k < near.size(); ++k)
            for (auto gap = std::ranges::lower_bound(gaps.predicted, near[k], {}, &Gap::group);
                 gap != gaps.predicted.end() && gap->group == near[k]; ++gap)
                own.push_back({{gap->begin, gap->end}, static_cast<std::int64_t>(k)});
        checkpoint(std::ssize(near) + std::ssize(own));
        predict_set(rows, width, near, own);
    }
}

} // namespace stltsa::clip
