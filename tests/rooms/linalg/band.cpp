// SPDX-License-Identifier: BSD-3-Clause
// Cholesky of band matrices: solved for a known solution, and small pivots refused.
#include "linalg/band.hpp"

#include <algorithm>
#include <cmath>

#include "assertions.hpp"
#include "base/random.hpp"
#include "linalg/blas_threads.hpp"

namespace {

using stltsa::BandMatrix;
using stltsa::Machine;
using stltsa::Matrix;
using stltsa::Random;

/// Diagonally dominant.
BandMatrix made_matrix(std::int64_t order, std::int64_t reach) {
    Random random(static_cast<std::uint64_t>(100 * order + reach));
    BandMatrix matrix(order, reach);
    for (std::int64_t j = 0; j < order; ++j) {
        matrix.column(j)[0] = 0.1 + 2 * static_cast<double>(reach);
        for (std::int64_t i = 1; i <= reach; ++i)
            matrix.column(j)[i] = random.symmetric();
    }
    return matrix;
}

/// y := matrix x for each row.
Matrix product(BandMatrix& matrix, const Matrix& x) {
    Matrix y(x.rows(), x.cols());
    for (std::int64_t r = 0; r < x.rows(); ++r)
        for (std::int64_t j = 0; j < matrix.order(); ++j)
            for (std::int64_t i = j; i <= std::min(j + matrix.reach(), matrix.order() - 1); ++i) {
                const double entry = matrix.column(j)[i - j];
                y(r, i) += entry * x(r, j);
                if (i > j)
                    y(r, j) += entry * x(r, i);
            }
    return y;
}

void check_solution(std::int64_t order, std::int64_t reach) {
    BandMatrix matrix = made_matrix(order, reach);
    Random random(1);
    Matrix x(3, order);
    for (std::int64_t i = 0; i < 3 * order; ++i)
        x.data()[i] = random.symmetric();
    Matrix right = product(matrix, x), again = right;
    assert_true(matrix.factor(1e-13));
    matrix.solve(right.view(), Machine{stltsa::Simd::baseline, 1});
    matrix.solve(again.view(), Machine{stltsa::Simd::baseline, 2});
    assert_true(std::equal(right.row(0), right.row(3), again.row(0)));
    for (std::int64_t i = 0; i < 3 * order; ++i)
        ASSERT_NEAR(right.data()[i], x.data()[i], 1e-12);
}

void systems_are_solved(void**) {
    for (const std::int64_t reach : {0, 1, 10, 33, 100})
        for (const std::int64_t order : {1, 2, 40, 5000})
            check_solution(order, reach);
}

/// The identity, but for one entry beside the diagonal and the scale of its row: one pivot is left
/// with this share of its diagonal entry.
bool factors_with_pivot(std::int64_t reach, double share, double scale) {
    BandMatrix matrix(50, reach);
    for (std::int64_t j = 0; j < matrix.order(); ++j) {
        std::fill_n(matrix.column(j), reach + 1, 0.0);
        *matrix.column(j) = 1;
    }
    *matrix.column(20 + reach) = scale * scale;
    matrix.column(20)[reach] = std::sqrt(1 - share) * scale;
    return matrix.factor(1e-13);
}

void small_pivots_are_refused(void**) {
    for (const std::int64_t reach : {1, 10, 29})
        for (const double scale : {1e-4, 1.0, 1e4}) {
            assert_true(factors_with_pivot(reach, 1e-12, scale));
            assert_false(factors_with_pivot(reach, 1e-14, scale));
        }
}

void a_zero_pivot_is_refused(void**) {
    BandMatrix matrix = made_matrix(20, 3);
    *matrix.column(7) = 0;
    assert_false(matrix.factor(1e-13));
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(systems_are_solved),
        cmocka_unit_test(small_pivots_are_refused),
        cmocka_unit_test(a_zero_pivot_is_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
