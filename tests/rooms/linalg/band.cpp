// SPDX-License-Identifier: BSD-3-Clause
// Cholesky factors of band matrices: known solutions are found, and small pivots are refused.
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

/// A random, diagonally dominant matrix.
BandMatrix made_matrix(std::int64_t order, std::int64_t bandwidth) {
    Random random(static_cast<std::uint64_t>(100 * order + bandwidth));
    BandMatrix matrix(order, bandwidth);
    for (std::int64_t j = 0; j < order; ++j) {
        matrix.column(j)[0] = 0.1 + 2 * static_cast<double>(bandwidth);
        for (std::int64_t i = 1; i <= bandwidth; ++i)
            matrix.column(j)[i] = random.symmetric();
    }
    return matrix;
}

/// y := matrix x for each row.
Matrix product(BandMatrix& matrix, const Matrix& x) {
    Matrix y(x.rows(), x.cols());
    for (std::int64_t r = 0; r < x.rows(); ++r)
        for (std::int64_t j = 0; j < matrix.order(); ++j)
            for (std::int64_t i = j; i <= std::min(j + matrix.bandwidth(), matrix.order() - 1);
                 ++i) {
                const double entry = matrix.column(j)[i - j];
                y(r, i) += entry * x(r, j);
                if (i > j)
                    y(r, j) += entry * x(r, i);
            }
    return y;
}

void check_solution(std::int64_t order, std::int64_t bandwidth) {
    BandMatrix matrix = made_matrix(order, bandwidth);
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
    for (const std::int64_t bandwidth : {0, 1, 10, 33, 100})
        for (const std::int64_t order : {1, 2, 40, 5000})
            check_solution(order, bandwidth);
}

/// The identity, except for one off-diagonal entry and the scale of its row, which leave one pivot
/// with this share of its diagonal entry.
bool factors_with_pivot(std::int64_t bandwidth, double share, double scale) {
    BandMatrix matrix(50, bandwidth);
    for (std::int64_t j = 0; j < matrix.order(); ++j) {
        std::fill_n(matrix.column(j), bandwidth + 1, 0.0);
        *matrix.column(j) = 1;
    }
    *matrix.column(20 + bandwidth) = scale * scale;
    matrix.column(20)[bandwidth] = std::sqrt(1 - share) * scale;
    return matrix.factor(1e-13);
}

void small_pivots_are_refused(void**) {
    for (const std::int64_t bandwidth : {1, 10, 29})
        for (const double scale : {1e-4, 1.0, 1e4}) {
            assert_true(factors_with_pivot(bandwidth, 1e-12, scale));
            assert_false(factors_with_pivot(bandwidth, 1e-14, scale));
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
