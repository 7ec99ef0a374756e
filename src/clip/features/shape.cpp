// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <lapacke.h>

#include "linalg/principal.hpp"
#include "linalg/simd.hpp"

namespace stltsa::clip {
namespace {

/// Directions in which shapes vary: as many as streams are compared in.
constexpr std::int64_t most_directions = 16;
/// Rows from which they are learned are at most so many, evenly chosen.
constexpr std::int64_t most_rows = 5000;
/// Least variance across the directions, as a share of the mean variance: points that move together
/// exactly must not determine others by their rounding.
constexpr double least_rest = 1e-3;
/// Of a direction in which nothing varies, as a share of the variance across the directions.
constexpr double least_variance = 1e-3;
/// Repetitions of the mean shape; the features have one heading already.
constexpr int rounds = 3;
/// Below this share of the length that the mean shape itself has, a match gives no heading.
constexpr double least_match = 0.3;
/// Where points are missing, their place is found so many times, each with a better mean of all.
constexpr int fill_rounds = 3;

std::vector<std::int64_t> rows_of(std::span<const Frames> chosen) {
    std::int64_t count = 0;
    for (const Frames& frames : chosen)
        count += frames.count();
    const std::int64_t step = 1 + (count - 1) / most_rows;
    std::vector<std::int64_t> rows;
    std::int64_t at = 0;
    for (const Frames& frames : chosen)
        for (std::int64_t i = frames.begin; i < frames.end; ++i)
            if (at++ % step == 0)
                rows.push_back(i);
    return rows;
}

std::vector<double> used_groups(ConstMatrixView rows, int width,
                                std::span<const std::int64_t> drifting) {
    std::vector<double> used(static_cast<std::size_t>(rows.cols / width), 0);
    for (std::int64_t i = 0; i < rows.rows; ++i)
        for (std::int64_t c = 0; c < rows.cols; ++c)
            if (rows(i, c) != 0)
                used[static_cast<std::size_t>(c / width)] = 1;
    for (const std::int64_t column : drifting)
        used[static_cast<std::size_t>(column / width)] = 0;
    return used;
}

/// Moves and turns the rows to the mean shape. Returns how many: those of which too little is known
/// are left out, and the others are the first ones of `placed`.
std::int64_t place(const Shape& shape, const Matrix& rows, Matrix& placed) {
    ShapeFeatures features(shape);
    std::int64_t count = 0;
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        if (features.next(rows.row(i), placed.row(count)))
            ++count;
    if (count == 0)
        fail(Status::degenerate,
             "the mean cycle has nothing to be compared with: all columns only drift, or too many "
             "are missing in every frame of the cycles; use a clip without drift");
    return count;
}

/// How the rows, which are overwritten, vary about the mean shape.
void set_variation(MatrixView rows, Shape& shape) {
    double total = 0;
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        axpy(-1, shape.mean.data(), rows.row(i), rows.cols);
        total += stltsa::dot(rows.row(i), rows.row(i), rows.cols) / static_cast<double>(rows.rows);
    }
    auto [directions, variances] = principal_directions(rows, most_directions);
    const double within = std::accumulate(variances.begin(), variances.end(), 0.0);
    const auto columns = static_cast<double>(rows.cols);
    shape.directions = std::move(directions);
    shape.variances = std::move(variances);
    shape.rest = std::max((total - within) / columns, least_rest * total / columns);
}

} // namespace

Shape learn_shape(ConstMatrixView rows, std::span<const Frames> chosen, const ShapeRule& rule,
                  std::span<const std::int64_t> drifting) {
    Shape shape;
    shape.rule = rule;
    shape.used = used_groups(rows, rule.width, drifting);
    const std::vector<std::int64_t> numbers = rows_of(chosen);
    Matrix of_clip = Matrix::unset(std::ssize(numbers), rows.cols);
    for (std::int64_t i = 0; i < of_clip.rows(); ++i)
        std::copy_n(rows.row(numbers[static_cast<std::size_t>(i)]), rows.cols, of_clip.row(i));
    Matrix placed = Matrix::unset(of_clip.rows(), rows.cols);
    std::int64_t count = 0;
    shape.mean = column_means(of_clip.view());
    for (int round = 0; round < rounds; ++round) {
        count = place(shape, of_clip, placed);
        shape.mean = column_means(placed.view().block(0, count));
    }
    set_variation(placed.view().block(0, count), shape);
    return shape;
}

