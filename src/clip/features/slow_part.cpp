// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/slow_part.hpp"

#include <algorithm>

#include "linalg/gaussian.hpp"

namespace stltsa::clip {

Matrix slow_part(const Matrix& rows, double sigma) {
    const std::int64_t step = std::max<std::int64_t>(1, static_cast<std::int64_t>(sigma / 8));
    const Matrix knots = gaussian_smoothed(rows.view(), sigma, Beyond::nothing, step);
    Matrix result = Matrix::unset(rows.rows(), rows.cols());
    for (std::int64_t i = 0; i < rows.rows(); ++i) {
        const std::int64_t before = i / step;
        const std::int64_t after = std::min(before + 1, knots.rows() - 1);
        const double share = static_cast<double>(i % step) / static_cast<double>(step);
        for (std::int64_t c = 0; c < rows.cols(); ++c)
            result(i, c) = (1 - share) * knots(before, c) + share * knots(after, c);
    }
    return result;
}

} // namespace stltsa::clip
