// SPDX-License-Identifier: BSD-3-Clause
// What is done to segments after they are found: divided at holes, joined, merged, and completed by
// repetitions that no pause separates from their neighbors.
#include "recordings.hpp"

#include "motion/behaviors/kernel_features.hpp"
#include "motion/recording/drafts.hpp"
#include "motion/recording/holes.hpp"
#include "motion/recording/merging.hpp"
#include "motion/recording/repetition_ends.hpp"

namespace {

using namespace motion_testing;

Draft draft(SegmentKind kind, double begin, double end, int label = -1) {
    Draft made;
    made.kind = kind;
    made.begin = begin;
    made.end = end;
    made.label = label;
    return made;
}

/// A stretch with one cycle.
CyclicStretch stretch(double begin, double end) {
    CyclicStretch cut;
    cut.borders = {begin, end};
    return cut;
}

void check_range(const Draft& found, SegmentKind kind, double begin, double end) {
    assert_int_equal(static_cast<int>(found.kind), static_cast<int>(kind));
    ASSERT_NEAR(found.begin, begin, 0);
    ASSERT_NEAR(found.end, end, 0);
}

void check_hole(const Draft& found, double begin, double end) {
    check_range(found, SegmentKind::rest, begin, end);
    assert_true(found.is_hole && found.reason == "nothing recorded" && found.label < 0);
}

void a_hole_says_that_nothing_was_recorded(void**) {
    const auto action = SegmentKind::action, rest = SegmentKind::rest;
    std::vector<Draft> drafts{draft(action, 0, 100), draft(rest, 100, 120),
                              draft(action, 120, 200)};
    divide_at_holes({{102, 116.5}}, fps, drafts);
    assert_int_equal(drafts.size(), 3);
    check_range(drafts[0], action, 0, 102);
    check_hole(drafts[1], 102, 116.5);
    check_range(drafts[2], action, 116.5, 200);
    // At the ends; a hole beyond all drafts changes nothing.
    drafts = {draft(rest, 0, 20), draft(action, 20, 100), draft(rest, 100, 120)};
    divide_at_holes({{0, 18}, {102, 120}, {300, 320}}, fps, drafts);
    assert_int_equal(drafts.size(), 3);
    check_hole(drafts[0], 0, 18);
    check_range(drafts[1], action, 18, 102);
    check_hole(drafts[2], 102, 120);
    // A rest that is half a second longer than the hole is one, before and after it.
    drafts = {draft(action, 0, 100), draft(rest, 100, 135), draft(action, 135, 200)};
    divide_at_holes({{110, 120}}, fps, drafts);
    assert_int_equal(drafts.size(), 5);
    check_range(drafts[1], rest, 100, 110);
    check_hole(drafts[2], 110, 120);
    check_range(drafts[3], rest, 120, 135);
    // Two holes close together, in one rest.
    drafts = {draft(action, 0, 100), draft(rest, 100, 125), draft(action, 125, 200)};
    divide_at_holes({{100, 110}, {114, 124}}, fps, drafts);
    assert_int_equal(drafts.size(), 5);
    check_hole(drafts[1], 100, 110);
    check_range(drafts[2], rest, 110, 114);
    check_hole(drafts[3], 114, 124);
    check_range(drafts[4], action, 124, 200);
    // The last cycle may end just within it.
    drafts = {draft(SegmentKind::cyclic, 0, 200)};
    drafts[0].stretches = {stretch(10, 90.5)};
    divide_at_holes({{90, 120}}, fps, drafts);
    assert_int_equal(drafts.size(), 3);
    check_range(drafts[0], SegmentKind::cyclic, 0, 90.5);
    check_hole(drafts[1], 90.5, 120);
}

/// Where a clip was cut, nothing is missing.
void a_rest_at_a_cut_becomes_a_border(void**) {
    const auto action = SegmentKind::action, rest = SegmentKind::rest;
    std::vector<Draft> drafts{draft(action, 0, 100), draft(rest, 100, 108),
                              draft(action, 108, 200)};
    divide_at_holes({{103, 103}, {150, 150}}, fps, drafts);
    assert_int_equal(drafts.size(), 3);
    check_range(drafts[0], action, 0, 103);
    check_range(drafts[1], action, 103, 150);
    check_range(drafts[2], action, 150, 200);
}

void no_motion_continues_over_a_hole(void**) {
    const auto cyclic = SegmentKind::cyclic, action = SegmentKind::action;
    std::vector<Draft> drafts{draft(cyclic, 0, 200)};
    drafts[0].gain = 7;
    drafts[0].stretches = {stretch(10, 50), stretch(50, 80), stretch(110, 150)};
    divide_at_holes({{90, 100}, {170, 180}}, fps, drafts);
    assert_int_equal(drafts.size(), 5);
    check_range(drafts[0], cyclic, 0, 90);
    assert_int_equal(drafts[0].stretches.size(), 2);
    ASSERT_NEAR(drafts[0].gain, 7, 0);
    check_hole(drafts[1], 90, 100);
    check_range(drafts[2], cyclic, 100, 170);
    assert_int_equal(drafts[2].stretches.size(), 1);
    ASSERT_NEAR(drafts[2].stretches[0].borders.front(), 110, 0);
    ASSERT_NEAR(drafts[2].gain, 0, 0);
    // What follows has no cycle any more.
    check_range(drafts[4], action, 180, 200);
    assert_true((drafts[4].motions == std::vector<Rows>{{175, 200}}));

    drafts = {draft(SegmentKind::repetitions, 0, 90)};
    drafts[0].motions = {{0, 20}, {25, 40}, {60, 90}};
    divide_at_holes({{45, 55}}, fps, drafts);
    assert_int_equal(drafts.size(), 3);
    check_range(drafts[0], SegmentKind::repetitions, 0, 45);
    assert_int_equal(drafts[0].motions.size(), 2);
    // One repetition is none.
    check_range(drafts[2], action, 55, 90);
    assert_true((drafts[2].motions == std::vector<Rows>{{60, 90}}));
}

void neighbors_of_one_label_are_joined(void**) {
    const auto cyclic = SegmentKind::cyclic, repetitions = SegmentKind::repetitions;
    std::vector<Draft> drafts{draft(cyclic, 0, 50, 0),
                              draft(cyclic, 50, 90, 0),
                              draft(cyclic, 90, 120, 1),
                              draft(SegmentKind::action, 120, 150, 1),
                              draft(repetitions, 150, 180, 2),
                              draft(repetitions, 180, 200, 2),
                              draft(SegmentKind::rest, 200, 220),
                              draft(SegmentKind::rest, 220, 240)};
    drafts[0].stretches = {stretch(5, 45)};
    drafts[0].best_match = 0.4;
    drafts[1].stretches = {stretch(55, 85)};
    drafts[1].best_match = 0.9;
    join_neighbors(drafts);
    assert_int_equal(drafts.size(), 7);
    check_range(drafts[0], cyclic, 0, 90);
    assert_int_equal(drafts[0].stretches.size(), 2);
    ASSERT_NEAR(drafts[0].best_match, 0.9, 0);
    // Another label, another kind, repetitions and rests remain what they are.
    check_range(drafts[1], cyclic, 90, 120);
    check_range(drafts[3], repetitions, 150, 180);
    check_range(drafts[5], SegmentKind::rest, 200, 220);
}

/// An action, two of another motion, and cycles; rests of one second between them.
struct Merging {
    const Matrix samples = Recorder()
                               .action(4, 3)
                               .rest(1)
                               .action(4, 0)
                               .rest(1)
                               .action(4, 0)
                               .rest(1)
                               .cycles(8, 1, 6)
                               .samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    const KernelFeatures features{signal};

