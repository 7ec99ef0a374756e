// SPDX-License-Identifier: BSD-3-Clause
#include "motion/curve/drift.hpp"

#include <vector>

#include "linalg/simd.hpp"

namespace stltsa::motion {

double drift_share(ConstMatrixView samples) {
    const auto cols = static_cast<std::size_t>(samples.cols);
    std::vector<double> mean(cols);
    for (std::int64_t i = 0; i < samples.rows; ++i)
        axpy(1 / static_cast<double>(samples.rows), samples.row(i), mean.data(), samples.cols);
    std::vector<double> about_mean(cols);
    std::vector<double> with_time(cols);
    double squares = 0;
    double time_squares = 0;
    for (std::int64_t i = 0; i < samples.rows; ++i) {
        const double t = static_cast<double>(i) - static_cast<double>(samples.rows - 1) / 2;
        about_mean.assign(samples.row(i), samples.row(i) + samples.cols);
        axpy(-1, mean.data(), about_mean.data(), samples.cols);
        axpy(t, about_mean.data(), with_time.data(), samples.cols);
        squares += dot(about_mean.data(), about_mean.data(), samples.cols);
        time_squares += t * t;
    }
    const double line = dot(with_time.data(), with_time.data(), samples.cols) / time_squares;
    return squares > 0 ? line / squares : 0;
}

} // namespace stltsa::motion
