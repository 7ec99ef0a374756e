// SPDX-License-Identifier: BSD-3-Clause
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "base/formula.hpp"
#include "clip/formats.hpp"
#include "clip/write.hpp"

namespace {

using namespace clip_testing;
using stltsa::clip::ReadOptions;

Clip csv(std::string_view text, std::optional<double> fps = {}) {
    ReadOptions options;
    options.fps = fps;
    options.min_confidence = 0.6;
    return parse(text, Format::csv, options);
}

using Rows = std::vector<std::vector<double>>;

void check_values(const Clip& clip, const Rows& expected, int line) {
    bool same = clip.frames() == static_cast<std::int64_t>(expected.size()) &&
                clip.values.cols() == static_cast<std::int64_t>(expected[0].size());
    for (std::size_t i = 0; same && i < expected.size(); ++i)
        same = std::equal(expected[i].begin(), expected[i].end(),
                          clip.values.row(static_cast<std::int64_t>(i)));
    if (!same)
        _fail(__FILE__, line);
}
#define CHECK_VALUES(clip, ...) check_values(clip, Rows __VA_ARGS__, __LINE__)

void separators(void**) {
    for (const char* text :
         {"1,2.5,3\n4,5,6\n", "1;2.5;3\n4;5;6", "1\t2.5\t3\n4\t5\t6\n", "1 2.5  3\n 4 5 6 \n",
          " 1 , 2.5 , 3 \n4, 5, 6\n", "1,2.5,3,\n4,5,6,\n", "1;2.5;3;\r\n4;5;6;\r\n",
          "1,\t2.5,\t3\n4,\t5,\t6\n",
          "\xEF\xBB\xBF"
          "1,2.5,3\n\n\n4,5,6\n\n",
          "+1,25e-1,3.0\n4,5,6\n", "\"1\",\"2.5\",\"3\"\n4,5,6\n",
          "# note\n1,2.5,3\n# more\n4,5,6\n", "1 \t 2.5 3\n4 5\t6\n"})
        CHECK_VALUES(csv(text), {{1, 2.5, 3}, {4, 5, 6}});
}

void decimal_commas(void**) {
    for (const char* text : {"1;2,5;3\n4;5;6,0\n", "1\t2,5\t3\n4\t5\t6\n", "1 2,5 3\n4 5,0 6\n",
                             "1,0 2,5 3,0\n4,0 5,0 6,0\n", "\"1\",\"2,5\",\"3\"\n\"4\",5,6\n"})
        CHECK_VALUES(csv(text), {{1, 2.5, 3}, {4, 5, 6}});
}

void one_column(void**) {
    CHECK_VALUES(csv("3\n1\n2\n"), {{3}, {1}, {2}});
    CHECK_VALUES(csv("knee\n3\n1\n"), {{3}, {1}});
}

void headers(void**) {
    const Clip clip = csv("\"hip, left\",\"say \"\"x\"\"\",c\n9,2,3\n4,5,6\n");
    CHECK_VALUES(clip, {{9, 2, 3}, {4, 5, 6}});
    assert_string_equal(clip.channel_names[0].c_str(), "hip, left");
    assert_string_equal(clip.channel_names[2].c_str(), "c");
    assert_true(csv("9,2\n4,5\n").channel_names.empty());
    CHECK_VALUES(csv("a,b,\n9,2\n4,5,\n"), {{9, 2}, {4, 5}});
    assert_true(clip.fps == 0 && clip.notes.empty());
    assert_true(csv("a,b\n9,2\n4,5\n", 50).fps == 50);
}

/// A data frame without column names, without and with its index.
void numbered_columns_are_a_header(void**) {
    for (const char* text : {"0,1,2\n.5,7,1\n.25,8,2\n", ",0,1,2\n0,.5,7,1\n1,.25,8,2\n",
                             ";0;1;2\n0;,5;7;1\n1;,25;8;2\n"}) {
        const Clip clip = csv(text);
        CHECK_VALUES(clip, {{.5, 7, 1}, {.25, 8, 2}});
        assert_string_equal(clip.channel_names[2].c_str(), "2");
        assert_false(clip.notes.empty());
    }
    CHECK_VALUES(csv(",0\n0,.5\n1,.25\n"), {{.5}, {.25}});
    // Numbers that are data: a circle, integers, a different start.
    CHECK_VALUES(csv("0,1\n.5,.7\n"), {{0, 1}, {.5, .7}});
    CHECK_VALUES(csv("0,1,2\n3,4,5\n"), {{0, 1, 2}, {3, 4, 5}});
    CHECK_VALUES(csv("0,1,3\n.5,4,5\n"), {{0, 1, 3}, {.5, 4, 5}});
    CHECK_VALUES(csv("0,1,2\n"), {{0, 1, 2}});
}

void time_at_an_implausible_rate_is_a_channel(void**) {
    // A torque; 1e10 s per frame; 1e9 frames per second.
    for (const char* text : {"t,x\n0,7\n5.5,8\n9,9\n", "x,time\n7,0\n8,1e10\n9,2e10\n",
                             "time,x\n0,7\n1e-9,8\n2e-9,9\n"}) {
        const Clip clip = csv(text);
        assert_true(clip.fps == 0 && clip.values.cols() == 2);
        assert_non_null(std::strstr(clip.notes.at(0).c_str(), "kept as a channel"));
    }
    const Clip count = csv("time,x\n5,7\n6,8\n7,9\n");
    CHECK_VALUES(count, {{7}, {8}, {9}});
    assert_true(count.fps == 0);
    CHECK_VALUES(csv("t,x\n0,7\n10,8\n20,9\n", 100), {{7}, {8}, {9}});
}

void time_gives_the_rate_and_is_not_a_channel(void**) {
    for (const char* text :
         {"time,x\n0,7\n0.01,8\n0.02,9\n", "x,Time (s)\n7,5.00\n8,5.01\n9,5.02\n",
          "t [ms];x\n0;7\n10;8\n20;9\n", "Frame#,Time,x\n1,0,7\n2,.01,8\n3,.02,9\n"}) {
        const Clip clip = csv(text);
        CHECK_VALUES(clip, {{7}, {8}, {9}});
        assert_true(clip.fps == 100);
        assert_int_equal(clip.channel_names.size(), 1);
        assert_string_equal(clip.channel_names[0].c_str(), "x");
        assert_true(!clip.notes.empty());
    }
    // 120 Hz with times rounded to milliseconds.
    const Clip rounded =
        csv("time,x\n0.000,1\n0.008,2\n0.017,3\n0.025,1\n0.033,1\n0.042,1\n0.050,1\n");
    assert_true(rounded.fps == 120);
    assert_true(csv("time,x\n0,7\n0.01,8\n", 60).fps == 60);
}

bool is_missing(const Clip& clip, std::int64_t row, std::int64_t column) {
    return std::isnan(clip.values(row, column));
}

/// Between a position and nothing there is no position, when rows are resampled.
void missing_points_at_uneven_times(void**) {
    for (const char* absent : {"-999", "0", ""}) {
        std::string text = "time,a_x,a_y,b_x,b_y,c_x,c_y\n";
        for (int i = 0; i < 60; ++i) {
            text += stltsa::format_text("{:.4f}", i / 30.0 + 0.02 * std::sin(0.3 * i));
            for (int c = 0; c < 6; ++c)
                text += i >= 20 && i < 30 && c > 3 ? stltsa::format_text(",{}", absent)
                                                   : stltsa::format_text(",{}", 100 + i + c);
            text += '\n';
        }
        const Clip clip = csv(text);
        std::int64_t missing = 0;
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            for (std::int64_t c = 0; c < 6; ++c) {
                assert_true(!(clip.values(i, c) < 100));
                missing += std::isnan(clip.values(i, c)) ? 1 : 0;
            }
        assert_in_range(missing, 18, 24);
    }
}

void uneven_times_are_resampled(void**) {
    const char* text = "time,x\n0,7\n0.01,8\n0.02,9\n0.04,9\n";
    const Clip lost = csv(text); // the frame at 0.03 is missing
    assert_int_equal(lost.frames(), 5);
    assert_true(lost.fps == 100 && is_missing(lost, 3, 0) && lost.values(4, 0) == 9);
    assert_true(lost.notes.back().find("1 of 5 frames have no value") != std::string::npos);
    CHECK_VALUES(csv(text, 100), {{7}, {8}, {9}, {9}}); // unless the rate is given
    const Clip jitter = csv("time,x\n0,0\n.01,1\n.02,2\n.036,3.6\n.04,4\n.05,5\n");
    assert_int_equal(jitter.frames(), 6);
    for (std::int64_t i = 0; i < 6; ++i)
        assert_true(i == 3 || std::abs(jitter.values(i, 0) - static_cast<double>(i)) < 1e-9);
    ASSERT_FAILS(Status::format, "more frames are missing than there are",
                 csv("time,x\n0,7\n0.01,8\n0.02,9\n0.2,9\n"));
    const Clip given = csv(text, 100);
    assert_true(std::ranges::any_of(given.notes, [](const std::string& note) {
        return note.find("option fps is set") != note.npos;
    }));
    const Clip kept = csv("t,x\n3,7\n1,8\n2,9\n"); // for example a torque
    CHECK_VALUES(kept, {{3, 7}, {1, 8}, {2, 9}});
    assert_int_equal(kept.notes.size(), 1);
}

/// Stamps of a camera that wait up to 9 of 20 ms: no frame is missing, and the rate is 50.
void jitter_loses_no_frame(void**) {
    std::string text = "time,x\n";
    unsigned state = 1;
    for (int i = 0; i < 400; ++i) {
        state = state * 1664525u + 1013904223u;
        const double late = (static_cast<double>(state >> 8) / (1 << 24) * 2 - 1) * 0.009;
        text += stltsa::format_text("{:.5f},{}\n", 1 + i / 50.0 + late, i);
    }
    const Clip clip = csv(text);
    assert_true(std::abs(clip.fps - 50) < 0.2);
    assert_true(std::abs(static_cast<double>(clip.frames()) - 400) <= 2);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        assert_false(is_missing(clip, i, 0));
}

/// A column of time that cannot be used does not cost the points, if the rate is given.
void points_beside_a_damaged_time(void**) {
    const std::string head = "time,a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z\n";
    const std::string row = ",1,2,3,4,5,6,7,8,9\n";
    for (const char* times : {"0 nan 2", "0 1 1", "0 2 1"}) {
        std::string text = head;
        for (const char time : {times[0], times[2], times[std::strlen(times) - 1]})
            text += (time == 'n' ? std::string() : std::string(1, time)) + row;
        ASSERT_FAILS(Status::format, "column 'time' is time, but", csv(text));
        const Clip clip = csv(text, 50);
        assert_true(clip.space == 3 && clip.values.cols() == 9 && clip.fps == 50);
        assert_true(clip.notes.front().find("'time'") != std::string::npos);
    }
}

void frame_numbers_are_not_a_channel(void**) {
    CHECK_VALUES(csv("frame,x\n10,7\n11,8\n"), {{7}, {8}});
    CHECK_VALUES(csv(",x\n0,7\n1,8\n"), {{7}, {8}}); // pandas writes its index this way
    CHECK_VALUES(csv("frame,x,time,frame,y\n1,7,.1,1,3\n2,8,.2,2,4\n"), {{7, 3}, {8, 4}});
    CHECK_VALUES(csv("frame,,x\n1,0,7\n2,1,8\n"), {{7}, {8}});
    CHECK_VALUES(csv("x,\"\",y\n1,7,3\n2,8,4\n"), {{1, 7, 3}, {2, 8, 4}});
    const Clip kept = csv("frame,x\n10,7\n12,8\n15,9\n");
    CHECK_VALUES(kept, {{10, 7}, {12, 8}, {15, 9}});
    assert_int_equal(kept.notes.size(), 1);
    ASSERT_FAILS(Status::format, "no channel besides time", csv("time\n0\n1\n2\n"));
    const Clip silent = csv("0.0,7\n0.01,8\n0.02,1\n");
    assert_int_equal(silent.values.cols(), 2);
    assert_int_equal(silent.notes.size(), 1);
}

/// Processor seconds, the least of several tries, to read a row of columns that count frames.
double time_of_columns(int count) {
    std::string text, row;
    for (int i = 0; i < count; ++i) {
        text += "frame,";
        row += "1,";
    }
    text += "x\n" + row + "7\n" + row + "8\n";
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i) {
        const std::clock_t begin = std::clock();
        csv(text);
        least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return least;
}

/// Removing columns one by one takes 16 times as long for four times the columns.
void many_columns_of_time_take_linear_time(void**) {
    const double few = time_of_columns(20000);
    assert_true(time_of_columns(80000) < 10 * few);
}

void cells_without_a_value_are_gaps(void**) {
    for (const char* gap : {"NaN", "NA", "-", "null", " ", ""}) {
        const Clip clip = csv(stltsa::format_text("a,b,c\n1,2,3\n4,{},6\n", gap));
        assert_true(is_missing(clip, 1, 1) && clip.values(1, 2) == 6);
    }
    assert_true(is_missing(csv("1,NA,3\n1,2,3\n"), 0, 1));
}

using Names = std::vector<std::string>;

/// Three points with two headers, as pandas writes columns of two levels, with and without the name
/// of the index.
void headers_of_two_levels(void**) {
    const Names wanted = {"a_x", "a_y", "a_z", "b_x", "b_y", "b_z", "c_x", "c_y", "c_z"};
    const std::string levels = ",a,a,a,b,b,b,c,c,c\n,x,y,z,x,y,z,x,y,z\n";
    const std::string data = "0,1,2,3,4,5,6,7,8,9\n1,1,2,3,4,5,6,7,8,9\n2,1,2,3,4,5,6,7,8,10\n";
    for (const char* index : {"", "frame,,,,,,,,,\n"}) {
        const Clip clip = csv(levels + index + data);
        assert_true(clip.channel_names == wanted && clip.space == 3);
        assert_int_equal(clip.frames(), 3);
        assert_true(clip.values(2, 8) == 10);
    }
}

/// DeepLabCut: three levels, of which the first is one name; likelihoods.
void key_points_with_likelihoods(void**) {
    const Clip clip =
        csv("scorer,net,net,net,net,net,net,net,net,net\n"
            "bodyparts,nose,nose,nose,ear,ear,ear,tail,tail,tail\n"
            "coords,x,y,likelihood,x,y,likelihood,x,y,likelihood\n"
            "0,1,2,0.9,3,4,0.9,5,6,1\n1,1,2,0.9,3,4,0.3,5,6,1\n2,1,2,0.9,3,4,0.9,5,6,1\n");
    assert_true(clip.channel_names ==
                (Names{"nose_x", "nose_y", "ear_x", "ear_y", "tail_x", "tail_y"}));
    assert_int_equal(clip.space, 2);
    assert_true(is_missing(clip, 1, 2) && is_missing(clip, 1, 3) && clip.values(1, 4) == 5);
}

/// A clinical export: sections with titles, rates, units, names above the first of three columns.
void preambles_of_clinical_exports(void**) {
    assert_true(
        csv("Analog Rate,1000\nCamera Rate,100\nFrame,a_x,a_y,a_z\n1,1,2,3\n2,3,4,5\n").fps == 100);
    const std::string text = "Model Outputs\n100\n,,Pat:LHipAngles,,\nFrame,Sub Frame,X,Y,Z\n"
                             ",,deg,deg,deg\n1,0,1,2,3\n2,0,1,2,3\n\n"
                             "Trajectories\n150\n,,Pat:LASI,,,Pat:RASI,,,Pat:LHEE,,\n"
                             "Frame,Sub Frame,X,Y,Z,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm,mm,mm,mm\n"
                             "1,0,1,2,3,4,5,6,7,8,9\n2,0,1,2,3,,,,7,8,9\n3,0,1,2,3,4,5,6,7,8,9\n";
    const Clip clip = csv(text);
    assert_true(clip.fps == 150 && clip.space == 3);
    assert_int_equal(clip.frames(), 3);
    assert_int_equal(clip.values.cols(), 9);
    assert_string_equal(clip.channel_names[3].c_str(), "Pat:RASI_X");
    assert_true(is_missing(clip, 1, 3) && clip.values(1, 8) == 9);
    // A section that follows is not read.
    const Clip first = csv(text + "\nForce Plate,,\n1000\nFrame,Sub Frame,Fx\n1,0,17\n");
    assert_int_equal(first.frames(), 3);
    assert_int_equal(first.values.cols(), 9);
    assert_true(std::ranges::count(first.notes, "the rows from 'Force Plate' on are not read") ==
                1);
    // An optical system: facts before the header, and levels that tell no columns apart.
    const Clip optical =
        csv("Format Version,1.23,Take Name,walk,Capture Frame Rate,120\n\n"
            ",Type,Marker,Marker,Marker,Marker,Marker,Marker,Marker,Marker,Marker\n"
            ",Name,a,a,a,b,b,b,c,c,c\n,ID,A1,A1,A1,B1,B1,B1,C1,C1,C1\n"
            ",,Position,Position,Position,Position,Position,Position,Position,Position,Position\n"
            "Frame,Time (Seconds),X,Y,Z,X,Y,Z,X,Y,Z\n0,0.0,1,2,3,4,5,6,7,8,9\n"
            "1,0.01,1,2,3,4,5,6,7,8,9\n2,0.02,1,2,3,4,5,6,7,8,9\n");
    assert_true(optical.fps == 100 && optical.space == 3);
    assert_string_equal(optical.channel_names[0].c_str(), "a_X");
    assert_int_equal(optical.values.cols(), 9);
}

/// An optical system whose row of parents is empty, and whose labels differ in kind.
void labels_that_name_no_columns(void**) {
    const std::string data = "0,0.0,1,2,3,4,5,6\n1,0.01,1,2,3,4,5,6\n2,0.02,1,2,3,4,5,6\n";
    for (const char* parent : {"", ",Parent,,,,,,\n", ",Parent,P,P,P,Q,Q,Q\n"}) {
        const Clip clip =
            csv("Format Version,1.23,Capture Frame Rate,200,Export Frame Rate,50,a,b\n\n"
                ",Type,Marker,Marker,Marker,Bone,Bone,Bone\n,Name,a,a,a,b,b,b\n"
                ",ID,1,1,1,2,2,2\n" +
                std::string(parent) +
                ",,Position,Position,Position,Position,Position,Position\n"
                "Frame,Time (Seconds),X,Y,Z,X,Y,Z\n" +
                data);
        assert_true(clip.channel_names == (Names{"a_X", "a_Y", "a_Z", "b_X", "b_Y", "b_Z"}));
        assert_true(clip.notes.at(0) == "50 frames a second from the lines before the header");
    }
}

/// Names of markers in one line, with and without times in the rows.
void marker_names(void**) {
    const std::string head = "NO_OF_FRAMES\t3\nFREQUENCY\t50\nANALOG_FREQUENCY\t900\n"
                             "MARKER_NAMES\ta\tb\n";
    const Clip bare = csv(head + "1\t2\t3\t4\t5\t6\n1\t2\t3\t4\t5\t7\n");
    assert_true(bare.fps == 50 && bare.space == 3 && bare.values(1, 5) == 7);
    assert_true(bare.channel_names == (Names{"a_x", "a_y", "a_z", "b_x", "b_y", "b_z"}));
    const Clip timed = csv(head + "1\t0\t1\t2\t3\t4\t5\t6\n2\t.01\t1\t2\t3\t4\t5\t7\n");
    assert_true(timed.fps == 100 && timed.values.cols() == 6 && timed.values(1, 5) == 7);
    ASSERT_FAILS(Status::format, "MARKER_NAMES has 2 names, but the rows have 5 columns",
                 csv(head + "1\t2\t3\t4\t5\n1\t2\t3\t4\t5\n"));
}

/// Units of lengths are noted; other units stay with the names, so that no angle is a position.
void units_of_columns(void**) {
    const Clip clip = csv("Devices\n1000\n,,EMG,\nFrame,Sub Frame,E1,E2\n,,V,V\n"
                          "1,0,5,6\n2,0,7,8\n");
    assert_true(clip.channel_names.back() == "EMG_E2 (V)");
    const Clip one = csv("Trajectories\n100\n,,S:LASI,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n"
                         "1,0,5,6,7\n2,0,7,8,9\n");
    assert_true(one.space == 3 && one.channel_names.back() == "S:LASI_Z");
    const Clip timed = csv("x,y,time\nm,m,seconds\n1,2,0\n3,4,0.01\n5,6,0.02\n");
    assert_true(timed.fps == 100 && timed.channel_names == (Names{"x", "y"}));
    const Clip mixed = csv("a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z,d_x,d_y,d_z\n"
                           "mm,mm,mm,mm,mm,mm,mm,mm,mm,deg,deg,deg\n"
                           "1,2,3,4,5,6,7,8,9,1,2,3\n1,2,3,4,5,6,7,8,9,1,2,3\n");
    assert_true(mixed.space == 3 && mixed.values.cols() == 9);
    assert_string_equal(mixed.notes.at(0).c_str(),
                        "unit of length in the lines before the numbers: mm");
}

/// A row of data with a letter in it is not a second header.
void broken_rows_are_no_headers(void**) {
    ASSERT_FAILS(Status::format, "test:2: column 2 ('b'): 'x' is not a number",
                 csv("a,b\n1,x\n2,3\n4,5\n"));
}

void malformed(void**) {
    ASSERT_FAILS(Status::format, "test:3: 2 cells, but the previous lines have 3",
                 csv("a,b,c\n1,2,3\n4,5\n"));
    ASSERT_FAILS(Status::format, "test:2: 4 cells, but", csv("1,2,3\n4,5,6,7\n"));
    ASSERT_FAILS(Status::format, "test:2: 2 cells, but", csv("a,b,c\n1,2\n"));
    ASSERT_FAILS(Status::format, "test:4: column 2 ('b'): 'x' is not a number",
                 csv("a,b\n1,2\n\n3,x\n"));
    ASSERT_FAILS(Status::format, "test:2: column 1: '1.234,5' is not a number",
                 csv("1;2\n1.234,5;2\n"));
    ASSERT_FAILS(Status::format, "'1,234,567' is not a number", csv("1;2\n1,234,567;2\n"));
    ASSERT_FAILS(Status::not_finite, "test:2: column 2 is inf", csv("1,2\n3,inf\n"));
    ASSERT_FAILS(Status::not_finite, "test:2: column 2 is -inf", csv("1,2\n3,-1e999\n"));
    ASSERT_FAILS(Status::format, "test:2: a quote is not closed", csv("1,2\n\"3,4\n"));
    ASSERT_FAILS(Status::format, "test:2: a quote is not closed", csv("1,2\n\"3\"5,4\n"));
    for (const char* text : {"", "\n\n", "# nothing\n", "a,b,c\n"})
        ASSERT_FAILS(Status::format, "no rows of numbers", csv(text));
    ASSERT_FAILS(Status::format, "not a text file", csv(std::string_view("1,2\0\n", 5)));
}

void names_are_no_formulas(void**) {
    Clip clip;
    clip.format = Format::csv;
    clip.channel_names = {
        "=HYPERLINK(\"http://x\")", "+1+1", "-2+3", "@SUM(1)", "'=1", "plain", "'s"};
    clip.values = stltsa::Matrix(2, 7);
    const std::string text = stltsa::clip::find_format("a.csv")->write(clip);
    const std::string head = text.substr(0, text.find('\n'));
    assert_string_equal(head.c_str(),
                        "\"'=HYPERLINK(\"\"http://x\"\")\",\"'+1+1\",\"'-2+3\",\"'@SUM(1)\","
                        "\"''=1\",plain,\"'s\"");
    const Clip back = parse(text, Format::csv);
    assert_true(back.channel_names == clip.channel_names);
    assert_true(stltsa::text_cell("\t=1") == "'\t=1" && stltsa::text_cell("a=1") == "a=1");
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(separators),
        cmocka_unit_test(decimal_commas),
        cmocka_unit_test(one_column),
        cmocka_unit_test(headers),
        cmocka_unit_test(numbered_columns_are_a_header),
        cmocka_unit_test(time_at_an_implausible_rate_is_a_channel),
        cmocka_unit_test(time_gives_the_rate_and_is_not_a_channel),
        cmocka_unit_test(missing_points_at_uneven_times),
        cmocka_unit_test(uneven_times_are_resampled),
        cmocka_unit_test(many_columns_of_time_take_linear_time),
        cmocka_unit_test(cells_without_a_value_are_gaps),
        cmocka_unit_test(headers_of_two_levels),
        cmocka_unit_test(key_points_with_likelihoods),
        cmocka_unit_test(preambles_of_clinical_exports),
        cmocka_unit_test(labels_that_name_no_columns),
        cmocka_unit_test(marker_names),
        cmocka_unit_test(units_of_columns),
        cmocka_unit_test(broken_rows_are_no_headers),
        cmocka_unit_test(jitter_loses_no_frame),
        cmocka_unit_test(points_beside_a_damaged_time),
        cmocka_unit_test(frame_numbers_are_not_a_channel),
        cmocka_unit_test(malformed),
        cmocka_unit_test(names_are_no_formulas),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
