// SPDX-License-Identifier: BSD-3-Clause
#include "../small_c3d.h"
#include "calls.hpp"
#include "works.hpp"

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>

namespace {

constexpr std::int64_t frames = 150;

/// Rows of a table whose describe(index, &row) fails after the last.
template <class Row, class Describe>
std::int64_t rows_of(Describe describe) {
    Row row{};
    row.size = sizeof row;
    std::int64_t count = 0;
    while (describe(count, &row) == STLTSA_OK)
        ++count;
    return count;
}
const std::int64_t keys = rows_of<stltsa_info_key>(stltsa_info_describe),
                   all_options = rows_of<stltsa_option_info>(stltsa_option_describe);

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
        const stltsa_joint joints[] = {{"hip", -1, {0, 0, 0}, "rz rx ry", 0},
                                       {"knee", 0, {0, -4, 0}, "rz rx", 0},
                                       {"foot", 1, {0, -4, 1}, nullptr, 1}};
        const stltsa_in angles = in(waves(), 200, 5);
        const bool made =
            stltsa_clip_from_matrix(&columns, 30, &matrix) == STLTSA_OK &&
            stltsa_clip_from_points(&of_points, nullptr, &points) == STLTSA_OK &&
            stltsa_clip_from_skeleton(joints, sizeof *joints, 3, STLTSA_ROTATIONS_CHANNELS, &angles,
                                      nullptr, 30, &body) == STLTSA_OK &&
            stltsa_decompose(matrix, nullptr, &parts) == STLTSA_OK &&
            stltsa_phase_find(parts, nullptr, &phase) == STLTSA_OK &&
            fitted_clip(matrix, model) == STLTSA_OK;
        if (!made)
            std::abort();
    }
};
const Kept& kept() {
    static const Kept made;
    return made;
}

/// Reads the first value, row or array of a key.
stltsa_status read(const stltsa_info* info, const stltsa_info_key& key) {
    std::int64_t whole = 0, rows = 0, cols = 0;
    double real = 0;
    const char* text = nullptr;
    char row[1024];
    stltsa_status status = STLTSA_OK;
    switch (key.type) {
    case STLTSA_TYPE_INT:
        status = stltsa_info_int(info, key.key, 0, &whole);
        break;
    case STLTSA_TYPE_REAL:
        status = stltsa_info_real(info, key.key, 0, &real);
        break;
    case STLTSA_TYPE_TEXT:
        status = stltsa_info_text(info, key.key, 0, &text);
        break;
    case STLTSA_TYPE_ROWS: // it has addresses, which differ from run to run
        return stltsa_info_rows(info, key.key, 0, 1, row, sizeof row);
    default:
        status = stltsa_info_shape(info, key.key, &rows, &cols);
        if (status == STLTSA_OK) {
            const stltsa_out to = out(rows, cols);
            status = stltsa_info_array(info, key.key, 0, &to);
        }
    }
    note(&whole, sizeof whole);
    note(&real, sizeof real);
    note(text);
    return status;
}

/// Reads all that a handle says, and its JSON if there is any.
void read_all(Calls& calls, const stltsa_info* info, bool has_json = true) {
    stltsa_info_key key{};
    key.size = sizeof key;
    for (std::int64_t k = 0; k < keys; ++k) {
        calls.make([&] { return stltsa_info_describe(k, &key); });
        if (calls.good() && stltsa_info_count(info, key.key) > 0)
            calls.make([&] { return read(info, key); });
    }
    if (!has_json)
        return;
    char* json = nullptr;
    calls.make([&] { return stltsa_info_json(info, &json); }, json);
    note(json);
    stltsa_free(json);
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
    for (std::int64_t i = 0; i < all_options; ++i) {
        stltsa_option_info info{};
        info.size = sizeof info;
        calls.make([&] { return stltsa_option_describe(i, &info); });
        stltsa_options_is_set(made, info.key);
    }
    stltsa_options_free(made);
    return calls.status();
}

