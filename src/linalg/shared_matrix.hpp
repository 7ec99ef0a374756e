// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "linalg/matrix.hpp"

namespace stltsa {

/// A matrix whose copies share its entries until one is edited. They may lie in memory of another
/// kind, such as a mapped file, which `owner` keeps.
class SharedMatrix {
  public:
    SharedMatrix() = default;
    SharedMatrix(Matrix matrix)
        : own_(std::make_shared<Matrix>(std::move(matrix))), entries_(std::as_const(*own_).view()),
          owner_(own_) {}
    /// `entries`: packed rows (stride = cols).
    SharedMatrix(ConstMatrixView entries, std::shared_ptr<const void> owner)
        : entries_(entries), owner_(std::move(owner)) {}

    // No moves, so that what was moved from is whole: a copy costs no more.
    SharedMatrix(const SharedMatrix&) = default;
    SharedMatrix& operator=(const SharedMatrix&) = default;
    ~SharedMatrix() = default;

    std::int64_t rows() const { return entries_.rows; }
    std::int64_t cols() const { return entries_.cols; }
    const double* data() const { return entries_.data; }
    const double* row(std::int64_t r) const { return entries_.row(r); }
    double operator()(std::int64_t r, std::int64_t c) const { return entries_(r, c); }
    ConstMatrixView view() const { return entries_; }

    /// Rows from `first` on.
    SharedMatrix from_row(std::int64_t first) const {
        return {entries_.block(first, rows() - first), owner_};
    }

    /// The entries for writing, copied first where others have them too. Its shape is to stay.
    Matrix& edit() {
        constexpr long by_this = 2; // own_ and owner_
        if (!own_ || own_.use_count() > by_this)
            *this = copied(entries_);
        return *own_;
    }

  private:
    std::shared_ptr<Matrix> own_; ///< none: the entries are not all of a Matrix
    ConstMatrixView entries_;
    std::shared_ptr<const void> owner_;
};

} // namespace stltsa