ShapeFeatures::ShapeFeatures(Shape shape)
    : shape_(std::move(shape)), groups_(std::ssize(shape_.used)),
      all_(shape_.used.begin(), shape_.used.end()), seen_(all_),
      matrix_(shape_.variances.size() * shape_.variances.size()), weights_(shape_.variances.size()),
      off_(shape_.mean.size()) {
    if (shape_.rule.width == 3) {
        first_ = static_cast<int>(shape_.rule.up) % 3;
        second_ = (static_cast<int>(shape_.rule.up) + 1) % 3;
    }
    if (!shape_.rule.turns)
        return;
    for (std::int64_t g = 0; g < groups_; ++g)
        if (all_[static_cast<std::size_t>(g)]) {
            const double* p = shape_.mean.data() + g * shape_.rule.width;
            least_match_ += least_match * (p[first_] * p[first_] + p[second_] * p[second_]);
        }
}

bool ShapeFeatures::next(const double* values, double* features) {
    if (!find_seen(values))
        return false;
    const int width = shape_.rule.width;
    for (std::int64_t g = 0; g < groups_; ++g)
        for (std::int64_t c = g * width; c < (g + 1) * width; ++c)
            features[c] = seen_[static_cast<std::size_t>(g)] ? values[c] : 0;
    move(features, seen_);
    turn(features, seen_);
    if (seen_ == all_)
        return true;
    prepare_fill();
    for (int round = 0; round < fill_rounds; ++round) {
        fill(features);
        move(features, all_);
        turn(features, all_);
    }
    return true;
}

/// Sets which groups are there.
bool ShapeFeatures::find_seen(const double* values) {
    std::int64_t used = 0, seen = 0;
    for (std::int64_t g = 0; g < groups_; ++g) {
        const auto at = static_cast<std::size_t>(g);
        const double* group = values + g * shape_.rule.width;
        const bool finite = std::all_of(group, group + shape_.rule.width,
                                        [](double v) { return std::isfinite(v); });
        const bool known = all_[at] != 0 && finite && !is_missing(group, shape_.rule.width);
        seen_[at] = static_cast<char>(known);
        used += all_[at];
        seen += seen_[at];
    }
    return 2 * seen >= used && seen > 0;
}

/// Gives these groups the mean that they have in the mean shape.
void ShapeFeatures::move(double* features, const std::vector<char>& of) {
    if (!shape_.rule.travels)
        return;
    const int width = shape_.rule.width;
    double off[3] = {}, count = 0;
    for (std::int64_t g = 0; g < groups_; ++g)
        if (of[static_cast<std::size_t>(g)]) {
            for (int axis = 0; axis < width; ++axis)
                off[axis] += features[g * width + axis] -
                             shape_.mean[static_cast<std::size_t>(g * width + axis)];
            ++count;
        }
    for (std::int64_t g = 0; g < groups_; ++g)
        if (of[static_cast<std::size_t>(g)])
            for (int axis = 0; axis < width; ++axis)
                features[g * width + axis] -= off[axis] / count;
}

