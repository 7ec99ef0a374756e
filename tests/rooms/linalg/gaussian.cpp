// SPDX-License-Identifier: BSD-3-Clause
// Smoothing that takes a long time can be cancelled.
#include "../assertions.hpp"

#include <cmath>

#include "../cancelling.hpp"
#include "base/error.hpp"
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

void polls_do_not_change_the_result(void**) {
    const Matrix x = waves(4000, 8);
    int polls = 0;
    const auto poll = [&] { ++polls; };
    const Matrix plain = stltsa::gaussian_smoothed(x.view(), 200, Beyond::reflection);
    const Matrix polled = stltsa::gaussian_smoothed(x.view(), 200, Beyond::reflection, 1, poll);
    check_same_bits(plain, polled);
    // 4000 rows of 1601 weights and 8 columns: 51 million products, 4 million for each poll.
    assert_in_range(polls, 10, 20);
    polls = 0;
    Matrix in_place = waves(4000, 8);
    stltsa::smooth_in_place(in_place, 200, Beyond::reflection, poll);
    check_same_bits(in_place, plain);
    assert_in_range(polls, 10, 20);
}

void a_poll_that_throws_ends_it(void**) {
    // Without a poll this takes minutes: 400 000 products for each of 16 million numbers.
    const Matrix x = waves(400'000, 40);
    int polls = 0;
    const auto stop = [&] {
        if (++polls == 3)
            stltsa::fail(stltsa::Status::cancelled, "enough");
    };
    assert_true(testing::is_cancelled(
        [&] { stltsa::gaussian_smoothed(x.view(), 50'000, Beyond::reflection, 1, stop); }));
    assert_int_equal(polls, 3);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(polls_do_not_change_the_result),
        cmocka_unit_test(a_poll_that_throws_ends_it),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
