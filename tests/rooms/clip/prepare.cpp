// SPDX-License-Identifier: BSD-3-Clause
// T-pose at the start, smoothing, decimation, and the mapping to source frames.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "clip/features/features.hpp"
#include "clip/features/prepare.hpp"
#include "clip/features/tpose.hpp"
#include "linalg/gaussian.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using namespace stltsa;

/// A smooth motion of ten features; its first `smeared` frames leave another pose.
Matrix motion(std::int64_t frames, std::int64_t smeared, double size = 20) {
    Matrix rows(frames, 10);
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t c = 0; c < 10; ++c) {
            rows(i, c) =
                std::sin(0.05 * static_cast<double>(i * (1 + c % 3)) + static_cast<double>(c));
            if (i < smeared)
                rows(i, c) +=
                    size * std::pow(1 - static_cast<double>(i) / static_cast<double>(smeared), 2);
        }
    return rows;
}

void finds_tpose_starts(void**) {
    for (std::int64_t smeared = 1; smeared <= 5; ++smeared)
        for (const std::int64_t frames : {60, 200, 1000})
            assert_int_equal(tpose_frames(motion(frames, smeared).view()), smeared);
}

void finds_no_tpose_without_one(void**) {
    for (const std::int64_t frames : {2, 10, 60, 200, 1000})
        assert_int_equal(tpose_frames(motion(frames, 0).view()), 0);
    assert_int_equal(tpose_frames(motion(20, 1).view()), 0); // too short to decide
    assert_int_equal(tpose_frames(motion(1, 0).view()), 0);
    assert_int_equal(tpose_frames(Matrix(100, 3).view()), 0);      // nothing moves
    assert_int_equal(tpose_frames(motion(200, 1, 0.2).view()), 0); // like a quick start
    Matrix still(100, 3);
    still(0, 0) = 1; // one step, with nothing to compare it with
    assert_int_equal(tpose_frames(still.view()), 0);
}

void never_drops_more_than_eight(void**) {
    assert_int_equal(tpose_frames(motion(1000, 30, 400).view()), 8);
}

void finds_no_tpose_inside(void**) {
    Matrix rows = motion(200, 0);
    for (std::int64_t i = 100; i < 200; ++i)
        rows(i, 0) += 20; // a later jump does not matter
    assert_int_equal(tpose_frames(rows.view()), 0);
}

/// One joint on a stick, turning smoothly; its first `tpose` frames leave another pose.
Clip turning(std::int64_t frames, double fps, std::int64_t tpose) {
    Clip clip =
        parse("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nJOINT b\n{\nOFFSET 0 1 0\nCHANNELS 1 "
              "Zrotation\nEnd Site\n{\nOFFSET 0 2 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: "
              "1\n0\n",
              Format::bvh);
    clip.fps = fps;
    clip.values = Matrix(frames, 1);
    for (std::int64_t i = 0; i < frames; ++i)
        clip.values(i, 0) = 20 * std::sin(0.02 * static_cast<double>(i)) +
                            30 * static_cast<double>(std::max<std::int64_t>(0, tpose - i));
    return clip;
}

void samples_are_source_frames(void**) {
    for (const std::int64_t tpose : {0, 1, 3}) {
        const Clip clip = turning(201, 120, tpose);
        PrepareOptions options;
        options.smoothing = 0;
        const Prepared prepared = prepare(clip, options);
        assert_int_equal(prepared.first, tpose);
        assert_int_equal(prepared.step, 4);
        assert_true(prepared.fps == 30);
        assert_true(prepared.features == Features::positions && prepared.up == Axis::y);
        const Matrix all = features(clip, Features::positions, Axis::y);
        const Matrix& samples = prepared.samples;
        assert_int_equal(samples.rows(), (201 - tpose + 3) / 4);
        for (std::int64_t i = 0; i < samples.rows(); ++i)
            for (std::int64_t c = 0; c < samples.cols(); ++c)
                assert_true(samples(i, c) == all(prepared.first + i * prepared.step, c));
    }
}

void numbers_stay_as_they_are(void**) {
    Clip clip = turning(50, 30, 0);
    clip.skeleton.reset();
    PrepareOptions options;
    options.smoothing = 0;
    check_same(prepare(clip, options).samples, clip.values, 0);
    clip.fps = 0; // no rate: seconds are undefined
    check_same(prepare(clip, {}).samples, clip.values, 0);
}

void the_start_is_kept_on_request(void**) {
    PrepareOptions options;
    options.drop_tpose = false;
    assert_int_equal(prepare(turning(200, 120, 3), options).first, 0);
}

void steps_follow_the_rate(void**) {
    const struct {
        double fps, rate;
        std::int64_t step;
    } cases[] = {{120, 30, 4}, {30, 30, 1}, {15, 30, 1}, {100, 30, 3},        {120, 0, 1},
                 {60, 30, 2},  {50, 30, 2}, {0, 30, 1},  {1e300, 1e-300, 200}};
    for (const auto& c : cases) {
        PrepareOptions options;
        options.rate = c.rate;
        const Prepared prepared = prepare(turning(200, c.fps, 0), options);
        assert_int_equal(prepared.step, c.step);
        assert_true(prepared.fps == c.fps / static_cast<double>(c.step));
    }
}

