// SPDX-License-Identifier: BSD-3-Clause
// Rows in random order are told from frames of a motion.
#include "ltsa/testing.hpp"
#include "ltsa/warnings.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::ltsa::share_in_order;

double share(const Matrix& x, std::vector<std::int64_t> lengths = {}) {
    stltsa::ltsa::DistinctFrames frames;
    frames.x = x.view();
    frames.lengths = lengths.empty() ? std::vector{x.rows()} : std::move(lengths);
    return share_in_order(frames);
}

/// The rows in random order.
Matrix shuffled(Matrix x) {
    stltsa::Random random(9);
    for (std::int64_t i = x.rows() - 1; i > 0; --i) {
        const auto j =
            static_cast<std::int64_t>((random.symmetric() + 1) / 2 * static_cast<double>(i + 1));
        std::swap_ranges(x.row(i), x.row(i) + x.cols(), x.row(j));
    }
    return x;
}

void motion_has_an_order(void**) {
    for (const std::int64_t rows : {300, 1000, 6000}) {
        assert_true(share(cyclic(rows, 12)) > 0.9);
        assert_true(share(shuffled(cyclic(rows, 12))) < 0.58);
        assert_true(share(noise(rows, 3)) < 0.58);
    }
}

void few_rows_show_nothing(void**) {
    assert_true(share(noise(49, 3)) == 1);
    assert_true(share(noise(50, 3)) < 1);
}

/// One motion in order, cut into clips that follow in random order: only their rows count.
void clips_may_come_in_any_order(void**) {
    constexpr std::int64_t clips = 60, length = 4;
    Matrix x = cyclic(clips * length, 12);
    Matrix order = shuffled([&] {
        Matrix number(clips, 1);
        for (std::int64_t i = 0; i < clips; ++i)
            number(i, 0) = static_cast<double>(i);
        return number;
    }());
    Matrix mixed(x.rows(), x.cols());
    for (std::int64_t i = 0; i < x.rows(); ++i)
        std::copy_n(x.row(static_cast<std::int64_t>(order(i / length, 0)) * length + i % length),
                    x.cols(), mixed.row(i));
    assert_true(share(mixed) < 0.9);
    assert_true(share(mixed, std::vector<std::int64_t>(clips, length)) > 0.9);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(motion_has_an_order),
        cmocka_unit_test(few_rows_show_nothing),
        cmocka_unit_test(clips_may_come_in_any_order),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
