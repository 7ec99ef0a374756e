// SPDX-License-Identifier: BSD-3-Clause
// Block iteration: V := orthonormal basis of A V, and now and then the best eigenvectors in the
// span of V (Rayleigh-Ritz). It starts from polynomials of the frames' order, which the directions
// of a short piece of motion nearly are.
#include "ltsa/tangent_batch.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/simd.hpp"
#include "ltsa/tangent_kernel.hpp"

namespace stltsa::ltsa {
namespace {

/// Rows and columns that a product keeps in registers.
std::int64_t rounded_up(std::int64_t value, std::int64_t step) {
    return (value + step - 1) / step * step;
}

} // namespace

TangentBatch::TangentBatch(std::int64_t size, std::int64_t count, Simd simd)
    : size_(size), count_(count), rows_(rounded_up(size, product_rows)),
      columns_(rounded_up(count + 2, product_columns)), simd_(simd), lanes_(simd_width(simd)) {
    const auto sized = [this](std::int64_t entries) {
        return AlignedVector<double>(checked_size(entries, lanes_));
    };
    matrix_ = sized(rows_ * rows_);
    start_.resize(checked_size(rows_, columns_));
    block_ = sized(rows_ * columns_);
    product_ = sized(rows_ * columns_);
    small_ = sized(columns_ * (2 * columns_ + 1));
    values_ = sized(count_ + 1);
    vectors_ = sized(rows_ * count_);
    fill_start();
}

/// Orthonormal polynomials of degree 1, 2, .. on 0 .. size-1; zeros where there are no more.
void TangentBatch::fill_start() {
    const double middle = 0.5 * static_cast<double>(size_ - 1);
    const std::int64_t degrees = std::min(columns_, size_ - 1);
    AlignedVector<double> before(static_cast<std::size_t>(size_),
                                 1 / std::sqrt(static_cast<double>(size_)));
    const double* lower = before.data();
    for (std::int64_t l = 0; l < degrees; ++l) {
        double* column = start_.data() + l * rows_;
        for (std::int64_t a = 0; a < size_; ++a)
            column[a] = lower[a] * (static_cast<double>(a) - middle) / (middle + 1);
        for (int pass = 0; pass < 2; ++pass) {
            axpy(-dot(before.data(), column, size_), before.data(), column, size_);
            for (std::int64_t b = 0; b < l; ++b)
                axpy(-dot(start_.data() + b * rows_, column, size_), start_.data() + b * rows_,
                     column, size_);
        }
        const double norm = std::sqrt(dot(column, column, size_));
        for (std::int64_t a = 0; a < size_; ++a)
            column[a] /= norm;
        lower = column;
    }
}

void TangentBatch::solve() {
    run_simd(simd_, TangentKernel{size_, rows_, columns_, count_, matrix_.data(), start_.data(),
                                  block_.data(), product_.data(), small_.data(), values_.data(),
                                  vectors_.data()});
}

void TangentBatch::direction(std::int64_t lane, std::int64_t l, double* out) const {
    for (std::int64_t a = 0; a < size_; ++a)
        out[a] = vectors_[index(l * rows_ + a, lane)];
}

} // namespace stltsa::ltsa