Clip column(const std::vector<double>& values, double fps) {
    Clip clip;
    clip.fps = fps;
    clip.values = Matrix(static_cast<std::int64_t>(values.size()), 1);
    std::copy(values.begin(), values.end(), clip.values.data());
    return clip;
}

void smooths_by_a_gaussian(void**) {
    // sigma = 0.05 s = 5 frames. An impulse in the middle becomes the kernel.
    std::vector<double> impulse(101, 0.0);
    impulse[50] = 1;
    PrepareOptions options;
    options.rate = 0;
    const Matrix smooth = prepare(column(impulse, 100), options).samples;
    double sum = 0;
    for (std::int64_t i = 0; i < 101; ++i) {
        sum += smooth(i, 0);
        ASSERT_NEAR(
            smooth(i, 0) / smooth(50, 0),
            std::abs(i - 50) > 20 ? 0 : std::exp(-0.02 * static_cast<double>((i - 50) * (i - 50))),
            1e-12);
    }
    ASSERT_NEAR(sum, 1, 1e-12);
}

/// Smoothed in place, block by block: the same bits as from a copy.
void long_clips_are_smoothed_alike(void**) {
    Matrix rows(9001, 2);
    for (std::int64_t i = 0; i < rows.rows(); ++i) {
        rows(i, 0) = std::sin(0.01 * static_cast<double>(i * i % 700));
        rows(i, 1) = static_cast<double>(i % 37);
    }
    for (const Beyond beyond : {Beyond::reflection, Beyond::nothing})
        for (const double sigma : {0.4, 1.5, 1200.0}) {
            const Matrix expected = gaussian_smoothed(rows.view(), sigma, beyond);
            Matrix smooth = copied(rows.view());
            smooth_in_place(smooth, sigma, beyond);
            for (std::int64_t i = 0; i < rows.rows() * 2; ++i)
                ASSERT_NEAR(smooth.data()[i], expected.data()[i], 0);
        }
}

void smoothing_keeps_constants_to_the_ends(void**) {
    const Matrix smooth = prepare(column(std::vector<double>(50, 3.25), 120), {}).samples;
    assert_int_equal(smooth.rows(), 13);
    for (std::int64_t i = 0; i < smooth.rows(); ++i)
        ASSERT_NEAR(smooth(i, 0), 3.25, 1e-14);
}

/// Cut off while it moves, a steady motion does not slow down there.
void smoothing_keeps_speed_to_the_ends(void**) {
    std::vector<double> line(50);
    for (std::size_t i = 0; i < line.size(); ++i)
        line[i] = 3.25 + 0.5 * static_cast<double>(i);
    for (const std::size_t frames :
         {std::size_t{2}, std::size_t{7}, std::size_t{50}}) { // 7 are fewer than the kernel reaches
        PrepareOptions options;
        options.rate = 0;
        const Matrix smooth =
            prepare(column(std::vector<double>(line.begin(),
                                               line.begin() + static_cast<std::ptrdiff_t>(frames)),
                           120),
                    options)
                .samples;
        assert_int_equal(smooth.rows(), frames);
        for (std::int64_t i = 0; i < smooth.rows(); ++i)
            ASSERT_NEAR(smooth(i, 0), line[static_cast<std::size_t>(i)], 1e-13);
    }
}

void smoothing_ignores_dropped_frames(void**) {
    const Prepared prepared = prepare(turning(200, 120, 3), {});
    assert_int_equal(prepared.first, 3);
    const Clip clip = turning(200, 120, 0);
    PrepareOptions options;
    options.rate = 0;
    Clip rest = clip;
    rest.values = Matrix(197, 1);
    std::copy(clip.values.row(3), clip.values.row(199) + 1, rest.values.data());
    const Matrix expected = prepare(rest, options).samples;
    for (std::int64_t i = 0; i < prepared.samples.rows(); ++i)
        for (std::int64_t c = 0; c < prepared.samples.cols(); ++c)
            assert_true(prepared.samples(i, c) == expected(4 * i, c));
}

void features_of_all_frames_hold_the_samples(void**) {
    for (const std::int64_t tpose : {0, 3})
        for (const bool drop : {true, false}) {
            const Clip clip = turning(201, 120, tpose);
            PrepareOptions options;
            options.drop_tpose = drop;
            const auto prepared = prepare(clip, options);
            const Matrix all = smoothed_features(clip, prepared.features, prepared.up,
                                                 options.smoothing, options.drop_tpose);
            const Matrix raw = features(clip, prepared.features, prepared.up);
            assert_int_equal(all.rows(), 201);
            assert_memory_equal(all.data(), raw.data(),
                                static_cast<std::size_t>(prepared.first * all.cols()) *
                                    sizeof(double));
            for (std::int64_t i = 0; i < prepared.samples.rows(); ++i)
                assert_memory_equal(all.row(prepared.first + i * prepared.step),
                                    prepared.samples.row(i),
                                    static_cast<std::size_t>(all.cols()) * sizeof(double));
        }
}

