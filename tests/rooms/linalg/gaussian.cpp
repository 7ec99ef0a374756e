// SPDX-License-Identifier: BSD-3-Clause
// Smoothing that takes a long time can be cancelled.
#include "../assertions.hpp"

#include <cmath>

#include "../checkpoints.hpp"
#include "linalg/gaussian.hpp"

namespace {

using stltsa::Beyond;
using stltsa::Matrix;

Matrix waves(std::int64_t rows, std::int64_t cols) {
    Matrix x(rows, cols);
    for (std::int64_t i = 0; i < rows; ++i)
        for (std::int64_t c = 0; c < cols; ++c)
            x(i, c) = std::sin(0.01 * static_cast<double>(i * (c + 1)));
    return x;
}

void check_same_bits(const Matrix& a, const Matrix& b) {
    assert_int_equal(a.rows() * a.cols(), b.rows() * b.cols());
    assert_memory_equal(a.data(), b.data(),
                        static_cast<std::size_t>(a.rows() * a.cols()) * sizeof(double));
}

void checkpoints_do_not_change_the_result(void**) {
    const Matrix x = waves(4000, 8);
    const Matrix plain = stltsa::gaussian_smoothed(x.view(), 200, Beyond::reflection);
    // 4000 rows of 1601 weights and 8 columns: 51 million products, 4 million for each checkpoint.
    assert_in_range(testing::checkpoints_of([&] {
                        check_same_bits(
                            plain, stltsa::gaussian_smoothed(x.view(), 200, Beyond::reflection));
                    }),
                    10, 20);
    Matrix in_place = waves(4000, 8);
    assert_in_range(testing::checkpoints_of(
                        [&] { stltsa::smooth_in_place(in_place, 200, Beyond::reflection); }),
                    10, 20);
    check_same_bits(in_place, plain);
}

void a_checkpoint_that_throws_ends_it(void**) {
    // Without checkpoints this takes minutes: 400 000 products for each of 16 million numbers.
    const Matrix x = waves(400'000, 40);
    assert_true(testing::ends_at(
        3, [&] { stltsa::gaussian_smoothed(x.view(), 50'000, Beyond::reflection); }));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(checkpoints_do_not_change_the_result),
        cmocka_unit_test(a_checkpoint_that_throws_ends_it),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
