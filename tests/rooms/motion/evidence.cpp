// SPDX-License-Identifier: BSD-3-Clause
// The evidence required for cycles, and the reasons if it is not enough.
#include "motion/testing.hpp"

#include <string>

#include "motion/activity.hpp"
#include "motion/evidence.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;

constexpr double fps = 30;

/// Two perfect cycles of 36 samples.
Evidence sound() {
    return {{36, 0.9}, 0.95, 5, 36};
}

void check_doubt(const Evidence& evidence, std::string_view part) {
    const std::string reason = doubt(evidence, fps);
    if (reason.find(part) != reason.npos && part.empty() == reason.empty())
        return;
    print_error("expected \"%.*s\" in \"%s\"\n", static_cast<int>(part.size()), part.data(),
                reason.c_str());
    _fail(__FILE__, __LINE__);
}

void sound_cycles_are_not_doubted(void**) {
    check_doubt(sound(), "");
    Evidence just = sound();
    just.period.quality = 0.41;
    just.cyclicity = 0.66;
    just.cycle = 40;
    check_doubt(just, "");
}

void each_number_may_raise_doubt(void**) {
    Evidence evidence = sound();
    evidence.margins = 2;
    check_doubt(evidence, "less than one cycle");
    evidence = sound();
    evidence.period.quality = 0.39;
    check_doubt(evidence, "low quality");
    check_doubt(evidence, "1.20 s");
    check_doubt(evidence, "0.390");
    evidence = sound();
    evidence.cyclicity = 0.64;
    check_doubt(evidence, "low cyclicity");
    for (const double cycle : {30.0, 42.0}) {
        evidence = sound();
        evidence.cycle = cycle;
        check_doubt(evidence, "uneven length");
    }
}

void a_single_cycle_needs_more(void**) {
    Evidence evidence = sound();
    evidence.period.quality = 0.45;
    check_doubt(evidence, "");
    evidence.margins = 3;
    check_doubt(evidence, "low quality");
    evidence.period.quality = 0.51;
    check_doubt(evidence, "");
}

/// 300 samples with cycles of about 36 samples from `first` to `end`, and other movement elsewhere.
Matrix partly_cyclic(std::int64_t first, std::int64_t end) {
    return sampled(300, 10, 1, [&](double t, std::int64_t c) {
        if (t >= static_cast<double>(first) && t < static_cast<double>(end))
            return cyclic_pose(t / 36, c);
        return 3 * std::sin(0.0007 * t * t + 1.7 * static_cast<double>(c * c));
    });
}

void cycles_have_their_own_period_if_they_are_most_of_the_motion(void**) {
    const auto weighed = [](std::int64_t first, std::int64_t end, std::size_t margins) {
        const Matrix samples = partly_cyclic(first, end);
        std::vector<double> coordinate;
        for (std::int64_t i = 0; i < 300; ++i)
            coordinate.push_back(samples(i, 0));
        std::vector<double> run;
        for (std::size_t m = 0; m < margins; ++m)
            run.push_back(static_cast<double>(first + 9) + 18 * static_cast<double>(m));
        return weigh(run, samples.view(), measure_activity(samples.view(), fps), coordinate, 0.1,
                     {37, 0.2}, fps);
    };
    const Evidence most = weighed(20, 280, 13);
    ASSERT_NEAR(most.period.samples, 36, 0.2);
    assert_true(most.period.quality > 0.95 && most.cyclicity > 0.8);
    ASSERT_NEAR(most.cycle, 36, 1e-9);
    assert_int_equal(most.margins, 13);

    const Evidence little = weighed(20, 100, 4);
    assert_true(little.period.samples == 37 && little.period.quality == 0.2);
    assert_true(little.cyclicity == 0.1);
    // A single cycle cannot be compared.
    const Evidence one = weighed(20, 280, 3);
    assert_true(one.period.samples == 37);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(sound_cycles_are_not_doubted),
        cmocka_unit_test(each_number_may_raise_doubt),
        cmocka_unit_test(a_single_cycle_needs_more),
        cmocka_unit_test(cycles_have_their_own_period_if_they_are_most_of_the_motion),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
