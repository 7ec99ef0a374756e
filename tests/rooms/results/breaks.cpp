// SPDX-License-Identifier: BSD-3-Clause
// Fits of clips with breaks and long gaps: no neighborhood goes over them.
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include "assertions.hpp"
#include "clip/stretch.hpp"
#include "results/fitted.hpp"
#include "results/model_file/archive_model.hpp"

namespace {

using namespace stltsa;
using clip::Clip;
using results::Fitted;

constexpr std::int64_t count = 600, period = 60;

/// Three points that go round and round, 30 frames a second.
Clip circles() {
    Clip made;
    made.format = clip::Format::points;
    made.fps = 30;
    made.space = 3;
    made.values = Matrix(count, 9);
    for (std::int64_t i = 0; i < count; ++i)
        for (std::int64_t c = 0; c < 9; ++c)
            made.values(i, c) = static_cast<double>(c / 3) +
                                std::sin(2 * std::numbers::pi * static_cast<double>(i) / period +
                                         static_cast<double>(c * c)) +
                                1e-4 * static_cast<double>(i);
    return made;
}

clip::PrepareOptions plain() {
    clip::PrepareOptions prepare;
    prepare.features = clip::Features::raw;
    return prepare;
}

Fitted fitted(results::Clips clips, const results::FitOptions& options = {}) {
    results::ClipSamples prepared = results::prepare_clips(clips, plain());
    return results::fit(prepared.samples.view(), prepared.lengths, options, {},
                        std::move(prepared.source));
}

Fitted fitted(const Clip& clip, const results::FitOptions& options = {}) {
    const Clip* only = &clip;
    return fitted({&only, 1}, options);
}

using Lengths = std::vector<std::int64_t>;

void a_broken_clip_is_fitted_like_two(void**) {
    const Clip whole = circles();
    const Clip one = clip::cut(whole, {{0, 200}}), other = clip::cut(whole, {{350, 600}});
    const Clip* const both[] = {&one, &other};
    const Fitted two = fitted(both);
    const Fitted broken = fitted(clip::cut(whole, {{0, 200}, {350, 600}}));
    assert_true(broken.lengths == Lengths({450}));
    assert_true(broken.model.lengths == two.lengths && two.lengths == Lengths({200, 250}));
    assert_true(broken.model.component_of == two.model.component_of);
    assert_int_equal(broken.model.components.size(), 2);
    assert_true(broken.model.parameters.neighbors == two.model.parameters.neighbors);
    const Matrix& y = broken.model.coords;
    assert_memory_equal(y.data(), two.model.coords.data(),
                        static_cast<std::size_t>(y.rows() * y.cols()) * sizeof(double));
    assert_true(broken.model.warnings.empty());
    assert_true(broken.source.clips[0].notes.back().find("at frame 200:") != std::string::npos);
    assert_int_equal(fitted(whole).model.components.size(), 1);
}

void a_broken_clip_is_smoothed_like_two(void**) {
    const Clip whole = circles();
    const Clip broken = clip::cut(whole, {{0, 200}, {350, 600}});
    clip::PrepareOptions prepare = plain();
    for (const double rate : {30.0, 10.0}) {
        prepare.rate = rate;
        const Matrix samples = clip::prepare(broken, prepare).samples;
        const std::int64_t step = std::llround(30 / rate);
        for (const auto& [at, frames] :
             {std::pair{std::int64_t{0}, clip::Frames{0, 200}}, {200, {350, 600}}}) {
            prepare.rate = 30;
            const Matrix alone = clip::prepare(clip::cut(whole, {frames}), prepare).samples;
            for (std::int64_t i = at; i < at + frames.count(); ++i)
                if (i % step == 0)
                    assert_memory_equal(samples.row(i / step), alone.row(i - at),
                                        9 * sizeof(double));
        }
        const Matrix all = clip::smoothed_features(broken, clip::Features::raw, clip::Axis::none,
                                                   prepare.smoothing, true);
        for (std::int64_t i = 0; i < samples.rows(); ++i)
            assert_memory_equal(samples.row(i), all.row(i * step), 9 * sizeof(double));
    }
}

/// Nothing is seen in these frames.
Clip without(const std::vector<clip::Frames>& frames) {
    Clip made = circles();
    for (const clip::Frames& hole : frames)
        for (std::int64_t i = hole.begin; i < hole.end; ++i)
            std::fill_n(made.values.row(i), made.values.cols(),
                        std::numeric_limits<double>::quiet_NaN());
    return made;
}

void a_long_gap_is_a_break(void**) {
    // A gap of 0.2 s is filled; nothing is there before the first frame and after the last.
    const Fitted model = fitted(without({{0, 20}, {100, 106}, {300, 320}, {580, 600}}));
    assert_true(model.lengths == Lengths({560}));
    assert_true(model.model.lengths == Lengths({290, 270}));
    assert_int_equal(model.source.samples.first, 20);
    for (std::size_t i = 0; i < 560; ++i)
        assert_int_equal(model.model.component_of[i], i < 290 ? 0 : 1);

    std::string bytes;
    archive_model(model, results::archive_size(model), [&](std::string_view b) { bytes += b; });
    const Fitted again = results::restore_model(bytes);
    assert_true(again.lengths == model.lengths && again.model.lengths == model.model.lengths);
}

/// The first sample after a break is not before it.
void samples_are_on_their_side_of_a_break(void**) {
    clip::PrepareOptions prepare = plain();
    prepare.rate = 10; // every third frame
    const auto runs_of = [&](const Clip& clip) {
        const Clip* only = &clip;
        return results::prepare_clips({&only, 1}, prepare).lengths.runs;
    };
    // Frame 198 is sample 66; frame 200 begins another stretch.
    assert_true(runs_of(clip::cut(circles(), {{0, 200}, {350, 600}})) == Lengths({67, 83}));
    assert_true(runs_of(without({{300, 321}})) == Lengths({104, 96})); // middle: frame 310
}

void a_stretch_that_is_too_short_is_named(void**) {
    const Clip whole = circles();
    results::FitOptions options;
    options.neighbors = 40;
    const Clip broken = clip::cut(whole, {{0, 100}, {200, 230}, {300, 400}});
    try {
        fitted(broken, options);
        FAIL("30 frames have no 40 neighbors");
    } catch (const Error& error) {
        assert_true(error.status() == Status::too_few_frames);
        assert_non_null(std::strstr(error.what(), "from frame 100 to frame 129,"));
    }
    assert_int_equal(fitted(broken).model.parameters.neighbors, 29);
    options.mode = ltsa::Mode::spatial;
    assert_true(fitted(broken, options).lengths == Lengths({230}));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_broken_clip_is_fitted_like_two),
        cmocka_unit_test(a_broken_clip_is_smoothed_like_two),
        cmocka_unit_test(a_long_gap_is_a_break),
        cmocka_unit_test(samples_are_on_their_side_of_a_break),
        cmocka_unit_test(a_stretch_that_is_too_short_is_named),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
