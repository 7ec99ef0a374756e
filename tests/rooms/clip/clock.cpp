// SPDX-License-Identifier: BSD-3-Clause
// The one rule of time of text formats: which column is the clock, and what becomes of the rows.
#include "clip/testing.hpp"

#include <cmath>
#include <functional>

#include "clip/arrays/arrays.hpp"
#include "clip/csv/date_time.hpp"
#include "clip/csv/time_names.hpp"

namespace {

using namespace clip_testing;
using stltsa::format_text;
using stltsa::clip::ReadOptions;

Clip csv(std::string_view text, std::optional<double> fps = {}) {
    ReadOptions options;
    options.fps = fps;
    return parse(text, Format::csv, options);
}

bool says(const Clip& clip, std::string_view part) {
    for (const std::string& note : clip.notes)
        if (note.find(part) != note.npos)
            return true;
    return false;
}

/// Rows of a clock, and of a channel that is the number of the row.
std::string table(const std::string& head, int rows, const std::function<std::string(int)>& clock) {
    std::string text = head + ",x\n";
    for (int i = 0; i < rows; ++i)
        text += format_text("{},{}\n", clock(i), i);
    return text;
}

/// The channel counts from 0 in all rows.
void check_all_rows(const Clip& clip, std::int64_t rows, double fps) {
    assert_int_equal(clip.frames(), rows);
    assert_int_equal(clip.values.cols(), 1);
    if (clip.fps != fps)
        print_error("%.17g frames a second, expected %.17g\n", clip.fps, fps);
    assert_true(clip.fps == fps);
    for (std::int64_t i = 0; i < rows; ++i)
        assert_true(clip.values(i, 0) == static_cast<double>(i));
}

/// Names are whole names with units; markers are not time.
void names_of_time(void**) {
    for (const char* name : {"time", "Time", "TIME (s)", "time_s", "timestamp", "Timestamp [sec]",
                             "t", "t[s]", "\"Time (Seconds)\"", "elapsed time", "Time_s"})
        check_all_rows(csv(table(name, 5, [](int i) { return format_text("{}", i / 50.0); })), 5,
                       50);
    for (const char* name : {"Time (ms)", "time_ms", "t [ms]", "timestamp.ms", "timems"})
        check_all_rows(csv(table(name, 5, [](int i) { return format_text("{}", 20 * i); })), 5, 50);
    for (const char* name : {"T1", "T10[0]", "t_2", "tx", "overtime", "time2"}) {
        const Clip clip = csv(table(name, 5, [](int i) { return format_text("{}", i / 50.0); }));
        assert_true(clip.fps == 0 && clip.values.cols() == 2);
        assert_string_equal(clip.channel_names[0].c_str(), name);
    }
}

void the_named_column_wins(void**) {
    const Clip apart = csv("t,time,x\n0,0,0\n0.1,0.01,1\n0.2,0.02,2\n");
    assert_true(apart.fps == 100 && says(apart, "column 't' is time, too"));
    assert_false(stltsa::clip::time_name("tmin").has_value()); // a least temperature
    // A marker that grows, before and after; a second clock, which is no channel either.
    for (const char* text : {"Time,T10[0],x\n0,0.5,7\n.01,.7,8\n.02,.9,9\n",
                             "T10[0],Time,x\n.5,0,7\n.7,.01,8\n.9,.02,9\n"}) {
        const Clip clip = csv(text);
        assert_true(clip.fps == 100 && clip.values.cols() == 2 && clip.values(1, 0) == .7);
    }
    const Clip twice = csv("time,x,timestamp\n0,7,0\n.01,8,1\n.02,9,2\n");
    assert_true(twice.fps == 100 && twice.values.cols() == 1);
    assert_true(says(twice, "'timestamp' is time, too"));
    // A torque named t does not replace the time, nor go.
    const Clip torque = csv("t,time,x\n5,0,7\n3,.01,8\n4,.02,9\n");
    assert_true(torque.fps == 100 && torque.values.cols() == 2 && torque.values(0, 0) == 5);
}

std::string rounded(double time, int digits) {
    return format_text("{:.{}f}", time, digits);
}

/// From the first time to the last; of the rates that few digits leave open, a whole one.
void rates_of_rounded_times(void**) {
    struct Case {
        double fps;
        int digits, rows;
    };
    for (const Case& c : {Case{60, 3, 300},
                          {600, 3, 1501},
                          {120, 3, 13},
                          {60, 3, 20},
                          {1000, 3, 500},
                          {2000, 3, 900},
                          {240, 2, 480},
                          {30, 2, 100},
                          {30, 0, 300},
                          {100, 0, 600},
                          {60, 0, 250},
                          {75, 2, 200}})
        for (const double start : {0.0, 3.0}) {
            const auto clock = [&](int i) { return rounded(start + i / c.fps, c.digits); };
            check_all_rows(csv(table("time", c.rows, clock)), c.rows, c.fps);
        }
    const Clip ntsc = csv(table("time", 1000, [](int i) { return rounded(i / 29.97, 3); }));
    assert_true(std::abs(ntsc.fps - 29.97) < 2e-3 && ntsc.fps != 30);
}

bool is_gap(const Clip& clip, std::int64_t row) {
    return std::isnan(clip.values(row, 0));
}

/// 50 of 200 rows are lost; the others keep their values and places.
void lost_rows_are_gaps(void**) {
    const auto place = [](int i) { return i < 50 ? i : i + 50; };
    for (const double fps : {100.0, 60.0, 600.0, 59.94}) {
        const Clip clip =
            csv(table("time", 150, [&](int i) { return rounded(place(i) / fps, 3); }));
        assert_int_equal(clip.frames(), 200);
        assert_true(std::abs(clip.fps - fps) < 0.002 * fps);
        assert_true(says(clip, "rows are missing by the times: 50 of 200 frames have no value"));
        for (int i = 0; i < 150; ++i)
            assert_true(clip.values(place(i), 0) == i);
        for (std::int64_t i = 50; i < 100; ++i)
            assert_true(is_gap(clip, i));
    }
}

void counters_are_clocks(void**) {
    const auto place = [](int i) { return i < 30 ? i : i + 3; };
    for (const char* name : {"frame", "Frame#", "Packet Counter", "sample_index", "\"\""}) {
        const Clip clip =
            csv(table(name, 60, [&](int i) { return format_text("{}", 7 + place(i)); }));
        assert_int_equal(clip.frames(), 63);
        for (int i = 0; i < 60; ++i)
            assert_true(clip.values(place(i), 0) == i);
        assert_true(is_gap(clip, 30) && is_gap(clip, 32) && clip.fps == 0);
        assert_true(says(clip, "by the count of frames: 3 of 63"));
    }
    // It counts 8 bits; every second frame.
    const Clip wrapped =
        csv(table("packet", 100, [&](int i) { return format_text("{}", (200 + place(i)) % 256); }));
    assert_int_equal(wrapped.frames(), 103);
    const Clip second =
        csv(table("frame", 60, [&](int i) { return format_text("{}", 2 * place(i)); }));
    assert_int_equal(second.frames(), 63);
    // Not counters.
    for (const char* text : {"frame,x\n1,7\n5,8\n6,9\n13,9\n", "index,x\n.5,7\n.7,8\n.8,9\n",
                             "count,x\n3,7\n1,8\n2,9\n"})
        assert_int_equal(csv(text).values.cols(), 2);
    ASSERT_FAILS(Status::format,
                 "test:5: column 'frame' counts frames, but does not increase from 4",
                 csv("frame,x\n2,1\n3,7\n4,8\n1,9\n2,9\n3,1\n4,1\n5,1\n"));
    ASSERT_FAILS(Status::format, "remove the column that counts",
                 csv("frame,x\n1,1\n2,7\n3,8\n999999999,9\n"));
}

/// The count tells the places, and the times the rate.
void counts_beside_times(void**) {
    const Clip both = csv("Frame,time,x\n1,0,7\n2,.01,8\n5,.04,9\n");
    assert_true(both.fps == 100 && both.frames() == 5 && both.values(4, 0) == 9);
    const Clip rounded_times =
        csv("Frame,time,x\n1,0.0,1\n2,0.0,2\n3,0.1,3\n4,0.1,4\n6,0.1,6\n7,0.2,7\n8,0.2,8\n9,0.2,9\n"
            "10,0.2,10\n11,0.3,11\n");
    assert_int_equal(rounded_times.frames(), 11);
    assert_true(is_gap(rounded_times, 4) && rounded_times.values(5, 0) == 6);
    const Clip other = csv("Frame,time,x\n1,0,7\n2,.01,8\n5,.02,9\n6,.03,9\n");
    assert_true(other.fps == 100 && other.frames() == 4);
    assert_true(says(other, "the times are used"));
}

/// Devices of a motion capture system: several rows a frame.
void subframes(void**) {
    std::string text = "Devices\n1000\n,,EMG,,\nFrame,Sub Frame,E1,E2,E3\n,,V,V,V\n";
    for (int i = 0; i < 400; ++i)
        if (i != 222)
            text += format_text("{},{},{},2,3\n", 1 + i / 10, i % 10, i);
    const Clip clip = csv(text);
    assert_int_equal(clip.values.cols(), 3);
    assert_int_equal(clip.frames(), 400);
    assert_true(clip.fps == 1000 && is_gap(clip, 222) && clip.values(399, 0) == 399);
}

void dates(void**) {
    using stltsa::clip::parse_date_time;
    assert_true(parse_date_time("1970-01-02") == 86400);
    assert_true(parse_date_time("2024-01-01 12:00:00.5") == 1704110400.5);
    assert_true(parse_date_time("2024-02-29T00:00:00Z") == 1709164800);
    assert_true(parse_date_time("2024-01-01T13:30:00+01:30") == 1704110400);
    assert_true(parse_date_time("12:00:00,25") == 43200.25);
    assert_true(parse_date_time("00:12.345") == 12.345);
    assert_true(parse_date_time("1:30 PM") == 48600 && parse_date_time("12:30:00 am") == 1800);
    assert_true(parse_date_time("12:30 pm") == 45000);
    for (const char* day : {"1970-02-03", "1970/2/3", "3.2.1970", "03-02-1970", "2/3/1970"})
        assert_true(parse_date_time(day) == 33 * 86400);
    assert_true(parse_date_time("31/1/1970") == 30 * 86400);
    for (const char* wrong :
         {"2023-02-29", "2024-13-01", "2024-01-01 25:00:00", "12:60", "12", "x", "1.2.3",
          "32.1.1970", "1-2-3", "2024-01-01 x", "2024-01-01T12:00:00+", "", "1:2:3:4"})
        assert_false(parse_date_time(wrong).has_value());
    for (const char* head : {"timestamp", "when"})
        for (const char* form : {"2024-01-01 12:00:{:06.3f}", "\"2024-01-01T12:00:{:06.3f}+01:00\"",
                                 "12:00:{:06.3f}"}) {
            const auto clock = [form](int i) { return format_text(fmt::runtime(form), i / 30.0); };
            check_all_rows(csv(table(head, 40, clock)), 40, 30);
        }
    // Whole seconds; the day apart; no header.
    check_all_rows(
        csv(table("time", 300, [](int i) { return format_text("12:00:{:02}", i / 30); })), 300, 30);
    const auto over_midnight = [](int i) {
        return i < 5 ? format_text("2024-01-01,23:59:59.{}", 5 + i)
                     : format_text("2024-01-02,00:00:00.{}", i - 5);
    };
    check_all_rows(csv(table("Date,Time", 9, over_midnight)), 9, 10);
    const Clip bare = csv("2024-01-01 12:00:00.00,7\n2024-01-01 12:00:00.02,8\n");
    assert_true(bare.fps == 50 && bare.frames() == 2 && bare.values(0, 0) == 7);
    assert_true(bare.channel_names.empty());
}

void times_since_1970(void**) {
    for (const char* digits :
         {"1704110400.{:03}", "1704110400{:03}", "1704110400{:03}000", "1704110400{:03}000000"})
        check_all_rows(
            csv(table("timestamp", 40,
                      [digits](int i) { return format_text(fmt::runtime(digits), 20 * i); })),
            40, 50);
}

/// In other languages, time has other names; but it must be the first column, and even.
void other_names_of_time(void**) {
    const auto seconds = [](int i) { return format_text("{:.3f}", i / 30.0); };
    check_all_rows(csv(table("Zeit", 40, seconds)), 40, 30);
    check_all_rows(
        csv(table("Bild-Zeit (ms)", 40, [](int i) { return format_text("{}", 20 * i); })), 40, 50);
    for (const char* head : {"hip_x", "Gang (%)", "angle (deg)"})
        assert_int_equal(csv(table(head, 40, seconds)).values.cols(), 2);
    const auto uneven = [](int i) { return format_text("{:.3f}", i / 30.0 + (i % 3) * 0.004); };
    assert_int_equal(csv(table("Zeit", 40, uneven)).values.cols(), 2);
    assert_int_equal(csv(table("Zeit", 19, seconds)).values.cols(), 2);
    assert_int_equal(csv(table("y", 40, seconds)).values.cols(), 2);
    assert_int_equal(csv(table("Zeit", 40, seconds), 30).values.cols(), 2);
    const auto far = [](int i) { return format_text("{}", 4 * i); };
    assert_int_equal(csv(table("Zeit", 40, far)).values.cols(), 2);
}

/// Without a unit, the numbers decide, and a note says how.
void guessed_units(void**) {
    for (const int step : {20, 20000, 20000000}) {
        const Clip clip =
            csv(table("time", 40, [&](int i) { return format_text("{}", step * i); }));
        check_all_rows(clip, 40, 50);
        assert_true(says(clip, "seconds, since seconds would give"));
    }
}

void faulty_clocks(void**) {
    const std::string back = "time,x\n0,7\n.01,8\n.02,8\n.03,1\n.01,9\n.05,9\n";
    ASSERT_FAILS(Status::format,
                 "test:6: column 'time' is time, but does not increase from 0.03 to 0.01",
                 csv(back));
    ASSERT_FAILS(Status::format, "test:3: column 'time' is time, but has no value",
                 csv("time,x\n0,7\n,8\n.02,9\n"));
    ASSERT_FAILS(Status::format, "set option fps", csv("time,x\n0,7\n0,8\n"));
    // A row that is there twice is no rounding.
    ASSERT_FAILS(
        Status::format, "test:102: column 'time' is time, but does not increase from 0.99 to 0.99",
        csv(table("time", 200, [](int i) { return rounded((i < 100 ? i : i - 1) / 100.0, 2); })));
    const Clip given = csv(back, 100);
    check_all_rows(csv("time,x\n0,0\n.01,1\n.005,2\n", 50), 3, 50);
    assert_true(given.fps == 100 && given.frames() == 6 && says(given, "at line 6: not used"));
}

/// Steps of an integrator: the rows are not even, and end after 12 s.
void variable_steps(void**) {
    std::string text = "time,x\n";
    double time = 0;
    while (time < 12) {
        text += format_text("{:.17g},{:.17g}\n", time, std::sin(2 * M_PI * time));
        time += 0.012 * (1 + 0.4 * std::sin(2 * M_PI * time / 12));
    }
    const Clip clip = csv(text);
    assert_true(std::abs(static_cast<double>(clip.frames()) / clip.fps - 12) < 0.1);
    assert_true(says(clip, "resampled to"));
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        assert_true(std::abs(clip.values(i, 0) -
                             std::sin(2 * M_PI * static_cast<double>(i) / clip.fps)) < 2e-3);
}

/// Steps that become 200 times as long, each like the one before, have no gap among them.
void slowly_varying_steps(void**) {
    double time = 0, step = 0.0005;
    const Clip clip = csv(table("time", 180, [&](int i) {
        step *= 1.03;
        time += i > 0 ? step : 0;
        return format_text("{:.9f}", time);
    }));
    assert_false(says(clip, "missing"));
    assert_true(says(clip, "of which 0 have no value") && clip.frames() == 180);
}

void contradictions_are_said(void**) {
    const Clip clip =
        csv("Capture Frame Rate,100\n,,\nframe,time,x\n1,0,7\n2,.02,8\n3,.04,9\n4,.06,9\n");
    assert_true(clip.fps == 50);
    assert_true(says(clip, "say 100 frames a second, but the times 50: the times are used"));
    const std::string text = "time,x\n0,7\n.02,8\n.04,9\n";
    assert_true(says(csv(text, 30), "option fps: 30 frames a second instead of the file's 50"));
    assert_false(says(csv(text, 50), "option fps"));
}

/// Of arrays, too: at uneven times, nothing is halfway to a missing one.
void missing_points_of_arrays(void**) {
    for (const double absent : {0.0, -9999.0, std::nan("")}) {
        std::vector<double> positions, times;
        for (int i = 0; i < 60; ++i) {
            times.push_back(i / 30.0 + 0.02 * std::sin(0.3 * i));
            for (int c = 0; c < 4; ++c)
                positions.push_back(i >= 20 && i < 30 && c > 1 ? absent : 5 + 0.01 * (i + c));
        }
        stltsa::clip::PointArrays arrays;
        arrays.space = 2;
        arrays.positions = {positions.data(), 60, 4, 4};
        arrays.times = {times.data(), 60, 1, 1};
        const Clip clip = clip_from_points(arrays);
        std::int64_t missing = 0;
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            for (std::int64_t c = 0; c < 4; ++c) {
                assert_true(!(clip.values(i, c) < 5));
                missing += std::isnan(clip.values(i, c)) ? 1 : 0;
            }
        assert_in_range(missing, 18, 24);
        assert_int_equal(says(clip, "-9999 is far outside"), absent < -1);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(names_of_time),
        cmocka_unit_test(the_named_column_wins),
        cmocka_unit_test(rates_of_rounded_times),
        cmocka_unit_test(lost_rows_are_gaps),
        cmocka_unit_test(counters_are_clocks),
        cmocka_unit_test(counts_beside_times),
        cmocka_unit_test(subframes),
        cmocka_unit_test(dates),
        cmocka_unit_test(times_since_1970),
        cmocka_unit_test(other_names_of_time),
        cmocka_unit_test(guessed_units),
        cmocka_unit_test(faulty_clocks),
        cmocka_unit_test(variable_steps),
        cmocka_unit_test(slowly_varying_steps),
        cmocka_unit_test(contradictions_are_said),
        cmocka_unit_test(missing_points_of_arrays),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
