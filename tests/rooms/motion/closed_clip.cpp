// SPDX-License-Identifier: BSD-3-Clause
// Clips that are played in a loop.
#include "motion/cycles/closed_clip.hpp"

#include "recordings.hpp"

namespace {

using namespace motion_testing;

constexpr std::int64_t rows = 33;

/// Rows of a motion with this period in rows, from `first` on.
Signal played(std::int64_t count, double period = rows, double first = 0) {
    Matrix x(count, columns);
    for (std::int64_t i = 0; i < count; ++i) {
        const double phase = 2 * std::numbers::pi * (static_cast<double>(i) + first) / period;
        x(i, 0) = 1 - std::cos(phase);
        x(i, 1) = std::sin(phase);
        x(i, 2) = 0.3 * std::sin(2 * phase + 1);
    }
    return make_signal(x.view(), fps, 0, 0);
}

std::optional<CyclicStretch> closed(const Signal& signal, const PeriodRange& periods = {}) {
    return closed_cycle(signal, periods);
}

/// It does not matter where in the cycle the clip begins.
void one_cycle_is_the_whole_clip(void**) {
    for (const double first : {0.0, 5.0, 11.3, 20.0}) {
        const auto found = closed(played(rows, rows, first));
        assert_true(found && found->claimed());
        assert_true((found->borders == std::vector<double>{0, rows}));
        assert_int_equal(found->confidences.size(), 1);
        const auto& phase = found->growth.run.phase;
        assert_int_equal(phase.size(), rows);
        for (std::size_t i = 1; i < phase.size(); ++i)
            ASSERT_NEAR(phase[i] - phase[0], static_cast<double>(i) / rows, 0.02);
        assert_true(found->phase.curve.size() > 1);
    }
}

/// The last row may also be the first one again.
void the_first_row_may_be_repeated(void**) {
    assert_true(closed(played(rows + 1)).has_value());
}

void a_part_of_a_cycle_is_open(void**) {
    for (const std::int64_t count : {16, 22, 29, 38, 45})
        assert_false(closed(played(count)).has_value());
}

/// From rest to rest: the posture comes back, but not the motion.
void an_action_is_not_closed(void**) {
    const Signal action =
        make_signal(Recorder().rest(0.1).action(1.2, 0).rest(0.1).samples(0).view(), fps, 0, 0);
    assert_false(closed(action).has_value());
    const Signal still = make_signal(Matrix(rows, columns).view(), fps, 0, 0);
    assert_false(closed(still).has_value());
}

void its_length_must_be_a_period_that_is_searched(void**) {
    assert_false(closed(played(rows), {0.3, 1}).has_value());
    assert_false(closed(played(rows), {1.2, 6}).has_value());
    assert_true(closed(played(rows), {1, 1.2}).has_value());
    assert_false(closed(played(8, 8)).has_value()); // too few rows
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(one_cycle_is_the_whole_clip),
        cmocka_unit_test(the_first_row_may_be_repeated),
        cmocka_unit_test(a_part_of_a_cycle_is_open),
        cmocka_unit_test(an_action_is_not_closed),
        cmocka_unit_test(its_length_must_be_a_period_that_is_searched),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
