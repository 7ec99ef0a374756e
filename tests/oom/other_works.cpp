// SPDX-License-Identifier: BSD-3-Clause
#include "../small_c3d.h"
#include "calls.hpp"
#include "works.hpp"

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace {

constexpr std::int64_t frames = 150;

stltsa_out out(std::int64_t rows, std::int64_t cols, double* to = room) {
    return {to, rows, cols, 0, 0, STLTSA_F64, 0};
}
stltsa_in in(const void* from, std::int64_t rows, std::int64_t cols,
             std::int32_t dtype = STLTSA_F64) {
    return {from, rows, cols, 0, 0, dtype, 0};
}

/// Eight columns of period 30.
const double* waves() {
    static const auto* made = [] {
        auto* x = static_cast<double*>(std::malloc(frames * 8 * sizeof(double)));
        for (std::int64_t i = 0; i < frames * 8; ++i)
            x[i] = std::sin(2 * M_PI * static_cast<double>(i / 8) / 30 *
                                static_cast<double>(1 + i % 2) +
                            static_cast<double>(i % 8)) +
                   1e-3 * static_cast<double>(i / 8);
        return x;
    }();
    return made;
}

/// Handles for all works, made before allocations fail.
struct Kept {
    stltsa_clip *matrix = nullptr, *points = nullptr, *body = nullptr;
    stltsa_decomposition* parts = nullptr;
    stltsa_phase* phase = nullptr;
    stltsa_model* model = nullptr;

    Kept() {
        const stltsa_in columns = in(waves(), frames, 8), triples = in(waves(), 100, 12);
        const char* names[] = {"hips", "head", "L_foot", "R_foot"};
        stltsa_points of_points{};
        of_points.size = sizeof of_points;
        of_points.space = 3;
        of_points.positions = triples;
        of_points.names = names;
        of_points.fps = 30;
        const stltsa_joint joints[] = {
            {sizeof(stltsa_joint), "hip", -1, {0, 0, 0}, "rz rx ry", 0, 0},
            {sizeof(stltsa_joint), "knee", 0, {0, -4, 0}, "rz rx", 0, 0},
            {sizeof(stltsa_joint), "foot", 1, {0, -4, 1}, nullptr, 1, 0}};
        const stltsa_in angles = in(waves(), 200, 5);
        const bool made = stltsa_clip_from_matrix(&columns, 30, &matrix) == STLTSA_OK &&
                          stltsa_clip_from_points(&of_points, nullptr, &points) == STLTSA_OK &&
                          stltsa_clip_from_skeleton(joints, 3, STLTSA_ROTATIONS_CHANNELS, &angles,
                                                    nullptr, 30, &body) == STLTSA_OK &&
                          stltsa_decompose(matrix, nullptr, &parts) == STLTSA_OK &&
                          stltsa_phase_find(parts, nullptr, &phase) == STLTSA_OK &&
                          stltsa_fit_clip(matrix, nullptr, &model) == STLTSA_OK;
        if (!made)
            std::abort();
    }
};
const Kept& kept() {
    static const Kept made;
    return made;
}

/// Reads every fact of a handle.
void read_facts(Calls& calls, const stltsa_info* info) {
    for (std::int64_t k = 0; k < stltsa_info_key_count(); ++k) {
        stltsa_info_key key{};
        key.size = sizeof key;
        calls.make([&] { return stltsa_info_describe(k, &key); });
        if (!calls.good() || stltsa_info_count(info, key.key) == 0)
            continue;
        std::int64_t whole = 0;
        double real = 0;
        const char* text = nullptr;
        calls.make([&] {
            return key.type == STLTSA_TYPE_INT    ? stltsa_info_int(info, key.key, 0, &whole)
                   : key.type == STLTSA_TYPE_REAL ? stltsa_info_real(info, key.key, 0, &real)
                                                  : stltsa_info_text(info, key.key, 0, &text);
        });
        note(&whole, sizeof whole);
        note(&real, sizeof real);
        note(text);
    }
}

std::int32_t go_on(void*, std::int32_t, double) {
    return 0;
}

stltsa_status options(const std::string&) {
    Calls calls;
    stltsa_options* made = nullptr;
    const char* text = nullptr;
    std::int64_t whole = 0;
    double real = 0;
    calls.make([&] { return stltsa_options_new(&made); }, made);
    calls.make([&] {
        return stltsa_options_set_text(made, STLTSA_OPT_SKELETON,
                                       "a path that is too long for a string without memory");
    });
    calls.make([&] { return stltsa_options_get_text(made, STLTSA_OPT_SKELETON, &text); });
    calls.make([&] { return stltsa_options_set_real(made, STLTSA_OPT_FPS, 25); });
    calls.make([&] { return stltsa_options_get_real(made, STLTSA_OPT_FPS, &real); });
    calls.make([&] { return stltsa_options_set_int(made, STLTSA_OPT_THREADS, 2); });
    calls.make([&] { return stltsa_options_get_int(made, STLTSA_OPT_THREADS, &whole); });
    calls.make([&] { return stltsa_options_set_progress(made, go_on, nullptr); });
    calls.make([&] { return stltsa_options_unset(made, STLTSA_OPT_FPS); });
    for (std::int64_t i = 0; i < stltsa_option_count(); ++i) {
        stltsa_option_info info{};
        info.size = sizeof info;
        calls.make([&] { return stltsa_option_describe(i, &info); });
        stltsa_options_is_set(made, info.key);
    }
    stltsa_options_free(made);
    return calls.status();
}

stltsa_status describe_clips(const std::string&) {
    Calls calls;
    std::int64_t count = 0;
    for (const stltsa_clip* clip : {kept().matrix, kept().points, kept().body}) {
        char* json = nullptr;
        calls.make([&] { return stltsa_clip_json(clip, &json); }, json);
        note(json);
        stltsa_free(json);
        calls.make([&] { return stltsa_clip_feature_count(clip, nullptr, &count); });
        const stltsa_out features = out(stltsa_clip_frames(clip), count);
        calls.make([&] { return stltsa_clip_features(clip, nullptr, &features); });
        read_facts(calls, stltsa_clip_info(clip));
    }
    const stltsa_clip* body = kept().body;
    const std::int64_t rows = stltsa_clip_frames(body), joints = stltsa_clip_joints(body);
    const stltsa_out places = out(rows, 3 * joints), turns = out(rows, 4 * joints);
    calls.make([&] { return stltsa_clip_positions(body, &places); });
    calls.make([&] { return stltsa_clip_rotations(body, &turns); });
    stltsa_joint joint{};
    joint.size = sizeof joint;
    calls.make([&] { return stltsa_clip_joint(body, 1, &joint); });
    unsigned char c3d[small_c3d_size];
    make_small_c3d(c3d);
    stltsa_clip* recording = nullptr;
    calls.make(
        [&] {
            return stltsa_clip_parse(c3d, sizeof c3d, STLTSA_FORMAT_C3D, nullptr, nullptr,
                                     &recording);
        },
        recording);
    stltsa_file_event event{};
    event.size = sizeof event;
    if (stltsa_clip_event_count(recording) == 1)
        calls.make([&] { return stltsa_clip_event(recording, 0, &event); });
    stltsa_clip_free(recording);
    const bool same = stltsa_clip_channels(body) == 5 && stltsa_clip_fps(body) == 30 &&
                      stltsa_clip_format(body) == STLTSA_FORMAT_SKELETON;
    return same ? calls.status() : 1;
}

stltsa_status derive_clips(const std::string&) {
    Calls calls;
    stltsa_clip *stretch = nullptr, *mirrored = nullptr, *copied = nullptr;
    stltsa_interval found{};
    std::int64_t count = 0;
    calls.make([&] { return stltsa_clip_stretch(kept().matrix, "10-90", nullptr, &stretch); },
               stretch);
    calls.make([&] { return stltsa_clip_mirror(kept().points, nullptr, &mirrored); }, mirrored);
    calls.make(
        [&] { return stltsa_clip_find(kept().matrix, "0.5s-2s", nullptr, 1, &found, &count); });
    const stltsa_in columns = in(waves(), frames, 8);
    calls.make([&] { return stltsa_clip_from_matrix(&columns, 30, &copied); }, copied);
    calls.make([&] {
        return stltsa_clip_set_path(copied, "/a path/too long/for a string without memory.csv");
    });
    stltsa_clip_free(copied);
    stltsa_clip_free(mirrored);
    stltsa_clip_free(stretch);
    return calls.status();
}

stltsa_status dimensions(const std::string&) {
    Calls calls;
    stltsa_dimension *of_clip = nullptr, *of_clips = nullptr, *of_matrix = nullptr;
    const stltsa_clip* clips[] = {kept().matrix, kept().matrix};
    const stltsa_in columns = in(waves(), frames, 8);
    calls.make([&] { return stltsa_estimate_dimension(&columns, nullptr, nullptr, &of_matrix); },
               of_matrix);
    calls.make([&] { return stltsa_estimate_dimension_clip(kept().matrix, nullptr, &of_clip); },
               of_clip);
    calls.make([&] { return stltsa_estimate_dimension_clips(clips, 2, nullptr, &of_clips); },
               of_clips);
    if (calls.good()) {
        char* json = nullptr;
        const char* reason = nullptr;
        calls.make([&] { return stltsa_dimension_json(of_clip, &json); }, json);
        note(json);
        stltsa_free(json);
        const stltsa_info* info = stltsa_dimension_info(of_clip);
        stltsa_dimension_eigengap(of_clip, &reason);
        stltsa_dimension_local_pca(of_clip, &reason);
        const stltsa_out values = out(stltsa_info_count(info, STLTSA_INFO_EIGENVALUE), 1);
        const stltsa_out shares = out(stltsa_info_count(info, STLTSA_INFO_LOCAL_VARIANCE), 1);
        calls.make([&] { return stltsa_dimension_eigenvalues(of_clip, &values); });
        calls.make([&] { return stltsa_dimension_local_variances(of_clip, &shares); });
        read_facts(calls, info);
    }
    stltsa_dimension_free(of_clips);
    stltsa_dimension_free(of_clip);
    stltsa_dimension_free(of_matrix);
    return calls.status();
}

stltsa_status read_parts(const std::string&) {
    Calls calls;
    const stltsa_decomposition* parts = kept().parts;
    const stltsa_info* info = stltsa_decomposition_info(parts);
    stltsa_segment segment{};
    stltsa_part part{};
    stltsa_travel travel{};
    stltsa_statistics statistics{};
    stltsa_summary summary{};
    stltsa_interval interval{};
    std::int64_t samples = 0;
    char* json = nullptr;
    calls.make([&] { return stltsa_decomposition_json(parts, &json); }, json);
    note(json);
    stltsa_free(json);
    read_facts(calls, info);
    calls.make([&] { return stltsa_info_int(info, STLTSA_INFO_ROWS, 0, &samples); });
    const stltsa_out curve = out(samples, 1), coords = out(samples, 2), loop = out(samples, 2);
    calls.make([&] { return stltsa_decomposition_curve(parts, &curve); });
    calls.make([&] { return stltsa_decomposition_coords(parts, &coords); });
    calls.make([&] { return stltsa_decomposition_loop(parts, &loop); });
    calls.make([&] { return stltsa_decomposition_segment(parts, 0, &segment); });
    calls.make([&] { return stltsa_decomposition_unit(parts, 0, &interval); });
    calls.make([&] { return stltsa_decomposition_cycle(parts, 0, &interval); });
    calls.make([&] { return stltsa_decomposition_summary(parts, 0, &summary); });
    calls.make([&] { return stltsa_decomposition_part(parts, STLTSA_PART_CYCLE, 0, &part); });
    // A matrix of bare numbers has no travel. The caller owns none of these texts.
    stltsa_decomposition_travel(parts, STLTSA_PART_CYCLE, 0, &travel);
    stltsa_decomposition_statistics(parts, STLTSA_PART_CYCLE, 0, -1, STLTSA_QUANTITY_TIME,
                                    &statistics);
    stltsa_decomposition_segment_reason(parts, 0);
    stltsa_decomposition_steps_reason(parts, 0);
    stltsa_decomposition_side(parts, 0);
    double likeness = 0;
    calls.make([&] { return stltsa_decomposition_label_likeness(parts, 0, 0, &likeness); });
    calls.make([&] { return stltsa_decomposition_first_step(parts, 0, nullptr, nullptr); });
    stltsa_decomposition_carrier(parts, 0, 0);
    stltsa_decomposition_reason(parts);
    stltsa_decomposition_warning(parts, 0);
    const std::int64_t counts =
        stltsa_decomposition_carrier_count(parts, 0) + stltsa_decomposition_cycle_count(parts) +
        stltsa_decomposition_part_count(parts, STLTSA_PART_CYCLE) +
        stltsa_decomposition_segment_count(parts) + stltsa_decomposition_summary_count(parts) +
        stltsa_decomposition_unit_count(parts) + stltsa_decomposition_warning_count(parts);
    return counts > 3 ? calls.status() : 1;
}

stltsa_status phases(const std::string&) {
    Calls calls;
    stltsa_phase* phase = nullptr;
    stltsa_cycles *cycles = nullptr, *between = nullptr;
    stltsa_events* events = nullptr;
    const double mark = 40, at[] = {3, 33, 63, 93};
    const std::int64_t groups[] = {0, 1, 0, 1, 0, 1, 0, 1};
    const stltsa_in signals = in(waves(), frames, 8), marks = in(&mark, 1, 1),
                    borders = in(at, 4, 1), of_columns = in(groups, 8, 1, STLTSA_I64);
    calls.make([&] { return stltsa_phase_find(kept().parts, nullptr, &phase); }, phase);
    calls.make([&] { return stltsa_cycles_resample(phase, 0, &signals, 20, &cycles); }, cycles);
    calls.make([&] { return stltsa_cycles_between(&borders, &signals, 20, &between); }, between);
    calls.make([&] { return stltsa_events_find(phase, &marks, phase, &events); }, events);
    stltsa_events_free(std::exchange(events, nullptr));
    calls.make([&] { return stltsa_events_find_with(phase, &marks, phase, nullptr, &events); },
               events);
    if (calls.good()) {
        const stltsa_out values = out(frames, 1), mean = out(20, 8), sd = out(20, 8, more_room);
        const std::int64_t count = stltsa_cycles_count(between);
        const stltsa_out total = out(count, 1), times = out(count, 20), of_groups = out(count, 2);
        stltsa_event event{};
        event.size = sizeof event;
        calls.make([&] { return stltsa_phase_values(phase, &values, nullptr, nullptr); });
        calls.make([&] { return stltsa_cycles_mean(between, &mean, &sd); });
        calls.make([&] { return stltsa_cycles_cycle(between, 0, &mean); });
        calls.make([&] { return stltsa_cycles_times(between, &times, nullptr); });
        calls.make([&] { return stltsa_cycles_distance(between, &total, nullptr); });
        calls.make([&] { return stltsa_events_event(events, 0, &event); });
        calls.make([&] { return stltsa_cycles_group_distance(between, &of_columns, &of_groups); });
        stltsa_events_likeness(events);
        stltsa_events_warning(events, 0);
        stltsa_phase_warning(phase, 0);
        double zero = 0;
        calls.make([&] { return stltsa_phase_zero(phase, 0, &zero); });
        stltsa_phase_column_owner(phase, 0);
        if (stltsa_events_count(events) + stltsa_events_warning_count(events) +
                stltsa_phase_warning_count(phase) + stltsa_phase_column_count(phase) <
            9)
            calls.make([] { return 1; });
    }
    stltsa_events_free(events);
    stltsa_cycles_free(between);
    stltsa_cycles_free(cycles);
    stltsa_phase_free(phase);
    return calls.status();
}

stltsa_status sides(const std::string&) {
    Calls calls;
    stltsa_cycles* cycles = nullptr;
    stltsa_comparison* comparison = nullptr;
    const double at[] = {3, 33, 63, 93};
    const char* names[] = {"hip_l",  "hip_r",  "knee_l",     "knee_r",
                           "foot_l", "foot_r", "shoulder_l", "shoulder_r"};
    const stltsa_in signals = in(waves(), frames, 8), borders = in(at, 4, 1);
    calls.make([&] { return stltsa_cycles_between(&borders, &signals, 20, &cycles); }, cycles);
    calls.make(
        [&] { return stltsa_cycles_compare_left_right(cycles, names, 0, nullptr, &comparison); },
        comparison);
    if (calls.good() && stltsa_comparison_part_count(comparison) != 4)
        calls.make([] { return 1; });
    stltsa_comparison_free(comparison);
    stltsa_cycles_free(cycles);
    return calls.status();
}

stltsa_status comparisons(const std::string&) {
    Calls calls;
    stltsa_comparison *of_motions = nullptr, *of_sides = nullptr;
    const stltsa_phase* phase = kept().phase;
    calls.make([&] { return stltsa_compare(phase, 0, phase, -1, 20, &of_motions); }, of_motions);
    stltsa_comparison_free(std::exchange(of_motions, nullptr));
    calls.make([&] { return stltsa_compare_with(phase, 0, phase, -1, 20, nullptr, &of_motions); },
               of_motions);
    // A matrix without names of sides: the reason takes memory, too.
    const stltsa_status sides =
        stltsa_compare_left_right(kept().matrix, phase, 0, 20, nullptr, &of_sides);
    if (calls.good() && sides != STLTSA_E_UNSUPPORTED)
        calls.make([&] { return sides; });
    if (calls.good()) {
        stltsa_compared_cycles cycles{};
        cycles.size = sizeof cycles;
        stltsa_compared_part part{};
        part.size = sizeof part;
        const std::int64_t channels = stltsa_comparison_channel_count(of_motions);
        const stltsa_out mean = out(20, channels);
        char* json = nullptr;
        calls.make([&] { return stltsa_comparison_cycles(of_motions, &cycles); });
        calls.make([&] { return stltsa_comparison_part(of_motions, 0, &part); });
        calls.make([&] { return stltsa_comparison_channel(of_motions, 0, &part); });
        calls.make([&] { return stltsa_comparison_curves(of_motions, 0, &mean, nullptr); });
        calls.make(
            [&] { return stltsa_comparison_difference(of_motions, &mean, nullptr, nullptr); });
        calls.make([&] { return stltsa_comparison_json(of_motions, &json); });
        note(json);
        stltsa_free(json);
        calls.make(
            [&] { return stltsa_comparison_report_save(of_motions, "stltsa", "/dev/null"); });
        if (stltsa_comparison_part_count(of_motions) != channels ||
            *stltsa_comparison_part_name(of_motions, 1, 0) != 'c' ||
            *stltsa_comparison_channel_axis(of_motions, 0) != 0 ||
            stltsa_comparison_left_out_count(of_motions, 0) != 0 ||
            *stltsa_comparison_left_out(of_motions, 1, 0) != 0 ||
            stltsa_comparison_warning(of_motions, stltsa_comparison_warning_count(of_motions)) ==
                nullptr)
            calls.make([] { return 1; });
    }
    stltsa_comparison_free(of_motions);
    stltsa_comparison_free(of_sides);
    return calls.status();
}

stltsa_status models(const std::string&) {
    Calls calls;
    stltsa_model* both = nullptr;
    const stltsa_clip* clips[] = {kept().matrix, kept().matrix};
    calls.make([&] { return stltsa_fit_clips(clips, 2, nullptr, &both); }, both);
    const stltsa_model* model = kept().model;
    std::int64_t rows = 0, dimension = 0, components = 0;
    const stltsa_info* info = stltsa_model_info(model);
    calls.make([&] { return stltsa_info_int(info, STLTSA_INFO_ROWS, 0, &rows); });
    calls.make([&] { return stltsa_info_int(info, STLTSA_INFO_DIMENSION, 0, &dimension); });
    calls.make([&] { return stltsa_info_int(info, STLTSA_INFO_COMPONENTS, 0, &components); });
    const stltsa_out coords = out(rows, dimension), values = out(components, dimension + 2),
                     labels = {room, rows, 1, 0, 0, STLTSA_I64, 0};
    const stltsa_in columns = in(waves(), frames, 8);
    const stltsa_out mapped = out(frames, dimension);
    char* json = nullptr;
    calls.make([&] { return stltsa_model_json(model, &json); }, json);
    note(json);
    stltsa_free(json);
    calls.make([&] { return stltsa_model_coords(model, &coords); });
    calls.make([&] { return stltsa_model_eigenvalues(model, &values); });
    calls.make([&] { return stltsa_model_components(model, &labels); });
    calls.make(
        [&] { return stltsa_map(model, &columns, nullptr, nullptr, &mapped, nullptr, nullptr); });
    read_facts(calls, info);
    stltsa_model_warning(model, stltsa_model_warning_count(model));
    stltsa_model_free(both);
    return calls.status();
}

stltsa_status streams(const std::string&) {
    Calls calls;
    stltsa_model* model = nullptr;
    stltsa_live* stream = nullptr;
    calls.make([&] { return stltsa_fit_clip(kept().matrix, nullptr, &model); }, model);
    calls.make([&] { return stltsa_model_keep_cycle(model, kept().phase); });
    calls.make([&] { return stltsa_model_keep_mark(model, kept().phase, 40, "a step, say"); });
    calls.make([&] { return stltsa_live_new(model, &stream); }, stream);
    if (calls.good() &&
        (stltsa_model_has_cycle(model) != 1 || stltsa_live_mark_count(stream) != 1 ||
         *stltsa_live_mark_name(stream, 0) != 'a'))
        calls.make([] { return 1; });
    stltsa_live_free(stream);
    stltsa_model_free(model);
    return calls.status();
}

stltsa_status denoise_model(const std::string&) {
    Calls calls;
    stltsa_denoising* denoising = nullptr;
    calls.make([&] { return stltsa_denoise_model(kept().model, nullptr, &denoising); }, denoising);
    if (calls.good()) {
        std::int64_t rows = 0, dimension = 0;
        const stltsa_info* info = stltsa_model_info(kept().model);
        calls.make([&] { return stltsa_info_int(info, STLTSA_INFO_ROWS, 0, &rows); });
        calls.make([&] { return stltsa_info_int(info, STLTSA_INFO_DIMENSION, 0, &dimension); });
        const stltsa_out points = out(rows, dimension), moves = out(rows, 1);
        calls.make([&] { return stltsa_denoising_curve(denoising, &points); });
        calls.make([&] { return stltsa_denoising_cleaned(denoising, &points); });
        stltsa_denoising_moves(denoising, &moves);
        read_facts(calls, stltsa_denoising_info(denoising));
    }
    stltsa_denoising_free(denoising);
    return calls.status();
}

stltsa_status loops(const std::string&) {
    static stltsa_decomposition* parts = [] {
        stltsa_decomposition* made = nullptr;
        if (stltsa_decompose(kept().body, nullptr, &made) != STLTSA_OK)
            std::abort();
        return made;
    }();
    Calls calls;
    stltsa_synthesis* loop = nullptr;
    calls.make([&] { return stltsa_synthesize_loop(kept().body, parts, nullptr, &loop); }, loop);
    if (calls.good()) {
        stltsa_seam seam{};
        seam.size = sizeof seam;
        calls.make([&] { return stltsa_synthesis_seam(loop, 0, &seam); });
        read_facts(calls, stltsa_synthesis_info(loop));
        stltsa_synthesis_warning(loop, stltsa_synthesis_warning_count(loop));
        if (stltsa_synthesis_seam_count(loop) < 1 ||
            stltsa_clip_frames(stltsa_synthesis_clip(loop)) < 1)
            calls.make([] { return 1; });
    }
    stltsa_synthesis_free(loop);
    return calls.status();
}

stltsa_status constants(const std::string&) {
    const bool good = stltsa_version_number() == STLTSA_VERSION_NUMBER &&
                      stltsa_version() != nullptr && stltsa_has(0) == 0 &&
                      stltsa_unit_name(1) != nullptr && stltsa_segment_name(1) != nullptr &&
                      stltsa_side_of_name("arm") < 0;
    return good ? STLTSA_OK : 1;
}

} // namespace

std::vector<Work> other_works() {
    return {{"options", options},
            {"describe clips", describe_clips},
            {"derive clips", derive_clips},
            {"dimensions", dimensions},
            {"read parts", read_parts},
            {"phases", phases},
            {"sides", sides},
            {"comparisons", comparisons},
            {"models", models},
            {"streams", streams},
            {"denoise model", denoise_model},
            {"loops", loops},
            {"constants", constants, false}};
}
