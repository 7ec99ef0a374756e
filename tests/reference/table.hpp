// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace reference {

/// Row-major rows x cols entries.
template <class T>
struct Table {
    std::size_t rows = 0;
    std::size_t cols = 0;
    std::vector<T> values;

    Table() = default;
    Table(std::size_t r, std::size_t c) : rows(r), cols(c), values(r * c, T(0)) {}
    T& operator()(std::size_t r, std::size_t c) { return values[r * cols + c]; }
    const T& operator()(std::size_t r, std::size_t c) const { return values[r * cols + c]; }
    T* row(std::size_t r) { return values.data() + r * cols; }
    const T* row(std::size_t r) const { return values.data() + r * cols; }
};

} // namespace reference