/// Samples begin when the body comes and end when it leaves, as those of the stretch alone do.
void samples_are_of_the_body(void**) {
    Clip clip = turning(900, 120, 0);
    clip.skeleton.reset();
    Clip alone = clip;
    alone.values = copied(clip.values.view().block(301, 400));
    for (std::int64_t i = 0; i < 900; ++i)
        if (i < 301 || i >= 701)
            clip.values(i, 0) = std::numeric_limits<double>::quiet_NaN();
    PrepareOptions options;
    options.keep_rows = true;
    const Prepared prepared = prepare(clip, options), expected = prepare(alone, options);
    assert_int_equal(prepared.first, 301);
    assert_int_equal(prepared.samples.rows(), 100);
    check_same(prepared.samples, expected.samples, 0);
    check_same(prepared.rows, expected.rows, 0);
    assert_true(prepared.holes == (std::vector<Frames>{{0, 301}, {701, 900}}));
    clip.breaks = {100, 800}; // neither cuts the samples
    check_same(prepare(clip, options).samples, expected.samples, 0);
    const Matrix all = smoothed_features(clip, Features::raw, Axis::none, options.smoothing, true);
    for (std::int64_t i = 0; i < 100; ++i)
        assert_true(all(301 + 4 * i, 0) == prepared.samples(i, 0));
}

/// A cut at `frame`, but no T-pose.
Clip cut_at(std::int64_t frame, double size) {
    std::vector<double> values;
    for (std::int64_t i = 0; i < 400; ++i)
        values.push_back((i < frame ? 0 : size) + std::sin(0.1 * static_cast<double>(i)));
    return column(values, 120);
}

void finds_the_frame_of_a_cut(void**) {
    for (const std::int64_t frame : {1, 2, 100, 301, 399})
        assert_int_equal(prepare(cut_at(frame, 5), {}).jump, frame);
    assert_int_equal(prepare(cut_at(100, 0.2), {}).jump, 0);
    assert_int_equal(prepare(cut_at(400, 5), {}).jump, 0);
    // One bad frame; no movement; one frame.
    Clip clip = cut_at(400, 0);
    clip.values(77, 0) = 40;
    assert_int_equal(prepare(clip, {}).jump, 77);
    assert_int_equal(prepare(column(std::vector<double>(50, 1.0), 30), {}).jump, 0);
    assert_int_equal(prepare(column({1.0}, 30), {}).jump, 0);
}

/// A blow of 0.15 s after long standing is fast, but moves over several frames.
void a_blow_is_not_a_cut(void**) {
    for (const double fps : {30.0, 60.0, 120.0}) {
        std::vector<double> values;
        for (double t = -5; t < 5; t += 1 / fps) {
            const double u = std::clamp(t / 0.15, 0.0, 1.0);
            values.push_back(u * u * (3 - 2 * u));
        }
        assert_int_equal(prepare(column(values, fps), {}).jump, 0);
    }
}

void bare_matrices_have_no_tpose(void**) {
    std::vector<double> values(200, 0.0);
    for (std::size_t i = 1; i < 200; ++i)
        values[i] = 100 + std::sin(0.1 * static_cast<double>(i));
    const Prepared prepared = prepare(column(values, 30), {});
    assert_int_equal(prepared.first, 0);
    assert_true(prepared.features == Features::raw);
}

void a_clip_needs_frames(void**) {
    Clip clip;
    clip.fps = 30;
    clip.values = Matrix(0, 3);
    ASSERT_FAILS(stltsa::Status::too_few_frames, "no frames", prepare(clip, {}));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(finds_tpose_starts),
        cmocka_unit_test(finds_no_tpose_without_one),
        cmocka_unit_test(never_drops_more_than_eight),
        cmocka_unit_test(finds_no_tpose_inside),
        cmocka_unit_test(samples_are_source_frames),
        cmocka_unit_test(numbers_stay_as_they_are),
        cmocka_unit_test(the_start_is_kept_on_request),
        cmocka_unit_test(steps_follow_the_rate),
        cmocka_unit_test(smooths_by_a_gaussian),
        cmocka_unit_test(long_clips_are_smoothed_alike),
        cmocka_unit_test(smoothing_keeps_constants_to_the_ends),
        cmocka_unit_test(smoothing_keeps_speed_to_the_ends),
        cmocka_unit_test(smoothing_ignores_dropped_frames),
        cmocka_unit_test(features_of_all_frames_hold_the_samples),
        cmocka_unit_test(samples_are_of_the_body),
        cmocka_unit_test(finds_the_frame_of_a_cut),
        cmocka_unit_test(a_blow_is_not_a_cut),
        cmocka_unit_test(bare_matrices_have_no_tpose),
        cmocka_unit_test(a_clip_needs_frames),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
