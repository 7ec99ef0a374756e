// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tool {

/// A table of numbers, row after row, as the library fills it in.
struct Grid {
    std::int64_t rows = 0;
    std::int64_t cols = 0;
    std::vector<double> values;

    Grid() = default;
    Grid(std::int64_t row_count, std::int64_t col_count)
        : rows(row_count), cols(col_count),
          values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(col_count)) {}

    double& operator()(std::int64_t r, std::int64_t c) {
        return values[static_cast<std::size_t>(r * cols + c)];
    }
    double operator()(std::int64_t r, std::int64_t c) const {
        return values[static_cast<std::size_t>(r * cols + c)];
    }
    bool empty() const { return values.empty(); }
};

} // namespace tool
