// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/eigen.hpp"

#include <algorithm>

#include <lapacke.h>

static_assert(sizeof(lapack_int) == sizeof(std::int32_t), "LAPACK with 32-bit integers is needed");

namespace stltsa {

TopEigenpairs::TopEigenpairs(std::int64_t order, std::int64_t count)
    : order_(static_cast<std::int32_t>(order)), count_(static_cast<std::int32_t>(count)),
      matrix_(checked_size(order, order)), values_(static_cast<std::size_t>(order)),
      vectors_(checked_size(order, count)), scratch_(order, order),
      support_(2 * static_cast<std::size_t>(order)) {
    double work_size = 0;
    lapack_int integer_work_size = 0;
    lapack_int found = 0;
    LAPACKE_dsyevr_work(LAPACK_COL_MAJOR, 'V', 'I', 'L', order_, matrix_.data(), order_, 0, 0,
                        order_ - count_ + 1, order_, 0, &found, values_.data(), vectors_.data(),
                        order_, support_.data(), &work_size, -1, &integer_work_size, -1);
    double values_work_size = 0;
    lapack_int values_integer_work_size = 0;
    LAPACKE_dsyevd_work(LAPACK_COL_MAJOR, 'N', 'L', order_, matrix_.data(), order_, values_.data(),
                        &values_work_size, -1, &values_integer_work_size, -1);
    work_.resize(static_cast<std::size_t>(std::max(work_size, values_work_size)));
    integer_work_.resize(
        static_cast<std::size_t>(std::max(integer_work_size, values_integer_work_size)));
}

void TopEigenpairs::solve() {
    if (!solve_largest())
        solve_all();
}

/// False if dsyevr did not find them: near multiples of the identity it may report success without
/// eigenpairs.
bool TopEigenpairs::solve_largest() {
    std::copy_n(matrix_.data(), matrix_.size(), scratch_.data());
    lapack_int found = 0;
    const lapack_int info = LAPACKE_dsyevr_work(
        LAPACK_COL_MAJOR, 'V', 'I', 'L', order_, scratch_.data(), order_, 0, 0, order_ - count_ + 1,
        order_, 0, &found, values_.data(), vectors_.data(), order_, support_.data(), work_.data(),
        static_cast<lapack_int>(work_.size()), integer_work_.data(),
        static_cast<lapack_int>(integer_work_.size()));
    return info == 0 && found == count_;
}

void TopEigenpairs::solve_all() {
    std::copy_n(matrix_.data(), matrix_.size(), scratch_.data());
    std::vector<double> values;
    symmetric_eigen(scratch_, values);
    const std::int64_t first = order_ - count_;
    std::copy_n(values.begin() + first, count_, values_.begin());
    std::copy_n(scratch_.row(first), count_ * std::int64_t{order_}, vectors_.data());
}

void TopEigenpairs::solve_values() {
    std::copy_n(matrix_.data(), matrix_.size(), scratch_.data());
    const lapack_int info =
        LAPACKE_dsyevd_work(LAPACK_COL_MAJOR, 'N', 'L', order_, scratch_.data(), order_,
                            values_.data(), work_.data(), static_cast<lapack_int>(work_.size()),
                            integer_work_.data(), static_cast<lapack_int>(integer_work_.size()));
    if (info != 0)
        fail(Status::internal, "LAPACK dsyevd failed on a matrix of order {} (info {})", order_,
             info);
}

double TopEigenpairs::value(std::int64_t pair) const {
    return values_[static_cast<std::size_t>(count_ - 1 - pair)];
}

const double* TopEigenpairs::vector(std::int64_t pair) const {
    return vectors_.data() + (count_ - 1 - pair) * order_;
}

void symmetric_eigen(Matrix& matrix, std::vector<double>& values) {
    const auto order = static_cast<lapack_int>(matrix.rows());
    values.assign(static_cast<std::size_t>(order), 0);
    if (order == 0)
        return;
    // A symmetric matrix is its own transpose, so LAPACK's columns are rows here.
    const auto solve = [&](double* work, lapack_int work_size, lapack_int* integer_work,
                           lapack_int integer_work_size) {
        const lapack_int info =
            LAPACKE_dsyevd_work(LAPACK_COL_MAJOR, 'V', 'L', order, matrix.data(), order,
                                values.data(), work, work_size, integer_work, integer_work_size);
        if (info != 0)
            fail(Status::internal, "LAPACK dsyevd failed on a matrix of order {} (info {})", order,
                 info);
    };
    double work_size = 0;
    lapack_int integer_work_size = 0;
    solve(&work_size, -1, &integer_work_size, -1);
    AlignedVector<double> work(static_cast<std::size_t>(work_size));
    std::vector<lapack_int> integer_work(static_cast<std::size_t>(integer_work_size));
    solve(work.data(), static_cast<lapack_int>(work.size()), integer_work.data(),
          integer_work_size);
}

} // namespace stltsa
