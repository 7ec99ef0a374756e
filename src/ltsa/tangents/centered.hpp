// SPDX-License-Identifier: BSD-3-Clause
// Frames of a neighborhood about their mean. A frame is subtracted first, and then the mean of the
// differences: the mean itself would lose the digits that a large common offset has.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "linalg/matrix.hpp"

namespace stltsa::ltsa {

/// Writes frame - origin for some frames, one after another.
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
