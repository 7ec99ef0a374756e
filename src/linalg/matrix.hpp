// SPDX-License-Identifier: BSD-3-Clause
// Row-major matrices and views of them: frames are rows everywhere.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace stltsa {

/// 64-byte alignment, so that BLAS kernels take the same path and give the same bits on every run.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    static constexpr std::align_val_t alignment{64};
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
            throw std::bad_alloc();
        return static_cast<T*>(::operator new(count * sizeof(T), alignment));
    }
    void deallocate(T* data, std::size_t) { ::operator delete(data, alignment); }
    template <class U>
    bool operator==(const AlignedAllocator<U>&) const {
        return true;
    }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

/// Leaves entries uninitialized. The first access to fresh memory costs as much as the work on it:
/// for large arrays the threads that write them should do it, not the constructor.
template <class T>
struct UnsetAllocator : AlignedAllocator<T> {
    using AlignedAllocator<T>::AlignedAllocator;
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    template <class U>
    void construct(U* at) {
        ::new (static_cast<void*>(at)) U;
    }
};

template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

/// A rows x cols matrix owned by others: row r starts at data + r * stride, columns are adjacent.
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

/// rows * cols as a size. Throws Status::no_memory if the product is too large.
inline std::size_t checked_size(std::int64_t rows, std::int64_t cols) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 8;
    if (rows < 0 || cols < 0)
        fail(Status::internal, "a matrix of {} x {} was requested", rows, cols);
    if (cols != 0 && rows > most / cols)
        fail(Status::no_memory, "a matrix of {} x {} does not fit into memory", rows, cols);
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
}

/// A dense matrix that owns its entries, initially zero except for unset().
class Matrix {
  public:
    Matrix() = default;
    Matrix(std::int64_t rows, std::int64_t cols) : Matrix(unset(rows, cols)) {
        std::fill(data_.begin(), data_.end(), 0.0);
    }
    /// Entries are not initialized.
    static Matrix unset(std::int64_t rows, std::int64_t cols) {
        Matrix matrix;
        matrix.rows_ = rows;
        matrix.cols_ = cols;
        matrix.data_.resize(checked_size(rows, cols));
        return matrix;
    }

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
    UnsetVector<double> data_;
};

/// Copies packed rows.
inline Matrix copied(ConstMatrixView packed) {
    Matrix copy = Matrix::unset(packed.rows, packed.cols);
    std::copy_n(packed.data, packed.rows * packed.cols, copy.data());
    return copy;
}

} // namespace stltsa