/// Turns these groups about their mean closest to the mean shape (Procrustes).
void ShapeFeatures::turn(double* features, const std::vector<char>& of) {
    if (!shape_.rule.turns)
        return;
    const int width = shape_.rule.width;
    Flat middle, match;
    double count = 0;
    for (std::int64_t g = 0; g < groups_; ++g)
        if (of[static_cast<std::size_t>(g)]) {
            middle.a += features[g * width + first_];
            middle.b += features[g * width + second_];
            ++count;
        }
    middle = {middle.a / count, middle.b / count};
    for (std::int64_t g = 0; g < groups_; ++g)
        if (of[static_cast<std::size_t>(g)]) {
            const double* mean = shape_.mean.data() + g * width;
            const double a = features[g * width + first_] - middle.a;
            const double b = features[g * width + second_] - middle.b;
            match.a += a * (mean[first_] - middle.a) + b * (mean[second_] - middle.b);
            match.b += a * (mean[second_] - middle.b) - b * (mean[first_] - middle.a);
        }
    if (const double length = std::hypot(match.a, match.b); length > least_match_)
        turn_ = {match.a / length, match.b / length};
    for (std::int64_t g = 0; g < groups_; ++g)
        if (of[static_cast<std::size_t>(g)]) {
            double& a = features[g * width + first_];
            double& b = features[g * width + second_];
            const Flat from{a - middle.a, b - middle.b};
            a = middle.a + turn_.a * from.a - turn_.b * from.b;
            b = middle.b + turn_.b * from.a + turn_.a * from.b;
        }
}

/// Calls body(column) for the columns of groups that are missing.
template <class Body>
void ShapeFeatures::for_missing(const Body& body) const {
    const std::int64_t width = shape_.rule.width;
    for (std::int64_t g = 0; g < groups_; ++g)
        if (all_[static_cast<std::size_t>(g)] && !seen_[static_cast<std::size_t>(g)])
            for (std::int64_t c = g * width; c < (g + 1) * width; ++c)
                body(c);
}

/// Factors v L^-1 + U'U of fill(). Directions are orthonormal, so U'U over what is seen is the
/// identity less that over what is missing.
void ShapeFeatures::prepare_fill() {
    const auto count = static_cast<std::int64_t>(weights_.size());
    std::ranges::fill(matrix_, 0.0);
    for (std::int64_t d = 0; d < count; ++d) {
        const double variance = shape_.variances[static_cast<std::size_t>(d)];
        matrix_[static_cast<std::size_t>(d * count + d)] =
            1 + shape_.rest / std::max(variance, least_variance * shape_.rest);
    }
    for_missing([&](std::int64_t c) {
        for (std::int64_t d = 0; d < count; ++d)
            for (std::int64_t e = 0; e <= d; ++e)
                matrix_[static_cast<std::size_t>(d * count + e)] -=
                    shape_.directions(d, c) * shape_.directions(e, c);
    });
    // Its eigenvalues are positive, so the factor exists. By rows this is the lower triangle, by
    // columns the upper one; by columns LAPACKE allocates nothing.
    const auto order = static_cast<lapack_int>(count);
    LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'U', order, matrix_.data(), order);
}

/// Sets the groups that are missing: with the variances L along directions U and v across them, the
/// mean of what is missing, given that x - m is seen, is m + U z, (v L^-1 + U'U) z = U' (x - m),
/// the products over what is seen (Tipping and Bishop, "Probabilistic principal component
/// analysis", 1999).
void ShapeFeatures::fill(double* features) {
    const auto count = static_cast<std::int64_t>(weights_.size());
    for_missing([&](std::int64_t c) { features[c] = shape_.mean[static_cast<std::size_t>(c)]; });
    for (std::size_t c = 0; c < shape_.mean.size(); ++c)
        off_[c] = features[c] - shape_.mean[c];
    for (std::int64_t d = 0; d < count; ++d)
        weights_[static_cast<std::size_t>(d)] =
            stltsa::dot(off_.data(), shape_.directions.row(d), std::ssize(off_));
    const auto order = static_cast<lapack_int>(count);
    LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'U', order, 1, matrix_.data(), order, weights_.data(),
                        order);
    for_missing([&](std::int64_t c) {
        for (std::int64_t d = 0; d < count; ++d)
            features[c] += weights_[static_cast<std::size_t>(d)] * shape_.directions(d, c);
    });
}

} // namespace stltsa::clip
