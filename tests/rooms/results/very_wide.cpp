// SPDX-License-Identifier: BSD-3-Clause
// Clips with very many columns: no pass over the samples is too long to be cancelled.
#include <cmath>
#include <numbers>
#include <optional>

#include "../assertions.hpp"
#include "../checkpoints.hpp"
#include "clip/features/features.hpp"
#include "linalg/principal.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/parameters.hpp"
#include "motion/cycles/registration.hpp"
#include "motion/period/period.hpp"
#include "phase/compare.hpp"
#include "phase/events.hpp"
#include "phase/fine.hpp"
#include "phase/phases.hpp"
#include "phase/resample.hpp"
#include "results/postures.hpp"

namespace {

using namespace stltsa;

constexpr std::int64_t rows = 64, cols = 1 << 17;
constexpr double period = 10;
/// Numbers between two checkpoints, see checkpoint().
constexpr std::int64_t between_checks = 1 << 22;

const Matrix& wide() {
    static const Matrix samples = [] {
        Matrix x(rows, cols);
        for (std::int64_t i = 0; i < rows; ++i)
            for (std::int64_t c = 0; c < cols; ++c)
                x(i, c) = std::sin(2 * std::numbers::pi * static_cast<double>(i) / period +
                                   static_cast<double>(c % 7));
        return x;
    }();
    return samples;
}

/// Checks that the work has at least as many checkpoints as its passes over the samples require.
template <class Work>
void check(double passes, const Work& work) {
    assert_in_range(testing::checkpoints_of(work),
                    static_cast<int>(passes * (rows * cols / between_checks)), 1000000);
}

void the_search_for_a_period_can_be_cancelled(void**) {
    check(3, [&] { motion::find_period(wide().view(), 30, {}); });
}

void features_can_be_cancelled(void**) {
    clip::Clip clip;
    clip.values = copied(wide().view());
    check(3, [&] { clip::feature_rows(clip, {}, {}); });
}

void choices_can_be_cancelled(void**) {
    check(20, [&] { results::telling_postures(wide().view()); });
    check(1, [&] { column_means(wide().view()); });
}

/// All frames are one block of the loop.
void the_search_for_neighbors_can_be_cancelled(void**) {
    ltsa::Parameters parameters;
    parameters.neighbors = parameters.window = 5;
    parameters.threads = 2;
    const std::int64_t length = rows;
    check(5, [&] { ltsa::temporal_neighbors(wide().view(), {&length, 1}, parameters); });
}

void the_phase_can_be_cancelled(void**) {
    motion::Run run{0, {}};
    for (std::int64_t i = 0; i < rows; ++i)
        run.phase.push_back(static_cast<double>(i) / period);
    check(3, [&] { motion::pose_and_velocity(wide().view(), 30, period); });
    check(6, [&] { motion::fit_loop(wide().view(), {&run, 1}, 3); });
    motion::MeanCycle mean;
    check(4 * 2 * 6, [&] { mean = motion::register_runs(wide().view(), {run}, period).mean; });
    check(6, [&] { motion::residuals(wide().view(), mean, run); });
    const motion::Run middle{10, {run.phase.begin() + 10, run.phase.begin() + 30}};
    check(6, [&] { motion::grown(wide().view(), mean, middle, {0, rows}); });
}

void events_can_be_cancelled(void**) {
    check(22, [&] { phase::FineRows(wide().view(), 60, period); });
    const phase::Borders borders = {2, 12, 22, 32, 42};
    const phase::Phases phases = phase::find_phases(wide().view(), 30, {&borders, 1}, {});
    const Matrix both = motion::pose_and_velocity(wide().view(), 30, period);
    std::optional<phase::Searched> in;
    check(26, [&] { in = phase::searched(wide().view(), both.view(), 30, phases, phases.runs); });
    const auto places = phase::places_of(*in, {phase::mark_at(*in, 17).value()});
    check(60, [&] { phase::find_events(*in, places[0]); });
    check(740, [&] { phase::find_events(*in, places[0], *in); });
}

void comparisons_can_be_cancelled(void**) {
    phase::Resampled cycles;
    check(27, [&] {
        cycles = phase::resample(wide().view(), {phase::times_between({2, 12, 22, 32}, rows), {}});
    });
    const std::vector<std::int64_t> groups(cols, 0);
    check(370, [&] { phase::compare(cycles, cycles, groups, false); });
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_search_for_a_period_can_be_cancelled),
        cmocka_unit_test(features_can_be_cancelled),
        cmocka_unit_test(choices_can_be_cancelled),
        cmocka_unit_test(the_search_for_neighbors_can_be_cancelled),
        cmocka_unit_test(the_phase_can_be_cancelled),
        cmocka_unit_test(events_can_be_cancelled),
        cmocka_unit_test(comparisons_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
