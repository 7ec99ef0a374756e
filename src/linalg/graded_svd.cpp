// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/graded_svd.hpp"

#include <algorithm>

#include <lapacke.h>

namespace stltsa {

GradedSvd::GradedSvd(std::int64_t rows, std::int64_t cols, std::int64_t count)
    : rows_(static_cast<std::int32_t>(rows)), cols_(static_cast<std::int32_t>(cols)),
      rank_(std::min(rows_, cols_)), count_(static_cast<std::int32_t>(count)),
      matrix_(checked_size(rows, cols)), scales_(static_cast<std::size_t>(rank_)),
      triangle_(checked_size(cols, rank_)), rotations_(checked_size(rank_, rank_)),
      values_(static_cast<std::size_t>(rank_)), vectors_(checked_size(rows, count)),
      pivots_(static_cast<std::size_t>(cols)) {
    double factor_work = 0, product_work = 0;
    LAPACKE_dgeqp3_work(LAPACK_COL_MAJOR, rows_, cols_, matrix_.data(), rows_, pivots_.data(),
                        scales_.data(), &factor_work, -1);
    LAPACKE_dormqr_work(LAPACK_COL_MAJOR, 'L', 'N', rows_, count_, rank_, matrix_.data(), rows_,
                        scales_.data(), vectors_.data(), rows_, &product_work, -1);
    work_.resize(static_cast<std::size_t>(
        std::max({factor_work, product_work, 6.0,
                  static_cast<double>(cols_) + static_cast<double>(rank_)})));
}

// With A P = Q R and R^T = U S V^T, A P = (Q V) S U^T.
bool GradedSvd::solve() {
    const auto work_size = static_cast<lapack_int>(work_.size());
    std::fill(pivots_.begin(), pivots_.end(), 0);
    LAPACKE_dgeqp3_work(LAPACK_COL_MAJOR, rows_, cols_, matrix_.data(), rows_, pivots_.data(),
                        scales_.data(), work_.data(), work_size);
    for (std::int64_t i = 0; i < rank_; ++i)
        for (std::int64_t j = 0; j < cols_; ++j)
            triangle_[static_cast<std::size_t>(i * cols_ + j)] =
                j < i ? 0 : matrix_[static_cast<std::size_t>(j * rows_ + i)];
    work_[0] = 0;
    const lapack_int info =
        LAPACKE_dgesvj_work(LAPACK_COL_MAJOR, 'G', 'N', 'V', cols_, rank_, triangle_.data(), cols_,
                            values_.data(), 0, rotations_.data(), rank_, work_.data(), work_size);
    if (info != 0)
        return false;
    for (double& value : values_)
        value *= work_[0]; // kept apart where it could over- or underflow
    std::fill(vectors_.begin(), vectors_.end(), 0.0);
    for (std::int64_t l = 0; l < count_; ++l)
        std::copy_n(rotations_.data() + l * rank_, rank_, vectors_.data() + l * rows_);
    LAPACKE_dormqr_work(LAPACK_COL_MAJOR, 'L', 'N', rows_, count_, rank_, matrix_.data(), rows_,
                        scales_.data(), vectors_.data(), rows_, work_.data(), work_size);
    return true;
}

} // namespace stltsa
