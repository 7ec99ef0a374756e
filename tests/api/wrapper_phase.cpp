// SPDX-License-Identifier: BSD-3-Clause
// stltsa.hpp: phases and signals on 0 to 100 % of the cycles.
#include <algorithm>
#include <cmath>

#include <stltsa.hpp>

#include "../rooms/assertions.hpp"

namespace {

std::string walker_path; // set by main()

void frames_have_phases(void**) {
    const stltsa::Clip clip = stltsa::Clip::open(walker_path);
    const stltsa::Decomposition found = stltsa::decompose(clip);
    const stltsa::Phase phase = stltsa::find_phase(found);
    const std::vector<double> values = phase.values(), residuals = phase.residuals();
    const std::vector<std::int64_t> cycle = phase.cycles();
    assert_int_equal(values.size(), clip.frames());
    const auto middle = static_cast<std::size_t>(found.cycles()[1].begin + 3);
    assert_int_equal(cycle[middle], 1);
    assert_true(residuals[middle] > 0 && residuals[middle] < 0.5);
    assert_true(std::isnan(values[0]) && cycle[0] == -1);
    assert_true(phase.warnings().empty());

    const stltsa::Matrix features = clip.features();
    const stltsa::Cycles cycles = phase.resample(0, features, 51);
    assert_non_null(cycles.get());
    assert_int_equal(cycles.count(), found.cycles().size());
    const stltsa::Matrix mean = cycles.mean(), first = cycles.cycle(0);
    assert_int_equal(mean.rows, 51);
    assert_int_equal(mean.cols, features.cols);
    assert_true(std::isfinite(cycles.deviation()(25, 0)));
    assert_true(std::isfinite(first(25, 0)));
    assert_true(cycles.frames()(1, 25) > cycles.frames()(0, 25));
    assert_true(std::abs(cycles.warp()(1, 25)) < 0.1);
    assert_true(cycles.distance()[1] < 0.5);
    const stltsa::Matrix columns = cycles.column_distance();
    assert_int_equal(columns.cols, features.cols);
    assert_true(phase.zeros().at(0) > 0 && phase.zeros()[0] < 1);
    const std::vector<std::string> owners = phase.column_owners();
    assert_int_equal(owners.size(), features.cols);
    std::vector<std::int64_t> groups(owners.size(), -1);
    groups[3] = groups[4] = groups[5] = 0;
    assert_true(owners[3] == owners[5] && owners[3] != owners[6]);
    const stltsa::Matrix joint = cycles.group_distance(groups);
    assert_int_equal(joint.cols, 1);
    std::vector<std::string> names(owners.size());
    names[3] = "knee_l";
    names[4] = "knee_r";
    const stltsa::Comparison knees = cycles.compare_left_right(names);
    assert_string_equal(knees.parts().at(0).second, "knee_r");
    assert_int_equal(knees.channels().size(), 1);
    assert_int_equal(stltsa::side_of_name("LHS"), STLTSA_SIDE_LEFT);
    ASSERT_NEAR(joint(1, 0), std::hypot(columns(1, 3), columns(1, 4), columns(1, 5)), 1e-12);
}

void motions_are_compared(void**) {
    const stltsa::Clip clip = stltsa::Clip::open(walker_path);
    const stltsa::Phase phase = stltsa::find_phase(stltsa::decompose(clip));
    const stltsa::Clip part = clip.stretch("170-600");
    const stltsa::Phase other = stltsa::find_phase(stltsa::decompose(part));
    const stltsa::Comparison of = phase.compare(other, 0, -1, 51);
    assert_non_null(of.get());
    assert_true(of.whole().likeness > 0.99 && of.whole().samples == 51);
    assert_int_equal(of.motion(0).cycles, 3);
    assert_true(of.motion(1).cycles >= 2);
    const std::vector<stltsa::ComparedPart> parts = of.parts(), channels = of.channels();
    assert_int_equal(channels.size(), 3 * parts.size());
    assert_string_equal(parts[0].first, parts[0].second);
    assert_string_equal(channels[1].axis, "y");
    assert_int_equal(channels[4].part, 1);
    assert_int_equal(parts[1].part, 1);
    const stltsa::Matrix first = of.mean(0), second = of.mean(1), difference = of.difference();
    assert_true(difference.rows == 51 &&
                difference.cols == static_cast<std::int64_t>(channels.size()));
    assert_true(difference(7, 4) == second(7, 4) - first(7, 4));
    assert_true(of.deviation(0)(7, 4) >= 0);
    assert_true(of.margin()(7, 4) >= of.standard_error()(7, 4));
    assert_null(*of.motion(0).left_out);
    assert_true(of.json().starts_with("{\"format\":\"stltsa-comparison/1\""));
    const stltsa::Comparison sides = phase.compare_left_right(clip);
    assert_string_equal(sides.parts().at(0).second, "RightArm");
    assert_true(sides.warnings().size() <= 1);
}

void a_mark_is_found_in_every_cycle(void**) {
    const stltsa::Clip clip = stltsa::Clip::open(walker_path);
    const stltsa::Decomposition found = stltsa::decompose(clip);
    const stltsa::Phase phase = stltsa::find_phase(found);
    const stltsa::Events events = phase.events({250});
    assert_non_null(events.get());
    const std::vector<stltsa::Event> all = events.all();
    assert_int_equal(all.size(), events.info().count(STLTSA_INFO_EVENT));
    ASSERT_NEAR(all.back().seconds, all.back().frame / 120, 1e-12);
    const auto marked = std::ranges::find(all, 1, &stltsa::Event::marked);
    assert_true(marked != all.end() && marked->frame == 250);
    ASSERT_NEAR(events.likeness(), 1, 0);
    assert_true(events.warnings().empty());
    assert_int_equal(phase.events({250, 316}).warnings().size(), 1);
    const stltsa::Clip part = clip.stretch("170-600");
    const stltsa::Phase other = stltsa::find_phase(stltsa::decompose(part));
    assert_true(phase.events({250}, other).likeness() > 0.99);
}

void a_stream_is_followed(void**) {
    const stltsa::Clip clip = stltsa::Clip::open(walker_path);
    stltsa::Model model = stltsa::fit(clip);
    assert_false(model.has_cycle());
    const stltsa::Phase phase = stltsa::find_phase(stltsa::decompose(clip));
    stltsa::keep_cycle(model, phase);
    stltsa::keep_mark(model, phase, 250, "strike");
    stltsa::Live live(model);
    assert_non_null(live.get());
    assert_true(live.marks() == std::vector<std::string>{"strike"});
    const stltsa::Matrix features = clip.features();
    stltsa::LiveFrame frame{};
    for (std::int64_t i = 270; i <= 300; ++i) {
        const auto begin = features.values.begin() + i * features.cols;
        const std::vector<double> row(begin, begin + features.cols);
        frame = live.push(static_cast<double>(i) / 120, stltsa::MatrixView(row, features.cols));
    }
    ASSERT_NEAR(std::remainder(frame.phase - phase.values()[300], 1.0), 0, 0.05);
    stltsa::Live of_frames(model), of_poses(model);
    const stltsa::Matrix turns = clip.rotations();
    for (std::int64_t i = 270; i <= 300; ++i) {
        const double seconds = static_cast<double>(i) / 120;
        frame = of_frames.push(seconds, clip, i);
        const stltsa::LiveFrame of_pose = of_poses.push_pose(seconds, STLTSA_ROTATIONS_QUATERNION,
                                                             stltsa::MatrixView(turns.row(i), 4));
        ASSERT_NEAR(of_pose.phase, frame.phase, 1e-6);
    }
    ASSERT_NEAR(std::remainder(frame.phase - phase.values()[300], 1.0), 0, 0.05);
    const std::vector<double> root = {0, 90, 0};
    of_poses.push_pose(3, STLTSA_ROTATIONS_QUATERNION, stltsa::MatrixView(turns.row(301), 4),
                       stltsa::MatrixView(root, 3));
    const std::vector<double> points = {0, 0, 1, 1, 0, 0}, sure = {1, 0};
    const auto refused = [&](const auto& push) {
        try {
            push();
        } catch (const stltsa::Error& error) {
            return error.status() == STLTSA_E_UNSUPPORTED;
        }
        return false;
    };
    assert_true(refused([&] { of_poses.push_points(4, stltsa::MatrixView(points, 3)); }));
    assert_true(refused([&] {
        of_poses.push_points(4, stltsa::MatrixView(points, 3), stltsa::MatrixView(sure, 1));
    }));
}

void borders_may_be_given(void**) {
    const std::vector<double> ramp = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    const stltsa::Cycles cycles = stltsa::cycles_between({0, 4, 8}, stltsa::MatrixView(ramp, 1), 5);
    ASSERT_NEAR(cycles.mean()(1, 0), 3, 1e-12);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const CMUnitTest tests[] = {
        cmocka_unit_test(frames_have_phases),
        cmocka_unit_test(motions_are_compared),
        cmocka_unit_test(a_mark_is_found_in_every_cycle),
        cmocka_unit_test(a_stream_is_followed),
        cmocka_unit_test(borders_may_be_given),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
