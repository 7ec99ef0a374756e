// SPDX-License-Identifier: BSD-3-Clause
// stltsa.hpp: compares each of its functions with the C functions or with known results.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>
#include <type_traits>

#include <stltsa.hpp>

#include "../rooms/assertions.hpp"

namespace {

using stltsa::Clip;
using stltsa::Matrix;
using stltsa::Model;
using stltsa::Options;

std::string walker_path; // set by main()

/// The status of the Error thrown by a call; STLTSA_OK if none was thrown.
template <class Call>
stltsa_status status_of(Call call) {
    try {
        call();
    } catch (const stltsa::Error& error) {
        assert_true(std::strlen(error.what()) > 0);
        return error.status();
    }
    return STLTSA_OK;
}

const Clip& walker() {
    static const Clip clip = Clip::open(walker_path);
    return clip;
}

/// Turns of a helix, 40 frames each.
Matrix helix(std::int64_t frames) {
    Matrix rows(frames, 3);
    for (std::int64_t i = 0; i < frames; ++i) {
        const double t = static_cast<double>(i) * std::numbers::pi / 20;
        rows(i, 0) = std::cos(t);
        rows(i, 1) = std::sin(t);
        rows(i, 2) = 0.1 * t;
    }
    return rows;
}

Options narrow() {
    Options options;
    options.set(STLTSA_OPT_NEIGHBORS, 12).set(STLTSA_OPT_DIMENSION, 2);
    return options;
}

/// A file in the directory of the test run; removed at the end.
class File {
  public:
    explicit File(const char* name) : name_(name) {}
    ~File() { std::remove(name_.c_str()); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    const std::string& name() const { return name_; }

  private:
    std::string name_;
};

std::vector<std::byte> bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

bool is_object(const std::string& json, const std::string& kind, int schema = 1) {
    return json.starts_with("{\"format\":\"stltsa-" + kind + "/" + std::to_string(schema) + "\"") &&
           json.ends_with('}');
}

void names_and_versions_are_those_of_the_library(void**) {
    assert_string_equal(stltsa::version().c_str(), stltsa_version());
    assert_int_equal(stltsa::has(STLTSA_HAS_CHOLMOD), stltsa_has(STLTSA_HAS_CHOLMOD));
    assert_false(stltsa::has(0));
    assert_string_equal(stltsa::status_name(STLTSA_E_SHAPE).c_str(), "STLTSA_E_SHAPE");
    assert_string_equal(stltsa::unit_name(STLTSA_UNIT_WIND_UP).c_str(), "wind-up");
}

void an_error_has_status_name_and_text(void**) {
    try {
        Clip::open("absent.bvh");
        FAIL("no Error was thrown");
    } catch (const stltsa::Error& error) {
        assert_int_equal(error.status(), STLTSA_E_IO);
        assert_string_equal(error.name(), "STLTSA_E_IO");
        assert_non_null(std::strstr(error.what(), "absent.bvh"));
    }
}

void a_matrix_is_read_by_rows_and_columns(void**) {
    Matrix matrix(2, 3);
    matrix(1, 2) = 7;
    assert_float_equal(matrix.values[5], 7, 0);
    assert_float_equal(std::as_const(matrix)(1, 2), 7, 0);
    assert_int_equal(matrix.row(1).size(), 3);
    assert_float_equal(matrix.row(1)[2], 7, 0);
    assert_int_equal(Matrix().values.size(), 0);
}

/// The same numbers in four forms: owned, as float64 and float32, and as columns with strides.
void views_of_the_same_numbers_are_the_same_clip(void**) {
    const Matrix rows = helix(50);
    const std::vector<float> small(rows.values.begin(), rows.values.end());
    std::vector<double> by_columns(rows.values.size());
    for (std::int64_t r = 0; r < 50; ++r)
        for (std::int64_t c = 0; c < 3; ++c)
            by_columns[static_cast<std::size_t>(c * 50 + r)] = rows(r, c);
    const stltsa_in strided{by_columns.data(), 50, 3, 8, 50 * 8, STLTSA_F64, 0};
    const std::array views{stltsa::MatrixView(rows), stltsa::MatrixView(rows.values, 3),
                           stltsa::MatrixView(small, 3), stltsa::MatrixView(strided)};
    for (const stltsa::MatrixView& view : views) {
        assert_int_equal(view.rows(), 50);
        const Matrix back = Clip::from_matrix(view, 30).features();
        assert_int_equal(back.rows, 50);
        assert_int_equal(back.cols, 3);
        for (std::size_t i = 0; i < back.values.size(); ++i)
            ASSERT_NEAR(back.values[i], rows.values[i], view.get() == views[2].get() ? 1e-6 : 0);
    }
    assert_int_equal(status_of([&] { stltsa::MatrixView(rows.values, 4); }), STLTSA_E_SHAPE);
    assert_int_equal(status_of([&] { stltsa::MatrixView(small, 0); }), STLTSA_E_SHAPE);
}

void the_option_table_has_every_option(void**) {
    const std::vector<stltsa::OptionInfo> table = stltsa::option_table();
    stltsa_option_info row{};
    row.size = sizeof row;
    assert_int_equal(stltsa_option_describe(static_cast<std::int64_t>(table.size()) - 1, &row),
                     STLTSA_OK);
    assert_int_equal(stltsa_option_describe(static_cast<std::int64_t>(table.size()), &row),
                     STLTSA_E_ARGUMENT);
    assert_int_equal(table[0].key, STLTSA_OPT_NEIGHBORS);
    assert_string_equal(table[0].name, "neighbors");
}

void options_are_set_and_read_back(void**) {
    Options options;
    assert_null(options.get());
    assert_int_equal(options.integer(STLTSA_OPT_LINKS), 4); // the default
    options.set(STLTSA_OPT_LINKS, 5).set(STLTSA_OPT_FPS, 120.0).set(STLTSA_OPT_SKELETON, "a.asf");
    options.set(STLTSA_OPT_KEEP_START, true).set(STLTSA_OPT_SMOOTHING, 0.5F);
    assert_int_equal(options.integer(STLTSA_OPT_LINKS), 5);
    assert_int_equal(options.integer(STLTSA_OPT_KEEP_START), 1);
    assert_float_equal(options.real(STLTSA_OPT_FPS), 120, 0);
    assert_float_equal(options.real(STLTSA_OPT_SMOOTHING), 0.5, 0);
    assert_string_equal(options.text(STLTSA_OPT_SKELETON).c_str(), "a.asf");
    assert_true(options.is_set(STLTSA_OPT_FPS) && !options.is_set(STLTSA_OPT_WINDOW));
    options.unset(STLTSA_OPT_FPS);
    assert_false(options.is_set(STLTSA_OPT_FPS));
    assert_int_equal(status_of([&] { options.set(STLTSA_OPT_LINKS, 0); }), STLTSA_E_ARGUMENT);
    assert_int_equal(status_of([&] { options.set(STLTSA_OPT_LINKS, 1.0); }), STLTSA_E_ARGUMENT);
    const Options moved = std::move(options);
    assert_int_equal(moved.integer(STLTSA_OPT_LINKS), 5);
}

void progress_is_told_and_cancels(void**) {
    int calls = 0;
    Options options = narrow();
    options.set_progress([&](std::int32_t stage, double fraction) {
        assert_in_range(stage, STLTSA_STAGE_READ, STLTSA_STAGE_WRITE);
        assert_true(fraction >= 0 && fraction <= 1);
        ++calls;
        return false;
    });
    const Options moved = std::move(options);
    stltsa::fit(helix(200), moved);
    assert_true(calls > 0);

    Options cancelling = narrow();
    cancelling.set_progress([](std::int32_t, double) { return true; });
    assert_int_equal(status_of([&] { stltsa::fit(helix(200), cancelling); }), STLTSA_E_CANCELLED);
    cancelling.set_progress(nullptr);
    assert_int_equal(status_of([&] { stltsa::fit(helix(200), cancelling); }), STLTSA_OK);
}

void what_a_progress_callback_throws_comes_out_of_the_call(void**) {
    Options options = narrow();
    options.set_progress([](std::int32_t, double) -> bool { throw std::out_of_range("mine"); });
    bool caught = false;
    try {
        stltsa::fit(helix(200), options);
    } catch (const std::out_of_range& mine) {
        caught = std::string(mine.what()) == "mine";
    }
    assert_true(caught);
    // It is thrown once: the next failure is the library's own.
    assert_int_equal(status_of([] { Clip::open("absent.bvh"); }), STLTSA_E_IO);
}

void a_clip_has_frames_joints_and_poses(void**) {
    const Clip& clip = walker();
    assert_int_equal(clip.frames(), stltsa_clip_frames(clip.get()));
    assert_true(clip.frames() > 100);
    assert_float_equal(clip.fps(), stltsa_clip_fps(clip.get()), 0);
    const std::vector<stltsa::Joint> joints = clip.joints();
    const auto count = static_cast<std::int64_t>(joints.size());
    assert_int_equal(joints.size(), clip.info().count(STLTSA_INFO_JOINT));
    assert_int_equal(joints[0].parent, -1);
    assert_false(joints[0].is_end_site);
    assert_true(joints.back().is_end_site);

    const Matrix positions = clip.positions();
    assert_int_equal(positions.rows, clip.frames());
    assert_int_equal(positions.cols, 3 * count);
    const Matrix rotations = clip.rotations();
    assert_int_equal(rotations.cols, 4 * count);
    double norm = 0;
    for (std::int64_t c = 0; c < 4; ++c)
        norm += rotations(7, c) * rotations(7, c);
    ASSERT_NEAR(norm, 1, 1e-12);

    Options raw;
    raw.set(STLTSA_OPT_FEATURES, STLTSA_FEATURES_RAW);
    assert_int_equal(clip.feature_count(raw), clip.info().integer(STLTSA_INFO_CHANNELS));
    assert_int_equal(clip.features(raw).cols, clip.feature_count(raw));
    assert_int_equal(clip.features().cols, clip.feature_count());
    assert_true(is_object(clip.json(), "clip"));
}

void a_clip_is_saved_and_parsed_again(void**) {
    const File file("wrapper_saved.bvh");
    walker().save(file.name());
    const std::vector<std::byte> bytes = bytes_of(file.name());
    for (const std::int32_t format : {0, static_cast<int>(STLTSA_FORMAT_BVH)}) {
        const Clip back = Clip::parse(bytes, format);
        assert_int_equal(back.frames(), walker().frames());
        assert_true(back.positions().values == walker().positions().values);
    }
    assert_int_equal(status_of([&] { Clip::parse(bytes, STLTSA_FORMAT_NPY); }), STLTSA_E_FORMAT);
    assert_int_equal(status_of([] { walker().save("wrapper.txt"); }), STLTSA_E_ARGUMENT);
}

void handles_move_and_are_not_copied(void**) {
    static_assert(!std::is_copy_constructible_v<Clip> && std::is_nothrow_move_assignable_v<Clip>);
    static_assert(!std::is_copy_constructible_v<Model> && std::is_nothrow_move_assignable_v<Model>);
    static_assert(!std::is_copy_constructible_v<Options>);
    Clip clip = Clip::from_matrix(helix(10), 30);
    const Clip moved = std::move(clip);
    assert_null(clip.get()); // NOLINT: the test is about this use
    assert_int_equal(moved.frames(), 10);
}

void a_model_has_facts_coordinates_and_components(void**) {
    const Matrix frames = helix(200);
    const Model model = stltsa::fit(frames, narrow());
    assert_int_equal(model.info().integer(STLTSA_INFO_ROWS), 200);
    assert_int_equal(model.info().integer(STLTSA_INFO_NEIGHBORS), 12);
    assert_int_equal(model.components().size(), 1);
    assert_true(model.components()[0].residual < 1e-6);
    const Matrix coords = model.coords();
    assert_int_equal(coords.rows, 200);
    assert_int_equal(coords.cols, 2);
    const Matrix eigenvalues = model.eigenvalues();
    assert_int_equal(eigenvalues.rows, 1);
    assert_int_equal(eigenvalues.cols, 4);
    assert_true(eigenvalues(0, 1) < eigenvalues(0, 3));
    assert_true(is_object(model.json(), "model"));

    const Model two = stltsa::fit(frames, narrow(), std::array<std::int64_t, 2>{120, 80});
    assert_int_equal(two.components().size(), 2);
    assert_int_equal(two.component_of().size(), 200);
    assert_int_equal(two.component_of()[119], 0);
    assert_int_equal(two.component_of()[120], 1);

    // One coordinate of a helix only follows time.
    const Model one = stltsa::fit(frames, narrow().set(STLTSA_OPT_DIMENSION, 1));
    assert_int_equal(one.warnings().size(), 1);
    assert_int_equal(one.warnings()[0].code, STLTSA_WARNING_FOLLOWS_TIME);
}

void frames_are_mapped_and_come_back(void**) {
    const Matrix frames = helix(200);
    const Model model = stltsa::fit(frames, narrow());
    const stltsa::Mapped there = model.map(frames);
    assert_true(there.values.values == model.coords().values);
    assert_int_equal(there.nearest[17], 17);
    ASSERT_NEAR(there.distance[17], 0, 1e-9);
    const std::vector<std::int64_t> hints(200, 17);
    assert_true(model.map(frames, {}, hints).nearest[180] < 40);

    const stltsa::Mapped back = model.unmap(there.values);
    for (std::size_t i = 0; i < frames.values.size(); ++i)
        ASSERT_NEAR(back.values.values[i], frames.values[i], 1e-6);
    assert_int_equal(model.unmap(there.values, {}, back.nearest).nearest[100], 100);
    const auto few = std::span(hints).first(3);
    assert_int_equal(status_of([&] { model.map(frames, {}, few); }), STLTSA_E_SHAPE);
    assert_int_equal(status_of([&] { model.unmap_clip(there.values); }), STLTSA_E_UNSUPPORTED);
}

void a_model_of_a_clip_maps_clips_and_gives_poses(void**) {
    Options options;
    options.set(STLTSA_OPT_SAMPLE_RATE, 0.0).set(STLTSA_OPT_DIMENSION, 2);
    const Model model = stltsa::fit(walker(), options);
    const stltsa::Mapped mapped = model.map(walker());
    assert_int_equal(mapped.values.rows, walker().frames());
    constexpr int walking = 300; // a row unlike all others
    const auto first = static_cast<std::size_t>(model.info().integer(STLTSA_INFO_FIRST_FRAME));
    assert_true(mapped.values.row(static_cast<std::int64_t>(first + walking))[0] ==
                model.coords().row(walking)[0]);
    assert_int_equal(mapped.nearest[first + walking], walking);
    ASSERT_NEAR(mapped.distance[first + walking], 0, 1e-9);

    const stltsa::Poses poses = model.unmap_clip(mapped.values);
    assert_int_equal(poses.clip.frames(), walker().frames());
    assert_int_equal(poses.clip.joints().size(), walker().joints().size());
    assert_int_equal(poses.nearest.size(), walker().frames());
    assert_true(poses.distance[first + walking] < 1);
    const stltsa::Poses hinted = model.unmap_clip(mapped.values, {}, mapped.nearest);
    assert_int_equal(hinted.nearest[first + walking], walking);
}

void a_model_is_the_same_from_bytes_and_from_a_file(void**) {
    const File file("wrapper.stltsa");
    const Model model = stltsa::fit(helix(100), narrow());
    model.save(file.name());
    const std::vector<std::byte> bytes = model.serialize();
    assert_true(bytes == bytes_of(file.name()));
    assert_true(Model::load(file.name()).coords().values == model.coords().values);
    assert_true(Model::parse(bytes).coords().values == model.coords().values);
    const auto cut = std::span(bytes).first(bytes.size() / 2);
    assert_int_equal(status_of([&] { Model::parse(cut); }), STLTSA_E_FORMAT);
    assert_int_equal(status_of([] { Model::load("absent.stltsa"); }), STLTSA_E_IO);
}

void a_clip_is_cut_into_units_and_cycles(void**) {
    const stltsa::Decomposition found = stltsa::decompose(walker());
    const std::vector<stltsa::Unit> units = found.units();
    assert_int_equal(units.size(), 5);
    assert_int_equal(units[0].begin, 0);
    assert_int_equal(units.back().end, walker().frames());
    assert_int_equal(units[1].begin, units[0].end);
    const std::vector<stltsa::Part> cycles = found.cycles();
    assert_int_equal(cycles.size(), 3);
    assert_int_equal(cycles[2].begin, cycles[1].end);

    const std::int64_t samples = found.info().integer(STLTSA_INFO_ROWS);
    assert_true(samples > 0);
    assert_true(found.info().real(STLTSA_INFO_PERIOD) > 0.3);
    assert_int_equal(found.curve().rows, samples);
    assert_int_equal(found.curve().cols, 1);
    assert_int_equal(found.coords().rows, samples);
    assert_int_equal(found.coords().cols, 2);
    assert_string_equal(found.reason().c_str(), "");
    assert_true(is_object(found.json(), "decomposition", 2));
}

void what_has_no_cycles_has_a_reason_and_warnings_are_told(void**) {
    Matrix still(200, 2);
    for (std::int64_t i = 0; i < 200; ++i)
        still(i, 0) = i < 100 ? 1e-9 * static_cast<double>(i) : static_cast<double>(i);
    const stltsa::Decomposition found = stltsa::decompose(Clip::from_matrix(still, 30));
    assert_true(found.cycles().empty());
    assert_true(found.reason().size() > 0);
    assert_int_equal(found.warnings().size(), found.info().count(STLTSA_INFO_WARNING));
}

void coordinates_are_denoised(void**) {
    Matrix noisy(120, 2);
    for (std::int64_t i = 0; i < 120; ++i) {
        noisy(i, 0) = std::sin(0.1 * static_cast<double>(i));
        noisy(i, 1) = i == 60 ? 1 : 0.01 * static_cast<double>(i % 3);
    }
    const stltsa::Denoising clean = stltsa::denoise(noisy);
    assert_int_equal(clean.info().integer(STLTSA_INFO_ROWS), 120);
    const std::vector<stltsa::DenoisedColumn> columns = clean.columns();
    assert_int_equal(columns.size(), 2);
    assert_true(columns[1].moved >= 1);
    assert_true(columns[1].noise > columns[0].noise);
    const Matrix curve = clean.curve();
    const Matrix cleaned = clean.cleaned();
    const Matrix moves = clean.moves();
    assert_int_equal(curve.rows, 120);
    assert_int_equal(curve.cols, 2);
    assert_true(moves(60, 1) != 0);
    ASSERT_NEAR(cleaned(60, 1), noisy(60, 1) + moves(60, 1), 1e-12);
    assert_true(std::fabs(curve(60, 1)) < 0.5);
    assert_true(is_object(clean.json(), "denoising"));
    const std::array<std::int64_t, 2> short_clips{115, 5};
    assert_int_equal(status_of([&] { stltsa::denoise(noisy, {}, short_clips); }),
                     STLTSA_E_TOO_FEW_FRAMES);

    const Model model = stltsa::fit(helix(100), narrow());
    assert_int_equal(stltsa::denoise(model).info().integer(STLTSA_INFO_ROWS), 100);
}

void pieces_become_a_new_clip(void**) {
    const stltsa::Decomposition found = stltsa::decompose(walker());
    const stltsa::Part cycle = found.cycles()[1];
    const std::array pieces{walker().piece(0, cycle.end),
                            walker().piece(cycle.begin, cycle.end, 3)};
    stltsa::Synthesis first = stltsa::synthesize(pieces);
    const stltsa::Synthesis made = std::move(first);
    assert_ptr_equal(made.clip().get(), stltsa_synthesis_clip(made.get()));
    assert_true(made.clip().frames() > cycle.end);
    const std::vector<stltsa::Seam> seams = made.seams();
    assert_int_equal(seams.size(), 3);
    assert_int_equal(seams[0].piece, 0);
    assert_int_equal(seams[0].next, 1);
    assert_int_equal(seams[2].piece, 1);
    assert_int_equal(made.warnings().size(), made.info().count(STLTSA_INFO_WARNING));
    assert_true(is_object(made.json(), "synthesis"));
    assert_int_equal(status_of([] { stltsa::synthesize({}); }), STLTSA_E_ARGUMENT);
}

void facts_are_told_by_key(void**) {
    const stltsa::Decomposition found = stltsa::decompose(walker());
    const stltsa::Info info = found.info();
    assert_int_equal(info.integer(STLTSA_INFO_FORMAT), STLTSA_FORMAT_BVH);
    assert_int_equal(info.integers(STLTSA_INFO_CLIP_FRAMES).at(0), walker().frames());
    assert_true(info.real(STLTSA_INFO_CLIP_FPS) == walker().fps());
    assert_string_equal(info.text(STLTSA_INFO_PATH).c_str(),
                        walker().info().text(STLTSA_INFO_PATH).c_str());
    assert_int_equal(info.reals(STLTSA_INFO_EIGENVALUE).size(),
                     info.integer(STLTSA_INFO_DIMENSION) + 2);
    assert_int_equal(walker().info().texts(STLTSA_INFO_CHANNEL).size(),
                     walker().info().integer(STLTSA_INFO_CHANNELS));
    assert_int_equal(info.count(STLTSA_INFO_LIKENESS), 0);
    assert_int_equal(status_of([&] { info.real(STLTSA_INFO_LIKENESS); }), STLTSA_E_ARGUMENT);
    assert_true(info.rows<stltsa::Seam>(STLTSA_INFO_SEAM).empty());
    assert_int_equal(status_of([&] { info.array(STLTSA_INFO_PHASE); }), STLTSA_E_ARGUMENT);

    const stltsa::Model model = stltsa::fit(walker());
    assert_int_equal(model.info().integers(STLTSA_INFO_LENGTH).at(0), model.coords().rows);
    const std::array clips{Clip::open(walker_path), Clip::open(walker_path)};
    assert_int_equal(stltsa::fit(clips).info().count(STLTSA_INFO_LENGTH), 2);
    Options intrinsic;
    intrinsic.set(STLTSA_OPT_INTRINSIC, true);
    assert_true(stltsa::fit(walker(), intrinsic).info().integer(STLTSA_INFO_LOCAL_PCA) >= 1);
    const std::array pieces{walker().piece(0, 50)};
    const stltsa::Synthesis made = stltsa::synthesize(pieces);
    assert_int_equal(made.info().rows<stltsa::PieceFact>(STLTSA_INFO_PIECE).at(0).end, 50);

    const std::vector<stltsa::InfoKey> keys = stltsa::info_table();
    assert_true(keys.size() > 100);
    assert_string_equal(keys.at(0).name, "path");
    assert_true(std::string(keys.back().name) != keys[keys.size() - 2].name);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2)
        return 2;
    walker_path = argv[1];
    const CMUnitTest tests[] = {
        cmocka_unit_test(names_and_versions_are_those_of_the_library),
        cmocka_unit_test(facts_are_told_by_key),
        cmocka_unit_test(an_error_has_status_name_and_text),
        cmocka_unit_test(a_matrix_is_read_by_rows_and_columns),
        cmocka_unit_test(views_of_the_same_numbers_are_the_same_clip),
        cmocka_unit_test(the_option_table_has_every_option),
        cmocka_unit_test(options_are_set_and_read_back),
        cmocka_unit_test(progress_is_told_and_cancels),
        cmocka_unit_test(what_a_progress_callback_throws_comes_out_of_the_call),
        cmocka_unit_test(a_clip_has_frames_joints_and_poses),
        cmocka_unit_test(a_clip_is_saved_and_parsed_again),
        cmocka_unit_test(handles_move_and_are_not_copied),
        cmocka_unit_test(a_model_has_facts_coordinates_and_components),
        cmocka_unit_test(frames_are_mapped_and_come_back),
        cmocka_unit_test(a_model_of_a_clip_maps_clips_and_gives_poses),
        cmocka_unit_test(a_model_is_the_same_from_bytes_and_from_a_file),
        cmocka_unit_test(a_clip_is_cut_into_units_and_cycles),
        cmocka_unit_test(what_has_no_cycles_has_a_reason_and_warnings_are_told),
        cmocka_unit_test(coordinates_are_denoised),
        cmocka_unit_test(pieces_become_a_new_clip),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