/// One of two subjects, whose names are too long for strings without memory.
stltsa_status choose_subject(const std::string&) {
    constexpr std::string_view table =
        "the first of two animals:heel_x,the first of two animals:heel_y,"
        "the second of two animals:heel_x,the second of two animals:heel_y\n"
        "1,2,3,4\n2,3,4,5\n3,4,5,6\n4,5,6,7\n";
    Calls calls;
    stltsa_options* made = nullptr;
    stltsa_clip* clip = nullptr;
    calls.make([&] { return stltsa_options_new(&made); }, made);
    calls.make([&] {
        return stltsa_options_set_text(made, STLTSA_OPT_SUBJECT, "the second of two animals");
    });
    calls.make(
        [&] {
            return stltsa_clip_parse(table.data(), table.size(), STLTSA_FORMAT_CSV, nullptr, made,
                                     &clip);
        },
        clip);
    const bool chosen =
        !calls.good() || whole_of(stltsa_clip_info(clip), STLTSA_INFO_CHANNELS) == 2;
    stltsa_clip_free(clip);
    stltsa_options_free(made);
    return chosen ? calls.status() : 1;
}

stltsa_status describe_clips(const std::string&) {
    Calls calls;
    std::int64_t count = 0;
    for (const stltsa_clip* clip : {kept().matrix, kept().points, kept().body}) {
        calls.make([&] { return stltsa_clip_feature_count(clip, nullptr, &count); });
        const stltsa_out features = out(stltsa_clip_frames(clip), count);
        calls.make([&] { return stltsa_clip_features(clip, nullptr, &features); });
        read_all(calls, stltsa_clip_info(clip));
    }
    unsigned char c3d[small_c3d_size];
    make_small_c3d(c3d);
    stltsa_clip* recording = nullptr;
    calls.make(
        [&] {
            return stltsa_clip_parse(c3d, sizeof c3d, STLTSA_FORMAT_C3D, nullptr, nullptr,
                                     &recording);
        },
        recording);
    if (calls.good())
        read_all(calls, stltsa_clip_info(recording));
    stltsa_clip_free(recording);
    return stltsa_clip_fps(kept().body) == 30 ? calls.status() : 1;
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
    stltsa_options* made = nullptr;
    stltsa_model* model = nullptr;
    const stltsa_in columns = in(waves(), frames, 8);
    calls.make([&] { return stltsa_options_new(&made); }, made);
    calls.make([&] { return stltsa_options_set_int(made, STLTSA_OPT_INTRINSIC, 1); });
    calls.make([&] { return stltsa_fit(&columns, nullptr, made, &model); }, model);
    if (calls.good())
        read_all(calls, stltsa_model_info(model));
    stltsa_model_free(model);
    stltsa_options_free(made);
    return calls.status();
}