    std::vector<Draft> drafts() const {
        std::vector<Draft> made;
        for (int i = 0; i < 3; ++i) {
            const int begin = 150 * i;
            made.push_back(draft(SegmentKind::action, begin, begin + 120));
            made.back().motions = {{begin, begin + 120}};
            made.back().group = i > 0;
            made.push_back(draft(SegmentKind::rest, begin + 120, begin + 150));
        }
        made.push_back(draft(SegmentKind::cyclic, 450, static_cast<double>(signal.rows())));
        made.back().stretches = {stretch(460, 490)};
        return made;
    }
};

void the_most_alike_are_merged_first(void**) {
    const Merging made;
    std::vector<Draft> drafts = made.drafts();
    assert_int_equal(moving(drafts), 4);
    merge_to(made.features, 4, drafts);
    assert_int_equal(drafts.size(), 7);
    // One motion twice is a repetition; the rest between is within it.
    merge_to(made.features, 3, drafts);
    assert_int_equal(moving(drafts), 3);
    check_range(drafts[0], SegmentKind::action, 0, 120);
    check_range(drafts[2], SegmentKind::repetitions, 150, 420);
    assert_true((drafts[2].motions == std::vector<Rows>{{150, 270}, {300, 420}}));
    // All at once: the cycles are what is known of it.
    merge_to(made.features, 1, drafts);
    assert_int_equal(drafts.size(), 1);
    check_range(drafts[0], SegmentKind::cyclic, 0, static_cast<double>(made.signal.rows()));
    assert_int_equal(drafts[0].cycles().size(), 1);
}

void two_motions_merge_to_one_action(void**) {
    const Merging made;
    std::vector<Draft> drafts = made.drafts();
    drafts.resize(3);
    drafts[0].known_motion = true;
    merge_to(made.features, 1, drafts);
    assert_int_equal(drafts.size(), 1);
    check_range(drafts[0], SegmentKind::action, 0, 270);
    assert_true((drafts[0].motions == std::vector<Rows>{{0, 270}}));
    assert_int_equal(drafts[0].group, -1);
    assert_false(drafts[0].known_motion);
}

/// Three times one action with pauses, of which the first or last has no pause beside a walk.
void the_outer_repetition_is_taken_from_its_neighbor(void**) {
    const auto rest = SegmentKind::rest, repetitions = SegmentKind::repetitions;
    const Matrix samples =
        Recorder().cycles(5, 1, 5).action(2, 0).rest(1).action(2, 0).rest(1).action(2, 0).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    std::vector<Draft> drafts{draft(SegmentKind::cyclic, 0, 210), draft(rest, 210, 240),
                              draft(repetitions, 240, 390)};
    drafts[0].stretches = {stretch(60, 90)};
    drafts[2].motions = {{240, 300}, {330, 390}};
    drafts[2].group = 0;
    const std::vector<Draft> given = drafts;
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 2);
    assert_int_equal(drafts[1].motions.size(), 3);
    ASSERT_NEAR(drafts[0].end, 150, 8);
    ASSERT_NEAR(drafts[1].begin, drafts[0].end, 0);
    ASSERT_NEAR(drafts[1].end, 390, 0);
    ASSERT_NEAR(drafts[1].gain, 1, 0);

