// SPDX-License-Identifier: BSD-3-Clause
#include "results/postures.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "linalg/simd.hpp"

namespace stltsa::results {
namespace {

constexpr std::size_t most_postures = 24;
/// Of more rows, only every second, third, ... is tried.
constexpr std::int64_t most_tried = 2000;
/// Postures that are closer in time than this share of the clip count as more alike than their
/// poses are. A picture shows about a dozen.
constexpr double apart = 1.0 / 12;
/// Weight of the distance in time, relative to the mean difference of two postures.
constexpr double weight_of_time = 0.7;

class Choice {
  public:
    explicit Choice(ConstMatrixView samples)
        : samples_(samples), stride_((samples.rows + most_tried - 1) / most_tried),
          nearest_(static_cast<std::size_t>((samples.rows + stride_ - 1) / stride_)) {
        std::vector<double> mean(static_cast<std::size_t>(samples.cols), 0);
        const double share = 1 / static_cast<double>(nearest_.size());
        for (std::int64_t row = 0; row < samples.rows; row += stride_) {
            axpy(share, samples.row(row), mean.data(), samples.cols);
            checkpoint(samples.cols);
        }
        double squares = 0;
        for (std::size_t i = 0; i < nearest_.size(); ++i) {
            nearest_[i] = distance(mean.data(), row_of(i));
            squares += share * nearest_[i] * nearest_[i];
        }
        mean_difference_ = std::sqrt(2 * squares);
    }

    /// Takes the row that differs most from those taken. Returns whether there was one.
    bool take(std::vector<std::int64_t>& rows) {
        const auto farthest = std::ranges::max_element(nearest_);
        if (!(*farthest > 0))
            return false;
        const std::int64_t row = row_of(static_cast<std::size_t>(farthest - nearest_.begin()));
        rows.push_back(row);
        for (std::size_t i = 0; i < nearest_.size(); ++i) {
            const double difference = difference_of(row, row_of(i));
            nearest_[i] = rows.size() == 1 ? difference : std::min(nearest_[i], difference);
        }
        return true;
    }

  private:
    std::int64_t row_of(std::size_t tried) const {
        return static_cast<std::int64_t>(tried) * stride_;
    }

    double distance(const double* pose, std::int64_t row) {
        checkpoint(samples_.cols);
        return std::sqrt(squared_distance(pose, samples_.row(row), samples_.cols));
    }

    double difference_of(std::int64_t a, std::int64_t b) {
        const double share =
            std::abs(static_cast<double>(a - b)) / static_cast<double>(samples_.rows);
        const double in_time = std::min(1.0, share / apart);
        return (distance(samples_.row(a), b) / mean_difference_ + weight_of_time) * in_time;
    }

    ConstMatrixView samples_;
    std::int64_t stride_;
    std::vector<double> nearest_; ///< of each row tried: difference from the nearest one taken
    double mean_difference_ = 0;  ///< of two rows, root mean square
};

} // namespace

std::vector<std::int64_t> telling_postures(ConstMatrixView samples) {
    std::vector<std::int64_t> rows;
    Choice choice(samples);
    while (rows.size() < most_postures && choice.take(rows)) {
    }
    return rows;
}

} // namespace stltsa::results
