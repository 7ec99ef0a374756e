// SPDX-License-Identifier: BSD-3-Clause
// Cholesky of matrices stored as envelopes: solved for a known solution, with the same bits by all
// code, on any number of threads, in panels and alone.
#include "linalg/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "testing.hpp"

namespace {

using stltsa::EnvelopeMatrix;
using stltsa::Machine;
using stltsa::Matrix;
using stltsa::Random;
using stltsa::Simd;

struct Made {
    std::vector<std::int64_t> reach;
    EnvelopeMatrix matrix;
};

/// A positive definite matrix whose columns reach `least` to `most` rows further.
Made made_matrix(std::int64_t order, std::int64_t least, std::int64_t most) {
    Random random(static_cast<std::uint64_t>(100 * order + 10 * least + most));
    std::vector<std::int64_t> reach(static_cast<std::size_t>(order));
    std::int64_t last = 0;
    for (std::int64_t j = 0; j < order; ++j) {
        const double share = 0.5 + 0.5 * random.symmetric();
        const auto length = least + static_cast<std::int64_t>(share * double(most - least) + 0.5);
        last = std::max(last, std::min(order - 1, j + length));
        reach[static_cast<std::size_t>(j)] = last;
    }
    Made made{reach, EnvelopeMatrix(reach, {})};
    EnvelopeMatrix& matrix = made.matrix;
    matrix.arm(0).columns.clear(0, matrix.middle_end());
    matrix.arm(1).columns.clear(0, order - matrix.middle_end());
    for (std::int64_t j = 0; j < order; ++j) {
        matrix.entry(j, j) += 0.1;
        for (std::int64_t i = j + 1; i <= reach[static_cast<std::size_t>(j)]; ++i) {
            const double entry = random.symmetric();
            matrix.entry(i, j) = entry;
            matrix.entry(j, j) += std::abs(entry);
            matrix.entry(i, i) += std::abs(entry);
        }
    }
    return made;
}

Matrix product(Made& made, const Matrix& x) {
    Matrix y(x.rows(), x.cols());
    for (std::int64_t j = 0; j < made.matrix.order(); ++j)
        for (std::int64_t i = j; i <= made.reach[static_cast<std::size_t>(j)]; ++i)
            for (std::int64_t c = 0; c < x.cols(); ++c) {
                y(i, c) += made.matrix.entry(i, j) * x(j, c);
                if (i > j)
                    y(j, c) += made.matrix.entry(i, j) * x(i, c);
            }
    return y;
}

Matrix solved(EnvelopeMatrix matrix, const Matrix& right, const Machine& machine) {
    Matrix x = right;
    assert_true(cholesky(matrix, 1e-13, machine));
    cholesky_solve(matrix, x.view(), machine);
    return x;
}

void check_matrix(Made made) {
    const EnvelopeMatrix& matrix = made.matrix;
    constexpr std::int64_t cols = 4;
    Random random(1);
    Matrix right(matrix.order(), cols);
    for (std::int64_t i = 0; i < right.rows() * cols; ++i)
        right.data()[i] = random.symmetric();
    const Matrix x = solved(matrix, right, {Simd::baseline, 1});
    const Matrix back = product(made, x);
    for (std::int64_t i = 0; i < right.rows() * cols; ++i)
        ASSERT_NEAR(back.data()[i], right.data()[i], 1e-12);

    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512})
        for (const int threads : {1, 2}) {
            if (!stltsa::simd_available(simd))
                continue;
            const Machine machine{simd, threads};
            const Matrix again = solved(matrix, right, machine);
            assert_true(std::equal(x.row(0), x.row(x.rows()), again.row(0)));
            Matrix column(matrix.order(), 1);
            for (std::int64_t i = 0; i < matrix.order(); ++i)
                column(i, 0) = right(i, 1);
            column = solved(matrix, column, machine);
            for (std::int64_t i = 0; i < matrix.order(); ++i)
                assert_true(column(i, 0) == x(i, 1));
        }
}

void small_ones(void**) {
    for (std::int64_t order = 1; order <= 24; ++order)
        for (const std::int64_t least : {0, 1, 3, 11})
            for (const std::int64_t more : {0, 1, 5})
                check_matrix(made_matrix(order, least, least + more));
}

/// Orders from which on two threads share the work, and of both halves every rest of four.
void large_ones(void**) {
    for (std::int64_t order = 20000; order < 20008; ++order)
        check_matrix(made_matrix(order, 8, 12));
}

void a_singular_one_is_refused(void**) {
    for (const std::int64_t least : {0, 3})
        for (const std::int64_t where : {0, 7, 10, 19}) {
            EnvelopeMatrix matrix = made_matrix(20, least, least).matrix;
            matrix.entry(where, where) = 0;
            assert_false(cholesky(matrix, 1e-13, {}));
        }
}

/// The identity but for rows `first` to `first` + 4, which reach each other: the last of them to be
/// eliminated is left with this share of its diagonal entry. Their sizes differ by `scale` from
/// each to the next.
EnvelopeMatrix with_pivot(std::int64_t order, std::int64_t first, double share, double scale) {
    const std::int64_t last = first + 4;
    std::vector<std::int64_t> reach;
    for (std::int64_t j = 0; j < order; ++j)
        reach.push_back(first <= j && j <= last ? last : j);
    EnvelopeMatrix matrix(reach, {});
    matrix.arm(0).columns.clear(0, matrix.middle_end());
    matrix.arm(1).columns.clear(0, order - matrix.middle_end());
    const auto size = [&](std::int64_t i) { return std::pow(scale, double(i - first)); };
    for (std::int64_t j = 0; j < order; ++j)
        matrix.entry(j, j) = first <= j && j <= last ? size(j) * size(j) : 1;
    matrix.entry(last, first) = std::sqrt(1 - share) * size(last);
    return matrix;
}

/// A pivot is held against what its diagonal entry was, in both arms and in the middle.
void small_pivots_are_refused(void**) {
    constexpr std::int64_t order = 24;
    for (const std::int64_t first : {2, 9, 10, 17})
        for (const double scale : {1e-4, 1.0, 1e4})
            for (const Simd simd : {Simd::baseline, stltsa::widest_simd()}) {
                EnvelopeMatrix regular = with_pivot(order, first, 1e-12, scale);
                assert_true(cholesky(regular, 1e-13, {simd, 1}));
                EnvelopeMatrix singular = with_pivot(order, first, 1e-14, scale);
                assert_false(cholesky(singular, 1e-13, {simd, 1}));
            }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(small_ones),
        cmocka_unit_test(large_ones),
        cmocka_unit_test(a_singular_one_is_refused),
        cmocka_unit_test(small_pivots_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