    // After a long pause, or beside the same motion, nothing is taken.
    drafts = given;
    drafts[0].group = 0;
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 3);
    drafts = given;
    drafts[1].begin = 100;
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 3);

    // Nor is a cycle.
    drafts = given;
    drafts[0].stretches[0].borders = {60, 90, 180};
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 3);
}

void the_last_repetition_is_taken_from_what_follows(void**) {
    const auto rest = SegmentKind::rest, repetitions = SegmentKind::repetitions;
    const Matrix samples =
        Recorder().action(2, 0).rest(1).action(2, 0).rest(1).action(2, 0).action(4, 4).samples();
    const Signal signal = make_signal(samples.view(), fps, 0, 0);
    std::vector<Draft> drafts{draft(repetitions, 0, 150), draft(rest, 150, 180),
                              draft(SegmentKind::action, 180, 360)};
    drafts[0].motions = {{0, 60}, {90, 150}};
    drafts[0].group = 0;
    drafts[2].group = 1;
    drafts[2].motions = {{180, 360}};
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 2);
    assert_int_equal(drafts[0].motions.size(), 3);
    assert_int_equal(drafts[0].motions[2].begin, 180);
    ASSERT_NEAR(drafts[0].end, 240, 8);
    check_range(drafts[1], SegmentKind::action, drafts[0].end, 360);
    assert_true((drafts[1].motions == std::vector<Rows>{drafts[1].rows()}));
    ASSERT_NEAR(drafts[1].gain, 1, 0);

    // Cycles are not taken.
    drafts = {draft(repetitions, 0, 150), draft(rest, 150, 180),
              draft(SegmentKind::cyclic, 180, 360)};
    drafts[0].motions = {{0, 60}, {90, 150}};
    drafts[0].group = 0;
    drafts[2].stretches = {stretch(200, 300)};
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 3);

    // A motion unlike the repetitions is left alone.
    drafts = {draft(repetitions, 0, 150), draft(rest, 150, 180),
              draft(SegmentKind::action, 240, 360)};
    drafts[0].motions = {{0, 60}, {90, 150}};
    drafts[0].group = 0;
    find_end_repetitions(signal, drafts);
    assert_int_equal(drafts.size(), 3);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_hole_says_that_nothing_was_recorded),
        cmocka_unit_test(a_rest_at_a_cut_becomes_a_border),
        cmocka_unit_test(no_motion_continues_over_a_hole),
        cmocka_unit_test(neighbors_of_one_label_are_joined),
        cmocka_unit_test(the_most_alike_are_merged_first),
        cmocka_unit_test(two_motions_merge_to_one_action),
        cmocka_unit_test(the_outer_repetition_is_taken_from_its_neighbor),
        cmocka_unit_test(the_last_repetition_is_taken_from_what_follows),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
