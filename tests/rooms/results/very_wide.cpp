// SPDX-License-Identifier: BSD-3-Clause
// Clips with very many columns: no pass over the samples is too long to be cancelled.
#include <cmath>
#include <numbers>
#include <optional>

#include "../assertions.hpp"
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
/// Numbers between two polls, see PacedPoll.
constexpr std::int64_t between_polls = 1 << 22;

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

/// Checks that work(progress, poll) polls at least as often as its passes over the samples require.
template <class Work>
void check_polls(double passes, const Work& work) {
    int polls = 0;
    const auto count = [](void* user, std::int32_t, double) {
        ++*static_cast<int*>(user);
        return std::int32_t{0};
    };
    const Progress progress(count, &polls);
    work(progress, [&] { ++polls; });
    assert_in_range(polls, static_cast<int>(passes * (rows * cols / between_polls)), 1000000);
}

void the_search_for_a_period_polls(void**) {
    check_polls(3, [&](const Progress& progress, auto) {
        motion::find_period(wide().view(), 30, {}, progress);
    });
}

void features_poll(void**) {
    clip::Clip clip;
    clip.values = copied(wide().view());
    check_polls(3, [&](auto, const auto& poll) {
        clip::feature_rows(clip, {}, {}, clip::GapRule::fill, poll);
    });
}

void choices_poll(void**) {
    check_polls(20, [&](const Progress& progress, auto) {
        results::telling_postures(wide().view(), progress);
    });
    check_polls(1, [&](auto, const auto& poll) { column_means(wide().view(), poll); });
}

/// All frames are one block of the loop.
void the_search_for_neighbors_polls(void**) {
    ltsa::Parameters parameters;
    parameters.neighbors = parameters.window = 5;
    parameters.threads = 2;
    const std::int64_t length = rows;
    check_polls(5, [&](const Progress& progress, auto) {
        ltsa::temporal_neighbors(wide().view(), {&length, 1}, parameters, progress);
    });
}

void the_phase_polls(void**) {
    motion::Run run{0, {}};
    for (std::int64_t i = 0; i < rows; ++i)
        run.phase.push_back(static_cast<double>(i) / period);
    check_polls(3, [&](auto, const auto& poll) {
        motion::pose_and_velocity(wide().view(), 30, period, poll);
    });
    check_polls(6, [&](auto, const auto& poll) {
        motion::fit_loop(wide().view(), {&run, 1}, 3, poll);
    });
    motion::MeanCycle mean;
    check_polls(4 * 2 * 6, [&](auto, const auto& poll) {
        mean =
            motion::register_runs(wide().view(), {run}, period, motion::smooth_share, 0, poll).mean;
    });
    check_polls(6,
                [&](auto, const auto& poll) { motion::residuals(wide().view(), mean, run, poll); });
    const motion::Run middle{10, {run.phase.begin() + 10, run.phase.begin() + 30}};
    check_polls(6, [&](auto, const auto& poll) {
        motion::grown(wide().view(), mean, middle, {0, rows}, poll);
    });
}

void events_poll(void**) {
    check_polls(22,
                [&](auto, const auto& poll) { phase::FineRows(wide().view(), 60, period, poll); });
    const phase::Borders borders = {2, 12, 22, 32, 42};
    const phase::Phases phases = phase::find_phases(wide().view(), 30, {&borders, 1}, {});
    const Matrix both = motion::pose_and_velocity(wide().view(), 30, period);
    std::optional<phase::Searched> in;
    check_polls(26, [&](auto, const auto& poll) {
        in = phase::searched(wide().view(), both.view(), 30, phases, phases.runs, poll);
    });
    const auto places = phase::places_of(*in, {phase::mark_at(*in, 17).value()});
    check_polls(70, [&](auto, const auto& poll) {
        in->poll = poll;
        phase::find_events(*in, places[0]);
    });
    check_polls(759, [&](auto, const auto& poll) {
        in->poll = poll;
        phase::find_events(*in, places[0], *in);
    });
}

void comparisons_poll(void**) {
    phase::Resampled cycles;
    check_polls(27, [&](auto, const auto& poll) {
        cycles =
            phase::resample(wide().view(), {phase::times_between({2, 12, 22, 32}, rows), {}}, poll);
    });
    const std::vector<std::int64_t> groups(cols, 0);
    check_polls(
        370, [&](auto, const auto& poll) { phase::compare(cycles, cycles, groups, false, poll); });
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_search_for_a_period_polls),
        cmocka_unit_test(features_poll),
        cmocka_unit_test(choices_poll),
        cmocka_unit_test(the_search_for_neighbors_polls),
        cmocka_unit_test(the_phase_polls),
        cmocka_unit_test(events_poll),
        cmocka_unit_test(comparisons_poll),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
