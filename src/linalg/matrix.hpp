// SPDX-License-Identifier: BSD-3-Clause
// Row-major matrices and views of them: frames are rows everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "linalg/memory.hpp"

namespace stltsa {

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// rows x cols, row r starts at data + r * stride, columns are adjacent. Owns nothing.
template <class T>
struct View {
    T* data = nullptr;
    std::int64_t rows = 0;
    std::int64_t cols = 0;
    std::int64_t stride = 0;

    T* row(std::int64_t r) const { return data + r * stride; }
    T& operator()(std::int64_t r, std::int64_t c) const { return data[r * stride + c]; }
    View block(std::int64_t first_row, std::int64_t count) const {
        return {row(first_row), count, cols, stride};
    }
    operator View<const T>() const requires(!std::is_const_v<T>) {
        return {data, rows, cols, stride};
    }
};

using MatrixView = View<double>;
using ConstMatrixView = View<const double>;

/// rows * cols as a size, or Status::no_memory when the product does not fit.
inline std::size_t checked_size(std::int64_t rows, std::int64_t cols) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 8;
    if (rows < 0 || cols < 0)
        fail(Status::internal, "a matrix of {} x {} was asked for", rows, cols);
    if (cols != 0 && rows > most / cols)
        fail(Status::no_memory, "a matrix of {} x {} does not fit into memory", rows, cols);
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
}

/// A dense matrix that owns its entries, zero when made.
class Matrix {
  public:
    Matrix() = default;
    Matrix(std::int64_t rows, std::int64_t cols)
        : rows_(rows), cols_(cols), data_(checked_size(rows, cols)) {}

    std::int64_t rows() const { return rows_; }
    std::int64_t cols() const { return cols_; }
    double* data() { return data_.data(); }
    const double* data() const { return data_.data(); }
    double* row(std::int64_t r) { return data_.data() + r * cols_; }
    const double* row(std::int64_t r) const { return data_.data() + r * cols_; }
    double& operator()(std::int64_t r, std::int64_t c) {
        return data_[static_cast<std::size_t>(r * cols_ + c)];
    }
    double operator()(std::int64_t r, std::int64_t c) const {
        return data_[static_cast<std::size_t>(r * cols_ + c)];
    }
    MatrixView view() { return {data_.data(), rows_, cols_, cols_}; }
    ConstMatrixView view() const { return {data_.data(), rows_, cols_, cols_}; }

  private:
    std::int64_t rows_ = 0;
    std::int64_t cols_ = 0;
    AlignedVector<double> data_;
};

} // namespace stltsa
