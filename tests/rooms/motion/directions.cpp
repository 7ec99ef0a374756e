// SPDX-License-Identifier: BSD-3-Clause
// Directions of recordings with few and with very many columns.
#include "recordings.hpp"

#include "../checkpoints.hpp"

#include "linalg/simd.hpp"
#include "motion/period/directions.hpp"

namespace {

using namespace motion_testing;

/// Three motions, each in a third of the columns.
Matrix motions(std::int64_t rows, std::int64_t cols) {
    Matrix x(rows, cols);
    for (std::int64_t i = 0; i < rows; ++i)
        for (std::int64_t c = 0; c < cols; ++c)
            x(i, c) = (1.0 + static_cast<double>(c % 7)) *
                      std::sin(0.1 * static_cast<double>(i) * static_cast<double>(1 + c % 3));
    return x;
}

Matrix directions(const Matrix& x) {
    const std::vector<double> usual(static_cast<std::size_t>(x.rows()), 1.0);
    return leading_directions(x.view(), usual);
}

/// Checks that two sets of orthonormal columns span the same space.
void check_same_span(const Matrix& a, const Matrix& b) {
    assert_int_equal(a.cols(), b.cols());
    for (std::int64_t j = 0; j < a.cols(); ++j) {
        double inside = 0;
        for (std::int64_t k = 0; k < b.cols(); ++k) {
            double cosine = 0;
            for (std::int64_t c = 0; c < b.rows(); ++c)
                cosine += a(c, j) * b(c, k);
            inside += cosine * cosine;
        }
        ASSERT_NEAR(inside, 1, 1e-9);
    }
}

/// Columns of zeros do not change the directions, however many.
void many_columns_have_the_directions_of_few(void**) {
    const Matrix few = motions(300, 210);
    Matrix many(300, 1500);
    for (std::int64_t i = 0; i < 300; ++i)
        std::copy_n(few.row(i), 210, many.row(i));
    const Matrix of_few = directions(few);
    assert_int_equal(of_few.cols(), 3);
    Matrix padded(1500, of_few.cols());
    std::copy_n(of_few.data(), 210 * of_few.cols(), padded.data());
    check_same_span(directions(many), padded);
}

void many_columns_need_no_square_matrix(void**) {
    const Matrix of_many = directions(motions(40, 200'000));
    assert_int_equal(of_many.cols(), 3);
    const Matrix still(12, 2000);
    assert_int_equal(directions(still).cols(), 1);
    const Matrix one(1, 2000);
    assert_int_equal(directions(one).cols(), 1);
}

void it_can_be_cancelled(void**) {
    for (const std::int64_t cols : {1000, 200'000})
        assert_true(testing::ends_at(5, [&] { directions(motions(100, cols)); }));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(many_columns_have_the_directions_of_few),
        cmocka_unit_test(many_columns_need_no_square_matrix),
        cmocka_unit_test(it_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
