// SPDX-License-Identifier: BSD-3-Clause
// stltsa.hpp: the segments of a recording, its loop, stretches of it, and clips of arrays.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include <stltsa.hpp>

#include "../rooms/assertions.hpp"
#include "../small_c3d.h"

namespace {

using stltsa::Clip;
using stltsa::Matrix;

std::string walker_path; // set by main()

const stltsa::Clip& walker() {
    static const stltsa::Clip clip = stltsa::Clip::open(walker_path);
    return clip;
}

void a_report_is_a_page(void**) {
    const std::string path = "/tmp/stltsa-wrapper-" + std::to_string(::getpid()) + ".html";
    const auto check = [&path] {
        std::ifstream file(path, std::ios::binary);
        const std::string page{std::istreambuf_iterator<char>(file), {}};
        assert_int_equal(::unlink(path.c_str()), 0);
        assert_true(page.starts_with("<!doctype html>"));
        assert_true(page.find("\"command\":\"a command\"") != page.npos);
    };
    const stltsa::Decomposition found = stltsa::decompose(walker());
    found.save_report(walker(), path, "a command");
    check();
    stltsa::find_phase(found).compare_left_right(walker()).save_report(path, "a command");
    check();
}

void a_recording_is_divided_into_segments(void**) {
    const stltsa::Decomposition found = stltsa::decompose(walker());
    const std::vector<stltsa::Segment> segments = found.segments();
    assert_int_equal(segments[0].begin, 0);
    assert_int_equal(segments.back().end, walker().frames());
    const auto cyclic = std::ranges::find(segments, STLTSA_SEGMENT_CYCLIC, &stltsa::Segment::kind);
    assert_true(cyclic != segments.end());
    assert_string_equal(stltsa::segment_name(cyclic->kind).c_str(), "cyclic");
    assert_int_equal(cyclic->count, 3);
    assert_string_equal(cyclic->letters, "A");
    assert_string_equal(cyclic->reason, "");
    assert_non_null(cyclic->carried_by[0]);
    assert_true(cyclic->first_step_share == 0.5);
    assert_string_equal(cyclic->steps_reason, "");
    assert_true(std::isnan(segments[0].period_s) && segments[0].label == -1);
    assert_int_equal(found.label_likeness().rows, 1);
    assert_true(std::isnan(found.label_likeness()(0, 0)));
    const std::vector<std::int64_t> sides = found.info().integers(STLTSA_INFO_SIDE);
    assert_int_equal(sides.size(), 2);
    assert_true(sides[0] == STLTSA_SIDE_LEFT || sides[0] == STLTSA_SIDE_RIGHT);
    assert_int_equal(sides[0] + sides[1], STLTSA_SIDE_RIGHT);
    const std::vector<stltsa::Part> cycles = found.cycles(), steps = found.steps();
    assert_int_equal(cycles.size(), 3);
    assert_int_equal(steps.size(), 6);
    assert_int_equal(steps[5].cycle, 2);
    assert_int_equal(cycles[1].cycle, -1);
    assert_string_equal(steps[0].side_name,
                        sides[static_cast<std::size_t>(steps[0].side)] == 0 ? "left" : "right");
    const std::vector<stltsa::Summary> summaries = found.summaries();
    assert_int_equal(summaries.size(), 1);
    assert_int_equal(summaries[0].count, 3);
    ASSERT_NEAR(summaries[0].cycle_time_s.mean, found.info().real(STLTSA_INFO_PERIOD), 0.1);
    assert_true(found.repetitions().empty());
}

/// The walker goes straight ahead at 126 units a second, 110 steps a minute at most (its README).
void travel_and_its_statistics_are_the_walkers(void**) {
    const stltsa::Decomposition found = stltsa::decompose(walker());
    const stltsa::Part stride = found.cycles()[1];
    ASSERT_NEAR(stride.speed, 126, 1.5);
    ASSERT_NEAR(stride.stride, 126 * 1.1, 2);
    ASSERT_NEAR(stride.turn_deg, 0, 0.5);
    assert_true(stride.path_length >= stride.stride);
    const auto of = [&](std::int32_t kind, std::int32_t side, std::int32_t quantity) {
        return found.statistics(kind, 0, side, quantity);
    };
    const stltsa::Statistics time = of(STLTSA_INFO_CYCLE, -1, STLTSA_QUANTITY_TIME);
    const stltsa::Statistics summary = found.summaries()[0].cycle_time_s;
    ASSERT_NEAR(time.mean, summary.mean, 0);
    ASSERT_NEAR(time.sd, summary.sd, 0);
    const stltsa::Statistics left = of(STLTSA_INFO_STEP, 0, STLTSA_QUANTITY_TIME),
                             right = of(STLTSA_INFO_STEP, 1, STLTSA_QUANTITY_TIME),
                             both = of(STLTSA_INFO_STEP, -1, STLTSA_QUANTITY_TIME);
    assert_int_equal(left.count + right.count, both.count);
    ASSERT_NEAR((left.mean + right.mean) / 2, both.mean, 1e-12);
    assert_true(std::isnan(of(STLTSA_INFO_CYCLE, -1, STLTSA_QUANTITY_TURN).cv));
    assert_int_equal(of(STLTSA_INFO_REPETITION, -1, STLTSA_QUANTITY_PATH_LENGTH).count, 0);
    assert_int_equal(found.statistics(STLTSA_INFO_CYCLE, 9, -1, STLTSA_QUANTITY_PATH_LENGTH).count,
                     0);
    const auto refused = [&](auto... arguments) {
        stltsa_statistics none{};
        return stltsa_decomposition_statistics(found.get(), arguments..., &none) ==
               STLTSA_E_ARGUMENT;
    };
    assert_true(refused(7, 0, -1, STLTSA_QUANTITY_TIME));
    assert_true(refused(STLTSA_INFO_CYCLE, 0, 2, STLTSA_QUANTITY_TIME));
    assert_true(refused(STLTSA_INFO_CYCLE, 0, -1, 6));
}

void the_mirror_image_has_the_other_sides(void**) {
    const stltsa::Clip image = walker().mirrored();
    assert_int_equal(image.frames(), walker().frames());
    const stltsa::Decomposition here = stltsa::decompose(walker()),
                                there = stltsa::decompose(image);
    const stltsa::Part first = here.cycles()[0], mirrored = there.cycles()[0];
    ASSERT_NEAR(mirrored.speed, first.speed, 1);
    // Cycles begin on the same side, which does now what the other one did half a cycle later.
    const double period = first.end_s - first.begin_s;
    const double apart = std::abs(mirrored.begin_s - first.begin_s);
    ASSERT_NEAR(std::fmod(apart, period), period / 2, 0.03);
    stltsa_clip* none = nullptr;
    const Matrix numbers(9, 4);
    Clip bare = Clip::from_matrix(stltsa::MatrixView(numbers), 30);
    bare.set_path("walk.mot");
    assert_true(bare.json().find("\"path\":\"walk.mot\"") != std::string::npos);
    assert_int_equal(stltsa_clip_mirror(bare.get(), nullptr, &none), STLTSA_E_UNSUPPORTED);
    assert_null(none);
    assert_int_equal(stltsa_clip_mirror(bare.get(), nullptr, nullptr), STLTSA_E_ARGUMENT);
}

void cycles_become_a_loop(void**) {
    const stltsa::Synthesis loop = stltsa::synthesize_loop(walker(), stltsa::decompose(walker()));
    assert_int_equal(loop.seams()[0].frame, loop.clip().frames());
    assert_int_equal(loop.info().integer(STLTSA_INFO_LOOP_CYCLES), 3);
}

void clips_are_made_of_arrays_and_cut(void**) {
    const Clip& walk = walker();
    const std::vector<stltsa::Joint> joints = walk.joints();
    const Matrix positions = walk.positions();
    Matrix root(positions.rows, 3);
    for (std::int64_t i = 0; i < root.rows; ++i)
        for (std::int64_t c = 0; c < 3; ++c)
            root(i, c) = positions(i, c);
    const Clip body = Clip::from_skeleton(joints, STLTSA_ROTATIONS_QUATERNION, walk.rotations(),
                                          stltsa::MatrixView(root), walk.fps());
    const Matrix back = body.positions();
    for (std::size_t i = 0; i < back.values.size(); ++i)
        ASSERT_NEAR(back.values[i], positions.values[i], 1e-10);
    stltsa::Points points{positions, 3, {}, {}, {}, walk.fps()};
    for (const stltsa::Joint& joint : joints)
        points.names.push_back(joint.name);
    Matrix times(positions.rows, 1), sure(positions.rows, positions.cols / 3);
    for (std::int64_t i = 0; i < times.rows; ++i)
        times(i, 0) = static_cast<double>(i) / walk.fps();
    std::fill(sure.values.begin(), sure.values.end(), 1.0);
    const Clip markers = Clip::from_points(points);
    assert_int_equal(markers.info().integer(STLTSA_INFO_FORMAT), STLTSA_FORMAT_POINTS);
    points.fps = 0;
    points.times = times;
    points.confidence = sure;
    assert_true(Clip::from_points(points).features().values == markers.features().values);
    const Clip cyclic = walk.stretch("cyclic");
    assert_int_equal(Clip::open_stretch(walker_path + ":cyclic").frames(), cyclic.frames());
    const std::vector<stltsa_interval> found = walk.find("cyclic");
    assert_int_equal(found.size(), 1);
    assert_int_equal(found[0].end - found[0].begin, cyclic.frames());
    try {
        walk.find("cycle77");
        _fail(__FILE__, __LINE__);
    } catch (const stltsa::Error& error) {
        assert_int_equal(error.status(), STLTSA_E_NO_SUCH_PART);
    }
}

void a_clip_has_the_events_of_its_file(void**) {
    unsigned char bytes[small_c3d_size];
    make_small_c3d(bytes);
    const Clip clip = Clip::parse(std::as_bytes(std::span(bytes)));
    const std::vector<stltsa::FileEvent> events = clip.events();
    assert_int_equal(events.size(), 1);
    assert_string_equal(events[0].label, "RHS");
    assert_true(events[0].context[0] == 0 && events[0].frame == 12.5);
    assert_true(walker().events().empty());
}

void a_batch_keeps_its_results(void**) {
    std::string out = "/tmp/stltsa-wrapper-XXXXXX";
    assert_non_null(::mkdtemp(out.data()));
    for (const bool again : {false, true}) {
        const stltsa::Batch batch({walker_path, out + "/missing.bvh"}, out, again ? "1/1" : "");
        const std::vector<std::string> paths = batch.paths();
        assert_int_equal(paths.size(), 2);
        std::vector<std::string> rows;
        for (std::int64_t i = 0; i < 2; ++i) {
            const bool there = paths[static_cast<std::size_t>(i)] == walker_path;
            const stltsa::BatchRow row = batch.run(i);
            assert_int_equal(row.status, there ? STLTSA_OK : STLTSA_E_IO);
            assert_true(row.error.empty() == there && row.kept == (there && again));
            rows.push_back(row.text);
        }
        const std::string place = batch.finish(rows);
        assert_string_equal(place.c_str(),
                            (out + (again ? "/summary-1-1.csv" : "/summary.csv")).c_str());
        try {
            batch.run(2);
            _fail(__FILE__, __LINE__);
        } catch (const stltsa::Error& error) {
            assert_int_equal(error.status(), STLTSA_E_ARGUMENT);
        }
        assert_non_null(batch.get());
    }
    // What a callback throws is thrown again.
    const stltsa::Batch batch({walker_path}, out + "/other");
    stltsa::Options options;
    options.set_progress([](std::int32_t, double) -> bool { throw std::runtime_error("stop"); });
    try {
        batch.run(0, options);
        _fail(__FILE__, __LINE__);
    } catch (const std::runtime_error& stop) {
        assert_string_equal(stop.what(), "stop");
    }
    std::filesystem::remove_all(out);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2)
        return 2;
    walker_path = argv[1];
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_report_is_a_page),
        cmocka_unit_test(a_recording_is_divided_into_segments),
        cmocka_unit_test(travel_and_its_statistics_are_the_walkers),
        cmocka_unit_test(the_mirror_image_has_the_other_sides),
        cmocka_unit_test(cycles_become_a_loop),
        cmocka_unit_test(clips_are_made_of_arrays_and_cut),
        cmocka_unit_test(a_clip_has_the_events_of_its_file),
        cmocka_unit_test(a_batch_keeps_its_results),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
