// SPDX-License-Identifier: BSD-3-Clause
#include "motion/period/directions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/checkpoint.hpp"
#include "linalg/eigen.hpp"
#include "linalg/principal.hpp"
#include "linalg/simd.hpp"

namespace stltsa::motion {
namespace {

/// The directions contain this share of the variance unless the limit on their number is reached.
constexpr double variance_share = 0.995;
constexpr std::int64_t most_directions = 16;
/// The eigenvectors of a matrix of this order take less than half a second. With more columns, the
/// directions come from the matrix of the rows: at most this many, evenly spaced in time.
constexpr std::int64_t most_columns = 1024;
constexpr std::int64_t most_rows = most_columns / 2;

/// The rows whose scatter is computed.
class Scatter {
  public:
    Scatter(ConstMatrixView x, const std::vector<double>& usual)
        : x_(x), mean_(column_means(x)), usual_(usual),
          work_of_row_(x.cols <= most_columns ? x.cols * x.cols / 2 : x.cols) {}

    ConstMatrixView rows() const { return x_; }
    /// A pose, relative to the mean.
    void put_pose(std::int64_t i, double* row) {
        checkpoint(work_of_row_);
        std::transform(x_.row(i), x_.row(i) + x_.cols, mean_.begin(), row, std::minus<>());
    }
    /// A velocity, relative to the usual one.
    void put_velocity(std::int64_t i, double* row) {
        checkpoint(work_of_row_);
        const double scale = usual_[static_cast<std::size_t>(i)];
        for (std::int64_t c = 0; c < x_.cols; ++c)
            row[c] = scale > 0 ? (x_(i + 1, c) - x_(i, c)) / scale : 0;
    }

  private:
    ConstMatrixView x_;
    std::vector<double> mean_;
    const std::vector<double>& usual_;
    std::int64_t work_of_row_; ///< including its products with itself
};

/// Adds the outer products of `count` rows, which row_of(i, values) writes, divided by their trace.
template <class RowOf>
void add_covariance(std::int64_t count, const RowOf& row_of, Matrix& sums) {
    const std::int64_t cols = sums.cols();
    Matrix own(cols, cols);
    std::vector<double> row(static_cast<std::size_t>(cols));
    for (std::int64_t i = 0; i < count; ++i) {
        row_of(i, row.data());
        for (std::int64_t c = 0; c < cols; ++c)
            axpy(row[static_cast<std::size_t>(c)], row.data(), own.row(c), c + 1);
    }
    double trace = 0;
    for (std::int64_t c = 0; c < cols; ++c)
        trace += own(c, c);
    if (trace > 0)
        axpy(1 / trace, own.data(), sums.data(), cols * cols);
}

/// The eigenpairs that contain the share.
struct Leading {
    TopEigenpairs pairs;
    std::int64_t count = 0;

    /// Reads the lower triangle of `sums`.
    explicit Leading(const Matrix& sums)
        : pairs(sums.cols(), std::min(sums.cols(), most_directions)) {
        const std::int64_t order = sums.cols(), most = std::min(order, most_directions);
        double total = 0;
        for (std::int64_t c = 0; c < order; ++c) {
            total += sums(c, c);
            for (std::int64_t r = c; r < order; ++r)
                pairs.matrix()[r + c * order] = sums(r, c);
        }
        pairs.solve();
        for (double sum = 0; count < most && (count == 0 || sum < variance_share * total); ++count)
            sum += pairs.value(count);
    }
};

Matrix of_columns(Scatter& scatter) {
    const ConstMatrixView x = scatter.rows();
    Matrix sums(x.cols, x.cols);
    add_covariance(
        x.rows, [&](std::int64_t i, double* row) { scatter.put_pose(i, row); }, sums);
    add_covariance(
        x.rows - 1, [&](std::int64_t i, double* row) { scatter.put_velocity(i, row); }, sums);
    const Leading leading(sums);
    Matrix directions(x.cols, leading.count);
    for (std::int64_t d = 0; d < leading.count; ++d)
        for (std::int64_t c = 0; c < x.cols; ++c)
            directions(c, d) = leading.pairs.vector(d)[c];
    return directions;
}

/// Divides rows by the square root of the sum of their squares.
void normalize(MatrixView rows) {
    double trace = 0;
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        trace += dot(rows.row(i), rows.row(i), rows.cols);
        checkpoint(rows.cols);
    }
    for (std::int64_t i = 0; i < rows.rows && trace > 0; ++i) {
        for (std::int64_t c = 0; c < rows.cols; ++c)
            rows.row(i)[c] /= std::sqrt(trace);
        checkpoint(rows.cols);
    }
}

/// Poses, then velocities; the two scatters have equal weight.
Matrix spread_rows(Scatter& scatter) {
    const ConstMatrixView x = scatter.rows();
    const std::int64_t count = std::min(x.rows, most_rows);
    const auto place = [&](std::int64_t i, std::int64_t rows) {
        return i * (rows - 1) / std::max<std::int64_t>(1, count - 1);
    };
    Matrix a(2 * count, x.cols);
    for (std::int64_t i = 0; i < count; ++i) {
        scatter.put_pose(place(i, x.rows), a.row(i));
        if (x.rows > 1)
            scatter.put_velocity(place(i, x.rows - 1), a.row(count + i));
    }
    normalize(a.view().block(0, count));
    normalize(a.view().block(count, count));
    return a;
}

/// A^T u / |A^T u| for the leading eigenvectors u of A A^T.
Matrix of_rows(Scatter& scatter) {
    const Matrix a = spread_rows(scatter);
    Matrix products(a.rows(), a.rows());
    for (std::int64_t r = 0; r < a.rows(); ++r)
        for (std::int64_t c = 0; c <= r; ++c) {
            products(r, c) = dot(a.row(r), a.row(c), a.cols());
            checkpoint(a.cols());
        }
    const Leading leading(products);
    Matrix directions(a.cols(), leading.count);
    std::vector<double> parts(static_cast<std::size_t>(leading.count));
    for (std::int64_t r = 0; r < a.rows(); ++r) {
        for (std::int64_t d = 0; d < leading.count; ++d) {
            const double size = std::sqrt(std::max(0.0, leading.pairs.value(d)));
            parts[static_cast<std::size_t>(d)] = size > 0 ? leading.pairs.vector(d)[r] / size : 0;
        }
        for (std::int64_t c = 0; c < a.cols(); ++c)
            axpy(a(r, c), parts.data(), directions.row(c), leading.count);
        checkpoint(a.cols() * leading.count);
    }
    return directions;
}

} // namespace

Matrix leading_directions(ConstMatrixView x, const std::vector<double>& usual) {
    Scatter scatter(x, usual);
    return x.cols <= most_columns ? of_columns(scatter) : of_rows(scatter);
}

} // namespace stltsa::motion
