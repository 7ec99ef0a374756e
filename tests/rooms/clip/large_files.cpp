// SPDX-License-Identifier: BSD-3-Clause
// Large files: reading and writing them can be cancelled.
#include "checkpoints.hpp"
#include "clip/testing.hpp"

#include <filesystem>

#include "clip/features/features.hpp"
#include "clip/formats.hpp"
#include "clip/write.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

std::string repeated(std::string_view row, std::size_t bytes) {
    std::string text;
    while (text.size() < bytes)
        text += row;
    return text;
}

/// Each text has 3 MB, and an error that is found at its end, unless the reading is cancelled.
void reading_a_large_text_can_be_cancelled(void**) {
    constexpr std::size_t size = 3 << 20;
    const TemporaryFolder folder;
    const std::string asf = folder.write("small.asf", small_asf);
    const std::string large_asf = folder.write("large.asf", repeated("# comment\n", size));
    const std::string amc = ":DEGREES\n" + repeated("# comment\n", size);
    const std::string bvh = small_bvh + repeated("0 0 0 0 0 0 0 0 0 0\n", size);
    struct Case {
        Format format;
        std::string text, skeleton;
        int checkpoints;
    } const cases[] = {{Format::csv, repeated("1,2,3\n", size) + "x\n", "", 2},
                       {Format::bvh, bvh, "", 2},
                       {Format::amc, amc, asf, 2},
                       {Format::amc, amc, large_asf, 50}}; // 48 while the skeleton's file is read
    for (const Case& one : cases) {
        ReadOptions options;
        options.skeleton = one.skeleton;
        ASSERT_FAILS(Status::cancelled, "cancelled", testing::cancel_at(one.checkpoints, [&] {
                         parse(one.text, one.format, "large", options);
                     }));
    }
}

/// There is a checkpoint in each mebibyte of the text; then the numbers are copied twice, with two
/// checkpoints each.
void reading_wide_rows_has_checkpoints_to_the_end(void**) {
    std::string text = "time";
    for (int c = 0; c < 10000; ++c)
        text += ",c" + std::to_string(c);
    for (int row = 0; row < 900; ++row)
        text += "\n" + std::to_string(row) + repeated(",1", 20000);
    const int checkpoints = testing::checkpoints_of(
        [&] { assert_int_equal(parse(text, Format::csv).values.cols(), 10000); });
    assert_in_range(checkpoints, (text.size() >> 20) + 4, 1000);
}

int checkpoints_of_features(const Clip& clip) {
    return testing::checkpoints_of([&] { feature_rows(clip, {}, {}); });
}

void features_have_checkpoints(void**) {
    Clip clip = parse(small_bvh, Format::bvh);
    clip.values = stltsa::Matrix(200000, clip.values.cols());
    assert_in_range(checkpoints_of_features(clip), 40, 1000);
    Clip points;
    points.space = 3;
    points.fps = 100;
    points.values = stltsa::Matrix(400000, 12);
    for (std::int64_t i = 0; i < points.frames(); ++i)
        for (std::int64_t c = 0; c < points.values.cols(); ++c)
            points.values(i, c) =
                static_cast<double>(c * c) + std::sin(0.1 * static_cast<double>(i + c));
    assert_in_range(checkpoints_of_features(points), 7, 1000);
    for (std::int64_t i = 1000; i < 100000; ++i)
        std::fill_n(points.values.row(i), 3, NAN);
    assert_in_range(checkpoints_of_features(points), 13, 1000); // also while gaps are predicted
}

void reading_a_large_file_can_be_cancelled(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.write("large.csv", repeated("1,2,3\n", 1 << 20));
    // Parsing has one.
    ASSERT_FAILS(Status::cancelled, "cancelled", testing::cancel_at(10, [&] { read(path, {}); }));
}

void reading_a_large_array_can_be_cancelled(void**) {
    Clip clip;
    clip.values = stltsa::Matrix(1 << 21, 2);
    const std::string bytes = find_format(Format::npy)->write(clip);
    // Two while numbers are converted, one while they are checked.
    ASSERT_FAILS(Status::cancelled, "cancelled",
                 testing::cancel_at(3, [&] { parse(bytes, Format::npy); }));
}

/// The clips are large enough for that many checkpoints.
void making_a_large_text_can_be_cancelled(void**) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.skeleton = folder.write("a.asf", small_asf);
    for (Clip clip : {parse(small_bvh, Format::bvh), parse(small_amc, Format::amc, options)}) {
        clip.values = stltsa::Matrix(200000, clip.values.cols());
        for (const Format format : {clip.format, Format::csv, Format::bvh, Format::glb}) {
            // GLB has a checkpoint for each joint; from AMC to BVH, rotations are converted first.
            const bool converted = clip.format == Format::amc && format == Format::bvh;
            const int n = format == Format::glb ? 3 : converted ? 80 : 10;
            ASSERT_FAILS(Status::cancelled, "cancelled",
                         testing::cancel_at(n, [&] { find_format(format)->write(clip); }));
        }
    }
}

void writing_a_large_file_can_be_cancelled(void**) {
    const TemporaryFolder folder;
    Clip clip;
    clip.fps = 100;
    clip.values = stltsa::Matrix(1 << 19, 1); // 4 MiB
    ASSERT_FAILS(Status::cancelled, "cancelled",
                 testing::cancel_at(4, [&] { write(clip, folder.path("a.npy")); }));
    assert_true(std::filesystem::is_empty(folder.path("")));
}

/// Cancelled after the skeleton was written through a link to a file that did not exist.
void cancelling_removes_what_was_written_and_keeps_the_link(void**) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.skeleton = folder.write("small.asf", small_asf);
    const Clip clip = parse(small_amc, Format::amc, options);
    std::filesystem::create_symlink("target", folder.path("a.asf"));
    ASSERT_FAILS(Status::cancelled, "cancelled",
                 testing::cancel_at(2, [&] { write(clip, folder.path("a.amc")); }));
    assert_true(std::filesystem::is_symlink(folder.path("a.asf")));
    assert_false(std::filesystem::exists(folder.path("target")));
    assert_false(std::filesystem::exists(folder.path("a.amc")));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(reading_a_large_text_can_be_cancelled),
        cmocka_unit_test(reading_wide_rows_has_checkpoints_to_the_end),
        cmocka_unit_test(features_have_checkpoints),
        cmocka_unit_test(reading_a_large_file_can_be_cancelled),
        cmocka_unit_test(reading_a_large_array_can_be_cancelled),
        cmocka_unit_test(making_a_large_text_can_be_cancelled),
        cmocka_unit_test(writing_a_large_file_can_be_cancelled),
        cmocka_unit_test(cancelling_removes_what_was_written_and_keeps_the_link),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
