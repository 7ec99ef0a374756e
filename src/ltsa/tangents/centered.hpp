// SPDX-License-Identifier: BSD-3-Clause
// Centers the frames of a neighborhood. One frame is subtracted first and then the mean of the
// differences, because subtracting the mean alone would lose digits to a large common offset.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"

namespace stltsa::ltsa {

/// Writes frame - origin for each member.
inline void write_differences(ConstMatrixView x, std::span<const std::int32_t> members,
                              const double* origin, double* out) {
    for (const std::int32_t member : members)
        for (std::int64_t c = 0; c < x.cols; ++c)
            *out++ = x(member, c) - origin[c];
}

inline void mean_of(ConstMatrixView rows, double* mean) {
    std::fill_n(mean, rows.cols, 0.0);
    for (std::int64_t a = 0; a < rows.rows; ++a)
        for (std::int64_t c = 0; c < rows.cols; ++c)
            mean[c] += rows(a, c);
    for (std::int64_t c = 0; c < rows.cols; ++c)
        mean[c] /= static_cast<double>(rows.rows);
}

inline void subtract(const double* offset, MatrixView rows) {
    for (std::int64_t a = 0; a < rows.rows; ++a)
        for (std::int64_t c = 0; c < rows.cols; ++c)
            rows(a, c) -= offset[c];
}

} // namespace stltsa::ltsa