stltsa_status read_parts(const std::string&) {
    Calls calls;
    stltsa_statistics statistics{};
    read_all(calls, stltsa_decomposition_info(kept().parts));
    calls.make([&] {
        return stltsa_decomposition_statistics(kept().parts, STLTSA_INFO_CYCLE, 0, -1,
                                               STLTSA_QUANTITY_TIME, &statistics);
    });
    return statistics.count > 3 || !calls.good() ? calls.status() : 1;
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
    calls.make([&] { return stltsa_cycles_resample(phase, 0, &signals, 20, nullptr, &cycles); },
               cycles);
    calls.make([&] { return stltsa_cycles_between(&borders, &signals, 20, nullptr, &between); },
               between);
    calls.make([&] { return stltsa_events_find(phase, &marks, phase, nullptr, &events); }, events);
    if (calls.good()) {
        const stltsa_out of_groups =
            out(stltsa_info_count(stltsa_cycles_info(between), STLTSA_INFO_VALUES), 2);
        calls.make([&] { return stltsa_cycles_group_distance(between, &of_columns, &of_groups); });
        read_all(calls, stltsa_phase_info(phase), false);
        read_all(calls, stltsa_cycles_info(between), false);
        read_all(calls, stltsa_events_info(events), false);
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
    calls.make([&] { return stltsa_cycles_between(&borders, &signals, 20, nullptr, &cycles); },
               cycles);
    calls.make(
        [&] { return stltsa_cycles_compare_left_right(cycles, names, 0, nullptr, &comparison); },
        comparison);
    if (calls.good() &&
        stltsa_info_count(stltsa_comparison_info(comparison), STLTSA_INFO_PART) != 4)
        calls.make([] { return 1; });
    stltsa_comparison_free(comparison);
    stltsa_cycles_free(cycles);
    return calls.status();
}

stltsa_status comparisons(const std::string&) {
    Calls calls;
    stltsa_comparison *of_motions = nullptr, *of_sides = nullptr;
    const stltsa_phase* phase = kept().phase;
    calls.make([&] { return stltsa_compare(phase, 0, phase, -1, 20, nullptr, &of_motions); },
               of_motions);
    // A matrix without names of sides: the reason takes memory, too.
    const stltsa_status sides =
        stltsa_compare_left_right(kept().matrix, phase, 0, 20, nullptr, &of_sides);
    if (calls.good() && sides != STLTSA_E_UNSUPPORTED)
        calls.make([&] { return sides; });
    if (calls.good()) {
        read_all(calls, stltsa_comparison_info(of_motions));
        calls.make([&] {
            return stltsa_comparison_report_save(of_motions, nullptr, "stltsa", "/dev/null");
        });
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
    const stltsa_in columns = in(waves(), frames, 8);
    const stltsa_out mapped =
        out(frames, whole_of(stltsa_model_info(model), STLTSA_INFO_DIMENSION));
    calls.make(
        [&] { return stltsa_map(model, &columns, nullptr, nullptr, &mapped, nullptr, nullptr); });
    read_all(calls, stltsa_model_info(model));
    stltsa_model_free(both);
    return calls.status();
}

stltsa_status streams(const std::string&) {
    Calls calls;
    stltsa_model* model = nullptr;
    stltsa_live* stream = nullptr;
    calls.make([&] { return fitted_clip(kept().matrix, model); }, model);
    calls.make([&] { return stltsa_model_keep_cycle(model, kept().phase, nullptr); });
    calls.make([&] { return stltsa_model_keep_mark(model, kept().phase, 40, "a step, say"); });
    calls.make([&] { return stltsa_live_new(model, &stream); }, stream);
    if (calls.good())
        read_all(calls, stltsa_live_info(stream), false);
    stltsa_live_free(stream);
    stltsa_model_free(model);
    return calls.status();
}

stltsa_status denoise_model(const std::string&) {
    Calls calls;
    stltsa_denoising* denoising = nullptr;
    calls.make([&] { return stltsa_denoise_model(kept().model, nullptr, &denoising); }, denoising);
    if (calls.good())
        read_all(calls, stltsa_denoising_info(denoising));
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
        read_all(calls, stltsa_synthesis_info(loop));
        if (stltsa_clip_frames(stltsa_synthesis_clip(loop)) < 1)
            calls.make([] { return 1; });
    }
    stltsa_synthesis_free(loop);
    return calls.status();
}

stltsa_status constants(const std::string&) {
    const bool good = stltsa_version() != nullptr && stltsa_has(0) == 0 &&
                      stltsa_unit_name(1) != nullptr && stltsa_segment_name(1) != nullptr &&
                      stltsa_side_of_name("arm") < 0;
    return good ? STLTSA_OK : 1;
}

} // namespace

std::vector<Work> other_works() {
    return {{"options", options},
            {"choose subject", choose_subject},
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
            {"batches", batches},
            {"constants", constants, false}};
}
