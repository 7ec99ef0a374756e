// SPDX-License-Identifier: BSD-3-Clause
#include "phase/resample.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"

namespace stltsa::phase {
namespace {

/// Places between borders have such errors, in rows.
constexpr double rounding = 1e-6;

double share_of(std::int64_t sample, std::int64_t samples) {
    return static_cast<double>(sample) / static_cast<double>(samples - 1);
}

/// Two rows and the share of the way from the first to the second.
struct Between {
    std::int64_t row = 0, next = 0;
    double part = 0;
};

/// Nothing if the place is unknown, or if it is beyond the last row and no rows are repeated.
std::optional<Between> between(double place, std::int64_t rows, const Range& repeated) {
    if (std::isnan(place))
        return std::nullopt;
    if (const std::int64_t count = repeated.rows(); count > 0) {
        const double floor = std::floor(place);
        const std::int64_t at = static_cast<std::int64_t>(floor) - repeated.begin;
        return Between{repeated.begin + at % count, repeated.begin + (at + 1) % count,
                       place - floor};
    }
    const auto last = static_cast<double>(rows - 1);
    if (place > last + rounding)
        return std::nullopt;
    const double inside = std::clamp(place, 0.0, last);
    const auto row = static_cast<std::int64_t>(inside);
    return Between{row, std::min(row + 1, rows - 1), inside - static_cast<double>(row)};
}

Matrix linear_rows(ConstMatrixView signals, const double* places, std::int64_t count,
                   const Range& repeated) {
    Matrix result = Matrix::unset(count, signals.cols);
    for (std::int64_t s = 0; s < count; ++s) {
        checkpoint(2 * signals.cols);
        const std::optional<Between> place = between(places[s], signals.rows, repeated);
        if (!place) {
            std::fill_n(result.row(s), signals.cols, none);
            continue;
        }
        const auto [row, next, part] = *place;
        for (std::int64_t c = 0; c < signals.cols; ++c)
            result(s, c) = part > 0 ? signals(row, c) + part * (signals(next, c) - signals(row, c))
                                    : signals(row, c);
    }
    return result;
}

/// Mean and standard deviation over the cycles, of the values that are known.
void set_spread(Resampled& made) {
    const std::int64_t rows = made.each.front().rows(), cols = made.each.front().cols();
    made.mean = Matrix::unset(rows, cols);
    made.deviation = Matrix::unset(rows, cols);
    for (std::int64_t i = 0; i < rows * cols; ++i) {
        double count = 0, sum = 0, squares = 0;
        for (const Matrix& cycle : made.each)
            if (const double value = cycle.data()[i]; !std::isnan(value)) {
                sum += value;
                ++count;
            }
        const double mean = count > 0 ? sum / count : none;
        for (const Matrix& cycle : made.each)
            if (const double value = cycle.data()[i]; !std::isnan(value))
                squares += (value - mean) * (value - mean);
        made.mean.data()[i] = mean;
        made.deviation.data()[i] = count > 1 ? std::sqrt(squares / (count - 1)) : none;
        checkpoint(2 * std::ssize(made.each));
    }
}

/// Mean square of the known values of a column, the last sample left out, which is the first again.
template <class Value>
double mean_square(std::int64_t samples, const Value& value_at) {
    double count = 0, squares = 0;
    for (std::int64_t s = 0; s + 1 < samples; ++s)
        if (const double value = value_at(s); !std::isnan(value)) {
            squares += value * value;
            ++count;
        }
    return count > 0 ? squares / count : none;
}

/// Sum over the columns of the variance along the mean cycle.
double variance_of(const Matrix& mean) {
    double sum = 0;
    for (std::int64_t c = 0; c < mean.cols(); ++c) {
        double level = 0, count = 0;
        for (std::int64_t s = 0; s + 1 < mean.rows(); ++s)
            if (!std::isnan(mean(s, c))) {
                level += mean(s, c);
                ++count;
            }
        const double square =
            mean_square(mean.rows(), [&](std::int64_t s) { return mean(s, c) - level / count; });
        sum += std::isnan(square) ? 0 : square;
        checkpoint(4 * mean.rows());
    }
    return sum;
}

void set_distances(Resampled& made) {
    const double variance = variance_of(made.mean);
    made.distance = Matrix(static_cast<std::int64_t>(made.each.size()), made.mean.cols());
    for (std::size_t k = 0; k < made.each.size(); ++k) {
        double squares = 0;
        for (std::int64_t c = 0; c < made.mean.cols(); ++c) {
            const double square = mean_square(made.mean.rows(), [&](std::int64_t s) {
                return made.each[k](s, c) - made.mean(s, c);
            });
            made.distance(static_cast<std::int64_t>(k), c) = std::sqrt(square);
            squares += std::isnan(square) ? 0 : square;
            checkpoint(4 * made.mean.rows());
        }
        made.total.push_back(variance > 0 ? std::sqrt(squares / variance) : none);
    }
}

} // namespace

Matrix group_distance(const Resampled& of, std::span<const std::int64_t> groups) {
    const std::int64_t count = std::ranges::max(groups) + 1;
    Matrix result(of.distance.rows(), count);
    for (std::int64_t k = 0; k < result.rows(); ++k) {
        for (std::size_t c = 0; c < groups.size(); ++c)
            if (const double off = of.distance(k, static_cast<std::int64_t>(c));
                groups[c] >= 0 && !std::isnan(off))
                result(k, groups[c]) += off * off;
        for (std::int64_t g = 0; g < count; ++g)
            result(k, g) = std::sqrt(result(k, g));
    }
    return result;
}

Matrix times_of(const Run& run, const Borders& borders, std::int64_t samples, double shift) {
    Matrix rows(static_cast<std::int64_t>(borders.size()) - 1, samples);
    for (std::int64_t k = 0; k < rows.rows(); ++k) {
        const double begin = borders[static_cast<std::size_t>(k)];
        const double end = borders[static_cast<std::size_t>(k + 1)];
        const double from = run.phase_at(begin), turn = run.phase_at(end) - from;
        for (std::int64_t s = 0; s < samples; ++s) {
            double share = share_of(s, samples) + shift;
            share -= share > 1 || share < 0 ? std::floor(share) : 0;
            rows(k, s) = std::clamp(run.row_at(from + share * turn), begin, end);
        }
    }
    return rows;
}

Matrix times_between(const Borders& borders, std::int64_t samples) {
    Matrix rows(static_cast<std::int64_t>(borders.size()) - 1, samples);
    for (std::int64_t k = 0; k < rows.rows(); ++k)
        for (std::int64_t s = 0; s < samples; ++s) {
            const double begin = borders[static_cast<std::size_t>(k)];
            const double end = borders[static_cast<std::size_t>(k + 1)];
            rows(k, s) = begin + share_of(s, samples) * (end - begin);
        }
    return rows;
}

Resampled resample(ConstMatrixView signals, Turns turns) {
    const Matrix& rows = turns.rows;
    std::vector<Matrix> each;
    for (std::int64_t k = 0; k < rows.rows(); ++k) {
        const Range repeated =
            turns.repeated.empty() ? Range{} : turns.repeated[static_cast<std::size_t>(k)];
        each.push_back(linear_rows(signals, rows.row(k), rows.cols(), repeated));
    }
    return spread_of(std::move(turns.rows), std::move(each));
}

Resampled spread_of(Matrix rows, std::vector<Matrix> each) {
    Resampled made;
    made.each = std::move(each);
    made.warp = Matrix(rows.rows(), rows.cols());
    const std::int64_t last = rows.cols() - 1;
    for (std::int64_t k = 0; k < rows.rows(); ++k) {
        const double begin = rows(k, 0), length = rows(k, last) - begin;
        for (std::int64_t s = 0; s <= last; ++s)
            made.warp(k, s) = (rows(k, s) - begin) / length - share_of(s, last + 1);
    }
    set_spread(made);
    set_distances(made);
    made.rows = std::move(rows);
    return made;
}

} // namespace stltsa::phase
