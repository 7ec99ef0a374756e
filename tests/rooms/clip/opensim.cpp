// SPDX-License-Identifier: BSD-3-Clause
// TRC, MOT and STO files.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>

#include "clip/features/points.hpp"
#include "clip/formats.hpp"

namespace {

using namespace clip_testing;
using stltsa::format_text;
using stltsa::clip::Axis;
using stltsa::clip::ReadOptions;

bool says(const Clip& clip, std::string_view part) {
    return std::ranges::any_of(
        clip.notes, [part](const std::string& note) { return note.find(part) != note.npos; });
}

using Names = std::vector<std::string>;

const std::string trc_keys =
    "PathFileType\t4\t(X/Y/Z)\tx.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\t"
    "OrigDataRate\tOrigDataStartFrame\tOrigNumFrames\n";
const std::string trc_names =
    "Frame#\tTime\tLeft Hip\t\t\tToe\t\t\t\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n";
const std::string trc_rows =
    "1\t3.00\t1\t2\t3\t4\t5\t6\n2\t3.02\t1\t2\t3\t\t\t\n3\t3.04\t7\t8\t9\t4\t5\t6\n";

std::string trc(const std::string& values, const std::string& rows = trc_rows) {
    return trc_keys + values + "\n" + trc_names + rows;
}

void check_walk(const Clip& clip) {
    assert_int_equal(clip.frames(), 3);
    assert_true(clip.space == 3 && clip.fps == 50 && clip.up == Axis::y);
    assert_true(clip.channel_names ==
                (Names{"Left Hip_x", "Left Hip_y", "Left Hip_z", "Toe_x", "Toe_y", "Toe_z"}));
    assert_true(clip.values(2, 0) == 7 && clip.values(0, 5) == 6 && std::isnan(clip.values(1, 3)));
}

void markers(void**) {
    const Clip clip = parse(trc("50\t50\t3\t2\tmm\t50\t1\t3"), Format::trc);
    check_walk(clip);
    assert_string_equal(clip.unit.c_str(), "mm");
    assert_true(says(clip, "up axis: y"));
    assert_true(stltsa::clip::points_up(clip) == Axis::y);
    assert_false(says(clip, "the header says"));
}

/// Byte order mark, Windows lines, commas, 7 values for 8 keys, no line of axes, rates that are no
/// numbers or 0, NaN, cells left out at the end.
void dialects_of_trc(void**) {
    const std::string text = trc("50\t50\t3\t2\tmm\t50\t1\t3");
    check_walk(parse("\xEF\xBB\xBF" + text, Format::trc));
    std::string other = text;
    std::ranges::replace(other, '\t', ',');
    check_walk(parse(other, Format::trc));
    std::string windows;
    for (const char c : text)
        windows += c == '\n' ? "\r\n" : std::string(1, c);
    check_walk(parse(windows, Format::trc));
    for (const char* values :
         {"0\t0\t3\t2\tm\t0\t1\t3", "50 Hz\t50\t3\t2\tmm\t50\t1", "\t\t\t", "50\t50\t3\t2\tmm"})
        check_walk(parse(trc(values), Format::trc));
    for (const char* gap : {"2\t3.02\t1\t2\t3\n", "2\t3.02\t1\t2\t3\tNaN\tnan\t-nan(ind)\n"})
        check_walk(parse(trc("50", "1\t3.00\t1\t2\t3\t4\t5\t6\n" + std::string(gap) +
                                       "3\t3.04\t7\t8\t9\t4\t5\t6\t\n"),
                         Format::trc));
    const std::string blanks = "PathFileType 4 (X/Y/Z) x.trc\nDataRate CameraRate\n50 50\n"
                               "Frame# Time LHip Toe\nX1 Y1 Z1 X2 Y2 Z2\n"
                               "  1  3.00 1 2 3 4 5 6\n  2  3.02 1 2 3 4 5 6\n";
    const Clip clip = parse(blanks, Format::trc);
    assert_true(clip.fps == 50 && clip.values.cols() == 6 && clip.values(1, 5) == 6);
    assert_string_equal(clip.channel_names[3].c_str(), "Toe_x");
}

void the_header_of_trc_is_compared(void**) {
    const Clip clip = parse(trc("100\t100\t4\t3\tmm\t100\t1\t4"), Format::trc);
    assert_true(clip.fps == 50);
    assert_true(says(clip, "say 100 frames a second, but the times 50"));
    assert_true(says(clip, "the header says NumMarkers 3, but the file has 2"));
    assert_true(says(clip, "the header says NumFrames 4, but the file has 3"));
    assert_true(says(parse(trc("50\t50\t3\t9223372036854775807"), Format::trc),
                     "says NumMarkers 9223372036854775807, but the file has 2"));
    // Without times, the header and the numbers of the frames are the clock.
    const Clip still = parse(trc("50", "1\t0\t1\t2\t3\t4\t5\t6\n2\t0\t1\t2\t3\t4\t5\t6\n"
                                       "5\t0\t7\t8\t9\t4\t5\t6\n"),
                             Format::trc);
    assert_true(still.fps == 50 && still.frames() == 5 && std::isnan(still.values(3, 0)));
    assert_true(still.values(4, 0) == 7);
}

/// Above each of its columns, with the axis.
void names_repeated_in_trc(void**) {
    const std::string names =
        "Frame#\tTime\tLeft Hip_X\tLeft Hip_Y\tLeft Hip_Z\tToe_X\tToe_Y\tToe_Z\n";
    check_walk(parse(trc_keys + "50\t50\t3\t2\tmm\n" + names + trc_rows, Format::trc));
    // The rate may be that of the times only.
    check_walk(
        parse("PathFileType\t4\nNumFrames\tNumMarkers\n3\t2\n" + names + trc_rows, Format::trc));
}

void wrong_trc(void**) {
    ASSERT_FAILS(Status::format, "begins with PathFileType", parse("hello\n", Format::trc));
    ASSERT_FAILS(Status::format, "no line with Frame#", parse(trc_keys, Format::trc));
    ASSERT_FAILS(Status::format, "no names of markers",
                 parse(trc_keys + "50\nFrame#\tTime\n1\t0\n", Format::trc));
    ASSERT_FAILS(Status::format, "no rows", parse(trc_keys + "50\n" + trc_names, Format::trc));
    ASSERT_FAILS(Status::format, "test:7: 9 cells",
                 parse(trc("50", "1\t3\t1\t2\t3\t4\t5\t6\t7\n"), Format::trc));
    ASSERT_FAILS(Status::format, "test:7: column 3 ('Left Hip_x'): 'x'",
                 parse(trc("50", "1\t3\tx\t2\t3\t4\t5\t6\n"), Format::trc));
    ASSERT_FAILS(Status::format, "test:8: column 'Time' is time, but does not increase",
                 parse(trc("50", "1\t3\t1\t2\t3\t4\t5\t6\n2\t2\t1\t2\t3\t4\t5\t6\n"), Format::trc));
}

const std::string mot_rows = "0.00\t1\t2\n0.02\t3\t4\n0.04\t5\t6\n";

std::string mot(const std::string& head, const std::string& rows = mot_rows) {
    return "Coordinates\n" + head + "endheader\ntime\tknee_angle_r\tpelvis_tx\n" + rows;
}

void check_mot(const Clip& clip) {
    assert_true(clip.fps == 50 && clip.frames() == 3 && clip.space == 0);
    assert_true(clip.channel_names == (Names{"knee_angle_r", "pelvis_tx"}));
    assert_true(clip.values(1, 0) == 3 && clip.values(2, 1) == 6);
}

void coordinates(void**) {
    const Clip clip = parse(mot("version=1\nnRows=3\nnColumns=3\ninDegrees=yes\n"), Format::mot);
    check_mot(clip);
    assert_true(says(clip, "angles are in degrees") && !says(clip, "the header says"));
    assert_true(says(parse(mot("inDegrees=no\n"), Format::mot), "angles are in radians"));
    const Clip other = parse(mot("nRows=4\nnColumns=2\n"), Format::mot);
    assert_true(says(other, "nRows 4, but the file has 3") &&
                says(other, "nColumns 2, but the file has 3"));
}

/// Without keys, with those of SIMM, separated by blanks or commas, indented, with gaps.
void dialects_of_mot(void**) {
    check_mot(parse("\xEF\xBB\xBF" + mot(""), Format::mot));
    check_mot(parse(mot("name x\ndatacolumns 3\ndatarows 3\nrange 0 1\n"), Format::mot));
    check_mot(parse(mot("", "\t0.00\t1\t2\n\t0.02\t3\t4\n\t0.04\t5\t6\t\n"), Format::mot));
    for (const char separator : {' ', ',', ';'}) {
        std::string text = mot("nRows=3\n");
        std::ranges::replace(text, '\t', separator);
        check_mot(parse(text, Format::mot));
    }
    check_mot(parse(mot("", "  0.00   1   2\n  0.02   3   4\n  0.04   5   6\n"), Format::mot));
    const Clip gap = parse(mot("", "0.00\t1\t2\n0.02\t\tNaN\n0.04\t5\t6\n"), Format::mot);
    assert_true(std::isnan(gap.values(1, 0)) && std::isnan(gap.values(1, 1)));
}

/// Cells of several numbers.
void vectors(void**) {
    std::string rows;
    for (int i = 0; i < 4; ++i)
        rows += format_text("{}\t{},2,3\t4,5,6\t7,8,9\n", i / 50.0, i);
    const std::string head = "DataRate=50\nDataType=Vec3\nversion=3\nendheader\ntime\ta\tb\tc\n";
    const Clip points = parse(head + rows, Format::mot);
    assert_true(points.space == 3 && points.values.cols() == 9 && points.fps == 50);
    assert_true(points.values(3, 0) == 3 && points.values(3, 8) == 9);
    const Clip turns =
        parse("DataType=Quaternion\nendheader\ntime\timu\n0\t1,0,0,0\n.02\t0,1,0,0\n", Format::mot);
    assert_true(turns.space == 0);
    assert_true(turns.channel_names == (Names{"imu_w", "imu_x", "imu_y", "imu_z"}));
    ASSERT_FAILS(Status::format, "test:5: 5 cells, but",
                 parse("DataType=Vec3\nendheader\ntime\ta\n0\t1,2,3\n.02\t1,2,3,4\n", Format::mot));
}

void wrong_mot(void**) {
    ASSERT_FAILS(Status::format, "a line endheader", parse("hello\n", Format::mot));
    ASSERT_FAILS(Status::format, "no names of columns", parse("endheader\n", Format::mot));
    ASSERT_FAILS(Status::format, "test:3: column 2 ('x'): 'one' is not a number",
                 parse("endheader\ntime\tx\n0\tone\n", Format::mot));
    ASSERT_FAILS(Status::format, "test:4: column 'time' is time, but does not increase",
                 parse("endheader\ntime\tx\n1\t1\n1\t2\n", Format::mot));
}

void formats_are_recognized(void**) {
    assert_true(stltsa::clip::sniff(trc("50")) == Format::trc);
    assert_true(stltsa::clip::sniff(mot("nRows=3\n")) == Format::mot);
    assert_true(stltsa::clip::sniff("nRows=3,,\nEndHeader,,\n") == Format::mot);
    assert_true(stltsa::clip::sniff("a,b\n1,2\n") == Format::csv);
    assert_true(stltsa::clip::find_format("walk.STO")->format == Format::mot);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(markers),
        cmocka_unit_test(dialects_of_trc),
        cmocka_unit_test(the_header_of_trc_is_compared),
        cmocka_unit_test(names_repeated_in_trc),
        cmocka_unit_test(wrong_trc),
        cmocka_unit_test(coordinates),
        cmocka_unit_test(dialects_of_mot),
        cmocka_unit_test(vectors),
        cmocka_unit_test(wrong_mot),
        cmocka_unit_test(formats_are_recognized),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
