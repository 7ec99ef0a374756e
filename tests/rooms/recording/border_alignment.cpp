// SPDX-License-Identifier: BSD-3-Clause
// Margins that are not at the same posture.
#include "recording/margin_alignment.hpp"

#include "recording/testing.hpp"

namespace {

using namespace recording_testing;

constexpr double half = fps / 2; ///< rows of half a cycle of a second

Signal cycles_of_a_second(double seconds) {
    return make_signal(Recorder().cycles(seconds, 1, 0).samples(0).view(), fps, 0, 0);
}

/// Margins at every half cycle from the row `first` on, each moved by up to 0.08 of a cycle.
std::vector<double> moved_margins(double first, std::size_t count) {
    std::vector<double> margins;
    for (std::size_t i = 0; i < count; ++i)
        margins.push_back(first + half * static_cast<double>(i) +
                          0.08 * fps * std::sin(2.5 * static_cast<double>(i)));
    return margins;
}

std::vector<CyclicStretch> stretch_of(std::vector<std::vector<double>> sequences) {
    CyclicStretch cut;
    cut.margins = std::move(sequences);
    return {cut};
}

std::vector<double> aligned(const Signal& signal, double begin, double end,
                            const std::vector<double>& margins) {
    auto stretches = stretch_of({margins});
    align_margins(signal, begin, end, Progress(), stretches);
    return stretches[0].margins[0];
}

double mean_of_even(const std::vector<double>& margins) {
    double sum = 0;
    for (std::size_t i = 0; i < margins.size(); i += 2)
        sum += margins[i];
    return sum / static_cast<double>((margins.size() + 1) / 2);
}

void check_cycles(const std::vector<double>& margins, double accuracy) {
    for (std::size_t i = 2; i < margins.size(); ++i)
        ASSERT_NEAR((margins[i] - margins[i - 2]) / fps, 1, accuracy);
}

void cycles_become_equal(void**) {
    const Signal signal = cycles_of_a_second(10);
    for (const std::size_t count : {5U, 6U, 13U}) {
        const std::vector<double> before = moved_margins(40, count);
        const std::vector<double> after = aligned(signal, 0, 290, before);
        check_cycles(after, 1e-3);
        ASSERT_NEAR(mean_of_even(after), mean_of_even(before), 1e-9);
    }
}

void a_margin_alone_stays(void**) {
    const std::vector<double> before = moved_margins(40, 3);
    const std::vector<double> after = aligned(cycles_of_a_second(10), 0, 290, before);
    ASSERT_NEAR(after[2] - after[0], fps, 0.01);
    assert_true(after[1] == before[1]);
}

/// Where an aligned margin would lie outside, all of its kind are shifted.
void margins_stay_inside(void**) {
    const Signal signal = cycles_of_a_second(10);
    std::vector<double> margins = moved_margins(40, 9);
    margins.front() += 3; // the others of its kind move forward, and this one back
    const double begin = margins.front() - 0.2;
    const std::vector<double> after = aligned(signal, begin, 290, margins);
    assert_true(after.front() >= begin);
    check_cycles(after, 1e-3);
}

/// Four cycles are 120 rows, one more than there are.
void a_clip_may_be_as_long_as_its_cycles(void**) {
    const Signal signal = cycles_of_a_second(4);
    std::vector<double> margins;
    for (int i = 0; i <= 8; ++i)
        margins.push_back(0.5 + 118.0 / 8 * i + (i == 4 ? 2 : 0));
    const std::vector<double> after = aligned(signal, 0, 119, margins);
    ASSERT_NEAR(after[4] - after[2], fps, 0.1);
    ASSERT_NEAR(after[6] - after[4], fps, 0.1);
    assert_true(after.front() >= 0 && after.back() <= 119);
}

void whole_cycles_stay(void**) {
    std::vector<double> margins = moved_margins(0, 9);
    margins.front() = 0;
    margins.back() = 120;
    assert_true(aligned(cycles_of_a_second(4), 0, 119, margins) == margins);
}

void what_meets_still_meets(void**) {
    const Signal signal = cycles_of_a_second(20);
    std::vector<double> first = moved_margins(40, 7), second = moved_margins(first.back(), 8);
    first.back() = second.front() += 2;
    auto stretches = stretch_of({first, second});
    align_margins(signal, 0, 590, Progress(), stretches);
    const auto& margins = stretches[0].margins;
    assert_true(margins[0].back() == margins[1].front());
    for (const auto& sequence : margins)
        assert_true(std::ranges::is_sorted(sequence));
}

/// Margins of nothing that repeats are not drawn together.
void margins_stay_in_order(void**) {
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        Matrix noise(200, 3);
        for (std::int64_t i = 0; i < noise.rows(); ++i)
            for (std::int64_t c = 0; c < noise.cols(); ++c)
                noise(i, c) = random.symmetric();
        const std::vector<double> before = moved_margins(30, 9);
        const auto after = aligned(make_signal(noise.view(), fps, 0, 0), 0, 199, before);
        for (std::size_t i = 1; i < after.size(); ++i)
            assert_true(after[i] - after[i - 1] >= 0.4 * (before[i] - before[i - 1]));
    }
}

void still_bodies_keep_their_margins(void**) {
    const Signal signal = make_signal(Matrix(100, 3).view(), fps, 0, 0);
    const std::vector<double> before = moved_margins(20, 5);
    assert_true(aligned(signal, 0, 99, before) == before);
}

/// No movement is compared around a margin at the very start of the clip.
void the_others_are_aligned_without_it(void**) {
    const double period = 0.2, cycle = period * fps;
    const Signal signal = make_signal(Recorder().cycles(3, period, 0).samples(0).view(), fps, 0, 0);
    std::vector<double> margins;
    for (int i = 0; i < 12; ++i)
        margins.push_back(1 + cycle / 2 * i + 0.2 * std::sin(2.5 * i));
    const std::vector<double> after = aligned(signal, 0, 89, margins);
    assert_true(after != margins);
    for (std::size_t i = 6; i < after.size(); ++i)
        ASSERT_NEAR((after[i] - after[i - 2]) / cycle, 1, 0.01);
}

void it_can_be_cancelled(void**) {
    const auto stop = [](void*, std::int32_t, double) { return std::int32_t{1}; };
    auto stretches = stretch_of({moved_margins(40, 9)});
    try {
        align_margins(cycles_of_a_second(10), 0, 290, Progress(stop, nullptr), stretches);
        assert_true(false);
    } catch (const stltsa::Error& error) {
        assert_true(error.status() == stltsa::Status::cancelled);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(cycles_become_equal),
        cmocka_unit_test(a_margin_alone_stays),
        cmocka_unit_test(margins_stay_inside),
        cmocka_unit_test(a_clip_may_be_as_long_as_its_cycles),
        cmocka_unit_test(whole_cycles_stay),
        cmocka_unit_test(what_meets_still_meets),
        cmocka_unit_test(margins_stay_in_order),
        cmocka_unit_test(still_bodies_keep_their_margins),
        cmocka_unit_test(the_others_are_aligned_without_it),
        cmocka_unit_test(it_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
