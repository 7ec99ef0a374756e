// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/gaps.hpp"

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "linalg/band.hpp"
#include "linalg/eigen.hpp"

namespace stltsa::clip {
namespace {

/// Frames a second, if the clip does not give them.
constexpr double usual_rate = 100;
/// Rows from which the covariance is estimated are at most so many, evenly chosen.
constexpr std::int64_t most_rows = 5000;
/// Repetitions of the estimate: a fifth changes no border of the marker clips.
constexpr int rounds = 4;
/// Added to the variances, as a share of their mean, so that points that move together exactly
/// leave the matrix regular.
constexpr double ridge = 1e-4;

/// Fills the rows between `before` and `after`, of which one may lie beyond its end.
void fill_between(Matrix& rows, std::int64_t column, int width, std::int64_t before,
                  std::int64_t after) {
    const std::int64_t from = before < 0 ? after : before;
    const std::int64_t to = after < rows.rows() ? after : from;
    for (std::int64_t i = before + 1; i < after; ++i) {
        const double share =
            from == to ? 0 : static_cast<double>(i - from) / static_cast<double>(to - from);
        for (std::int64_t c = column; c < column + width; ++c)
            rows(i, c) = (1 - share) * rows(from, c) + share * rows(to, c);
    }
}

/// The gaps of each group, in order.
std::vector<std::vector<Gap>> find_gaps(const Matrix& rows, int width) {
    std::vector<std::vector<Gap>> gaps(static_cast<std::size_t>(rows.cols() / width));
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::size_t g = 0; g < gaps.size(); ++g) {
            const auto group = static_cast<std::int64_t>(g);
            if (!is_missing(rows.row(i) + width * group, width))
                continue;
            if (gaps[g].empty() || gaps[g].back().end < i)
                gaps[g].push_back({{i, i}, group});
            gaps[g].back().end = i + 1;
        }
    return gaps;
}

std::int64_t missing_frames(const std::vector<Gap>& gaps) {
    std::int64_t sum = 0;
    for (const Gap& gap : gaps)
        sum += gap.count();
    return sum;
}

/// Runs of frames in which more than half of the groups are missing, longer than `longest`.
std::vector<Frames> find_holes(const std::vector<std::vector<Gap>>& gaps,
                               const std::vector<std::int64_t>& seen, std::int64_t frames,
                               double longest) {
    std::vector<std::int64_t> missing(static_cast<std::size_t>(frames) + 1);
    for (const std::int64_t group : seen)
        for (const Gap& gap : gaps[static_cast<std::size_t>(group)]) {
            ++missing[static_cast<std::size_t>(gap.begin)];
            --missing[static_cast<std::size_t>(gap.end)];
        }
    std::vector<Frames> holes;
    std::int64_t count = 0;
    for (std::int64_t i = 0; i < frames; ++i) {
        count += missing[static_cast<std::size_t>(i)];
        if (2 * count <= std::ssize(seen))
            continue;
        if (holes.empty() || holes.back().end < i)
            holes.push_back({i, i});
        holes.back().end = i + 1;
    }
    std::erase_if(holes,
                  [&](const Frames& hole) { return static_cast<double>(hole.count()) <= longest; });
    return holes;
}

/// Mean and regularized covariance of rows.
struct Moments {
    std::vector<double> mean;
    /// Of the rows divided by a power of two near their largest deviation from the mean, so that
    /// squares of tiny numbers do not vanish; the predictions do not depend on it.
    Matrix covariance;

    explicit Moments(const Matrix& rows) : covariance(rows.cols(), rows.cols()) {
        const std::int64_t step = 1 + (rows.rows() - 1) / most_rows;
        const std::int64_t whole = (rows.rows() - 1) / step + 1;
        const auto count = static_cast<double>(whole);
        mean.resize(static_cast<std::size_t>(rows.cols()));
        for (std::int64_t i = 0; i < rows.rows(); i += step)
            for (std::size_t c = 0; c < mean.size(); ++c)
                mean[c] += rows(i, static_cast<std::int64_t>(c)) / count;
        double largest = 0;
        for (std::int64_t i = 0; i < rows.rows(); i += step)
            for (std::size_t c = 0; c < mean.size(); ++c)
                largest =
                    std::max(largest, std::abs(rows(i, static_cast<std::int64_t>(c)) - mean[c]));
        if (largest == 0)
            return; // nothing varies, so there is nothing to predict
        const int exponent = -std::ilogb(largest);
        std::vector<double> row(mean.size());
        for (std::int64_t i = 0; i < rows.rows(); i += step) {
            for (std::size_t c = 0; c < mean.size(); ++c)
                row[c] = std::scalbn(rows(i, static_cast<std::int64_t>(c)) - mean[c], exponent);
            for (std::size_t a = 0; a < mean.size(); ++a)
                for (std::size_t b = 0; b < mean.size(); ++b)
                    covariance(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b)) +=
                        row[a] * row[b] / count;
        }
    }

