// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/search/reduced_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linalg/eigen.hpp"
#include "linalg/simd.hpp"

namespace stltsa::ltsa {
namespace {

/// With the remainder a cache line. 15 take 1.1 to 1.3 times as long, on 100 000 rows of 56
/// features without and with noise in all of them.
constexpr std::int64_t directions = lanes - 1;
constexpr std::int64_t remainder_at = directions;

/// Rows whose principal directions are used; the bounds hold for any directions.
constexpr std::int64_t sample_size = 200;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Matrix sample_of(ConstMatrixView x, std::span<const std::int32_t> rows, const double* mean) {
    const auto count = static_cast<std::int64_t>(rows.size());
    Matrix sample(std::min(count, sample_size), x.cols);
    for (std::int64_t i = 0; i < sample.rows(); ++i) {
        const double* row = x.row(rows[static_cast<std::size_t>(i * count / sample.rows())]);
        for (std::int64_t c = 0; c < x.cols; ++c)
            sample(i, c) = row[c] - mean[c];
    }
    return sample;
}

/// Subtracts the parts along the rows before this one and scales it to length 1, twice, so that it
/// is orthogonal to rounding. False: nothing is left.
bool orthonormalize(Matrix& basis, std::int64_t row) {
    double* direction = basis.row(row);
    for (int pass = 0; pass < 2; ++pass) {
        for (std::int64_t l = 0; l < row; ++l)
            axpy(-dot(basis.row(l), direction, basis.cols()), basis.row(l), direction,
                 basis.cols());
        const double length = std::sqrt(dot(direction, direction, basis.cols()));
        if (!(length > 0) || !std::isfinite(length))
            return false;
        for (std::int64_t c = 0; c < basis.cols(); ++c)
            direction[c] /= length;
    }
    return true;
}

/// The directions in which the rows of a sample vary most; zeros if there are fewer. By products of
/// rows instead of columns, of which there may be a million.
Matrix sample_directions(const Matrix& sample) {
    const std::int64_t count = sample.rows();
    const std::int64_t most = std::min({directions, sample.cols(), count});
    Matrix basis(directions, sample.cols());
    TopEigenpairs eigen(count, most);
    double trace = 0;
    for (std::int64_t a = 0; a < count; ++a) {
        for (std::int64_t b = a; b < count; ++b)
            eigen.matrix()[a * count + b] = dot(sample.row(a), sample.row(b), sample.cols());
        trace += eigen.matrix()[a * count + a];
    }
    if (!(trace > 0) || !std::isfinite(trace))
        return basis;
    eigen.solve();
    std::int64_t kept = 0;
    for (std::int64_t l = 0; l < most && eigen.value(l) > 1e-12 * eigen.value(0); ++l) {
        std::fill_n(basis.row(kept), basis.cols(), 0.0);
        for (std::int64_t a = 0; a < count; ++a)
            axpy(eigen.vector(l)[a], sample.row(a), basis.row(kept), basis.cols());
        kept += orthonormalize(basis, kept) ? 1 : 0;
    }
    std::fill(basis.row(kept), basis.row(directions), 0.0);
    return basis;
}

double along_directions(const double* a, const double* b) {
    double sum = 0;
    for (std::int64_t c = 0; c < directions; ++c)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

/// The square of a distance less what rounding may add to it: that of the sums and of the lengths
/// of the directions is far below 1e-12 of the distance.
double squared_less(double distance, const ReducedRows::Query& query) {
    const double bound = distance * (1 - 1e-12) - query.error;
    return bound > 0 ? bound * bound : 0;
}

} // namespace

ReducedRows::ReducedRows(ConstMatrixView x, std::span<const std::int32_t> rows)
    : mean_(static_cast<std::size_t>(x.cols)) {
    const auto count = static_cast<std::int64_t>(rows.size());
    if (count > 0)
        std::copy_n(x.row(rows[0]), x.cols, mean_.begin());
    const Matrix about_first = sample_of(x, rows, mean_.data());
    for (std::int64_t i = 0; i < about_first.rows(); ++i)
        axpy(1 / static_cast<double>(about_first.rows()), about_first.row(i), mean_.data(), x.cols);
    basis_ = count > 0 ? sample_directions(sample_of(x, rows, mean_.data()))
                       : Matrix(directions, x.cols);
    reduced_ = Matrix(count, lanes);
    AlignedVector<double> remainder;
    for (std::int64_t i = 0; i < count; ++i)
        size_ = std::max(size_,
                         put(x.row(rows[static_cast<std::size_t>(i)]), remainder, reduced_.row(i)));
}

/// Returns the distance from the mean.
double ReducedRows::put(const double* row, AlignedVector<double>& remainder, double* out) const {
    const auto cols = static_cast<std::int64_t>(mean_.size());
    remainder.resize(mean_.size());
    for (std::size_t c = 0; c < mean_.size(); ++c)
        remainder[c] = row[c] - mean_[c];
    const double size = std::sqrt(dot(remainder.data(), remainder.data(), cols));
    for (std::int64_t l = 0; l < directions; ++l)
        out[l] = dot(basis_.row(l), remainder.data(), cols);
    for (std::int64_t l = 0; l < directions; ++l)
        axpy(-out[l], basis_.row(l), remainder.data(), cols);
    out[remainder_at] = std::sqrt(dot(remainder.data(), remainder.data(), cols));
    return size;
}

ReducedRows::Query ReducedRows::reduce(const double* row) const {
    Query query{AlignedVector<double>(lanes), 0};
    AlignedVector<double> remainder;
    const double size = put(row, remainder, query.reduced.data());
    const auto terms = static_cast<double>(mean_.size() + query.reduced.size());
    query.error = 8 * terms * epsilon * (size + size_);
    return query;
}

double ReducedRows::bound(const Query& query, std::int64_t i) const {
    return squared_less(std::sqrt(squared_distance_of_lanes(query.reduced.data(), reduced_.row(i))),
                        query);
}

ReducedSegments::ReducedSegments(ConstMatrixView x, std::span<const Segment> segments,
                                 ConstMatrixView reduced)
    : reduced_(reduced), middles_(Matrix::unset(reduced.rows, reduced.cols)) {
    next_.reserve(segments.size());
    margins_.reserve(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto [row, next] = segments[i];
        // The segments begin at ascending rows.
        const auto end = std::lower_bound(
            segments.begin() + static_cast<std::ptrdiff_t>(i), segments.end(), next,
            [](const Segment& segment, std::int32_t value) { return segment.row < value; });
        next_.push_back(static_cast<std::int32_t>(end - segments.begin()));
        const double* from = reduced.row(static_cast<std::int64_t>(i));
        const double* to = reduced.row(next_.back());
        double* middle = middles_.row(static_cast<std::int64_t>(i));
        for (std::int64_t c = 0; c < lanes; ++c)
            middle[c] = 0.5 * (from[c] + to[c]);
        const double length = squared_distance(x.row(row), x.row(next), x.cols);
        const double along = along_directions(from, to);
        const double remainders = std::sqrt(std::max(length * (1 + 1e-12) - along, 0.0));
        margins_.push_back(0.5 * std::sqrt(squared_distance_of_lanes(from, to)) + 0.5 * remainders);
    }
}

double ReducedSegments::bound(const ReducedRows::Query& query, std::int64_t i, double reach) const {
    const double* z = query.reduced.data();
    const double* middle = middles_.row(i);
    const double away =
        std::sqrt(squared_distance_of_lanes(z, middle)) - margins_[static_cast<std::size_t>(i)];
    if (const double far = squared_less(away, query); far > reach)
        return far;
    const double* end = reduced_.row(next_[static_cast<std::size_t>(i)]);
    double share = 0, square = 0;
    for (std::int64_t c = 0; c < directions; ++c) {
        share += (z[c] - middle[c]) * (end[c] - middle[c]);
        square += (end[c] - middle[c]) * (end[c] - middle[c]);
    }
    share = square > 0 ? std::clamp(share / square, -1.0, 1.0) : 0;
    double along = 0;
    for (std::int64_t c = 0; c < directions; ++c) {
        const double d = z[c] - middle[c] - share * (end[c] - middle[c]);
        along += d * d;
    }
    const double longest =
        std::max(end[remainder_at], 2 * middle[remainder_at] - end[remainder_at]);
    const double beyond = std::max(z[remainder_at] - longest, 0.0);
    return squared_less(std::sqrt(along + beyond * beyond), query);
}

} // namespace stltsa::ltsa