    /// The inverse of the covariance, with the ridge.
    Matrix precision() const {
        Matrix vectors = copied(covariance.view());
        std::vector<double> values;
        symmetric_eigen(vectors, values);
        double trace = 0;
        for (const double value : values)
            trace += value;
        const double added = ridge * trace / static_cast<double>(values.size());
        Matrix result(covariance.rows(), covariance.cols());
        for (std::int64_t k = 0; k < vectors.rows(); ++k) {
            const double weight = 1 / (std::max(0.0, values[static_cast<std::size_t>(k)]) + added);
            for (std::int64_t a = 0; a < result.rows(); ++a)
                for (std::int64_t b = 0; b < result.cols(); ++b)
                    result(a, b) += weight * vectors(k, a) * vectors(k, b);
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
        borders.push_back(gap.begin);
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
void predict(Matrix& rows, int width, const Pattern& pattern, const Moments& moments,
             const Matrix& precision) {
    std::vector<std::int64_t> columns;
    for (const std::int64_t group : pattern.groups)
        for (std::int64_t c = width * group; c < width * (group + 1); ++c)
            columns.push_back(c);
    const auto order = std::ssize(columns);
    BandMatrix system(order, order - 1);
    for (std::int64_t k = 0; k < order; ++k)
        for (std::int64_t i = k; i < order; ++i)
            system.column(k)[i - k] = precision(columns[static_cast<std::size_t>(i)],
                                                columns[static_cast<std::size_t>(k)]);
    if (!system.factor(0))
        return; // the values filled over time stay
    const auto deviation = [&](std::int64_t frame, std::int64_t column) {
        return rows(frame, column) - moments.mean[static_cast<std::size_t>(column)];
    };
    std::vector<bool> is_there(static_cast<std::size_t>(rows.cols()), true);
    for (const std::int64_t column : columns)
        is_there[static_cast<std::size_t>(column)] = false;
    Matrix right(pattern.frames.count(), order);
    for (std::int64_t i = 0; i < right.rows(); ++i)
        for (std::int64_t k = 0; k < order; ++k)
            for (std::int64_t c = 0; c < rows.cols(); ++c)
                if (is_there[static_cast<std::size_t>(c)])
                    right(i, k) -= precision(columns[static_cast<std::size_t>(k)], c) *
                                   deviation(pattern.frames.begin + i, c);
    system.solve(right.view(), Machine());
    for (std::int64_t i = 0; i < right.rows(); ++i)
        for (std::int64_t k = 0; k < order; ++k) {
            const std::int64_t column = columns[static_cast<std::size_t>(k)];
            rows(pattern.frames.begin + i, column) =
                moments.mean[static_cast<std::size_t>(column)] + right(i, k);
        }
}

} // namespace

Gaps fill_gaps(Matrix& rows, int width, GapRule rule, double fps) {
    Gaps gaps;
    const double longest = longest_filled_s * (fps > 0 ? fps : usual_rate);
    const std::vector<std::vector<Gap>> found = find_gaps(rows, width);
    for (std::int64_t g = 0; g < std::ssize(found); ++g) {
        const std::vector<Gap>& of_group = found[static_cast<std::size_t>(g)];
        const std::int64_t count = missing_frames(of_group);
        if (2 * count > rows.rows()) {
            gaps.dropped.push_back(g);
            for (std::int64_t i = 0; i < rows.rows(); ++i)
                std::fill_n(rows.row(i) + width * g, width, 0.0);
            continue;
        }
        gaps.seen.push_back(g);
        gaps.frames += count;
        if (count > 0)
            gaps.filled.push_back(g);
        for (const Gap& gap : of_group)
            fill_between(rows, width * g, width, gap.begin - 1, gap.end);
    }
    gaps.holes = find_holes(found, gaps.seen, rows.rows(), longest);
    for (const std::int64_t g : gaps.seen)
        for (const Gap& gap : found[static_cast<std::size_t>(g)])
            if (rule == GapRule::skip || static_cast<double>(gap.count()) > longest ||
                gap.begin == 0 || gap.end == rows.rows())
                gaps.predicted.push_back(gap);
    return gaps;
}

void predict_gaps(Matrix& rows, int width, const Gaps& gaps, const std::function<void()>& poll) {
    PacedPoll polls(poll);
    std::vector<Pattern> patterns = patterns_of(gaps.predicted);
    // Where most is missing, nothing implies the rest.
    std::erase_if(patterns, [&](const Pattern& pattern) {
        return 2 * std::ssize(pattern.groups) > std::ssize(gaps.seen);
    });
    for (int round = 0; round < rounds && !patterns.empty(); ++round) {
        const Moments moments(rows);
        const Matrix precision = moments.precision();
        for (const Pattern& pattern : patterns) {
            predict(rows, width, pattern, moments, precision);
            polls.did(pattern.frames.count() * width * std::ssize(pattern.groups) * rows.cols());
        }
    }
}

} // namespace stltsa::clip
