// SPDX-License-Identifier: BSD-3-Clause
// C3D files of each processor, made here.
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "clip/arrays/mirror.hpp"
#include "clip/features/points.hpp"
#include "clip/formats.hpp"
#include "clip/stretch.hpp"
#include "testing.hpp"

using namespace stltsa;
using namespace stltsa::clip;
using namespace clip_testing;

namespace {

constexpr int intel = 84, dec = 85, mips = 86;
constexpr std::size_t block = 512;

/// A file as a program writes it.
struct Recording {
    int processor = intel;
    bool reals = true;
    std::int64_t points = 3, frames = 4, first = 1;
    std::int64_t stated = -1; ///< frames in the header; -1: those that there are
    double rate = 100;
    std::size_t analog = 0;          ///< numbers of each frame after the points
    std::size_t parameters_from = 2; ///< block, from 1
    std::vector<std::string> labels = {"HEAD", "LTOE", "RTOE"};
    bool has_labels = true;
    std::vector<std::pair<double, std::string>> header_events;

    // Numbers as the processor stores them.
    std::string word(std::int64_t value) const {
        const char low = static_cast<char>(value & 0xff), high = static_cast<char>(value >> 8);
        return processor == mips ? std::string{high, low} : std::string{low, high};
    }
    std::string real(double value) const {
        // The exponent of VAX is two larger.
        const auto number = static_cast<float>(processor == dec ? 4 * value : value);
        const auto bits = std::bit_cast<std::uint32_t>(number);
        const std::string high = word(bits >> 16), low = word(bits & 0xffff);
        return processor == intel ? low + high : high + low;
    }

    /// Entries of the parameters, each followed by the next.
    std::string parameters = {};
    void entry(const std::string& name, int group, const std::string& content) {
        parameters += static_cast<char>(name.size());
        parameters += static_cast<char>(group);
        parameters += name + word(static_cast<std::int64_t>(content.size()) + 3) + content + '\0';
    }
    void group(const std::string& name, int number) { entry(name, -number, ""); }
    void texts(const std::string& name, int group, const std::vector<std::string>& texts) {
        constexpr std::size_t length = 14;
        std::string content{-1, 2, length, static_cast<char>(texts.size())};
        for (std::string text : texts) {
            text.resize(length, ' ');
            content += text;
        }
        entry(name, group, content);
    }
    void words(const std::string& name, int group, const std::vector<std::int64_t>& values) {
        std::string content{2, 1, static_cast<char>(values.size())};
        for (const std::int64_t value : values)
            content += word(value);
        entry(name, group, content);
    }
    void real_values(const std::string& name, int group, const std::vector<double>& values) {
        std::string content{4, 1, static_cast<char>(values.size())};
        for (const double value : values)
            content += real(value);
        entry(name, group, content);
    }

    static double value(std::int64_t frame, std::int64_t point, int axis) {
        return 10.0 * static_cast<double>(point + 1) + axis + 0.5 * static_cast<double>(frame % 40);
    }
    std::function<double(std::int64_t, std::int64_t)> residual = [](auto, auto) { return 0.0; };

    std::string header(std::size_t data) const {
        std::string made(block, '\0');
        const auto put = [&](std::size_t at, const std::string& bytes) {
            made.replace(at, bytes.size(), bytes);
        };
        const std::int64_t last = first + (stated < 0 ? frames : stated) - 1;
        put(0, {static_cast<char>(parameters_from), 'P'});
        put(2, word(points) + word(static_cast<std::int64_t>(analog)) + word(first % 65536) +
                   word(last % 65536));
        put(12, real(reals ? -1 : 0.5) + word(static_cast<std::int64_t>(data)));
        put(20, real(rate));
        if (!header_events.empty())
            put(298, word(12345) + word(static_cast<std::int64_t>(header_events.size())));
        for (std::size_t i = 0; i < header_events.size(); ++i) {
            put(304 + 4 * i, real(header_events[i].first));
            put(396 + 4 * i, header_events[i].second);
        }
        return made;
    }

    std::string bytes() {
        if (has_labels) {
            group("POINT", 1);
            texts("LABELS", 1, labels);
        }
        std::string all(block * (parameters_from - 1), '\0');
        all += std::string{1, 'P', 2, static_cast<char>(processor)} + parameters;
        all.resize((all.size() / block + 1) * block, '\0');
        all.replace(0, block, header(all.size() / block + 1));
        const auto number = [&](double value) {
            return reals ? real(value) : word(std::lround(value / 0.5));
        };
        for (std::int64_t i = 0; i < frames; ++i) {
            for (std::int64_t p = 0; p < points; ++p) {
                for (int axis = 0; axis < 3; ++axis)
                    all += number(value(i, p, axis));
                all += reals ? real(residual(i, p)) : word(residual(i, p) < 0 ? -1 : 0);
            }
            for (std::size_t a = 0; a < analog; ++a)
                all += number(7);
        }
        all.resize((all.size() + block - 1) / block * block, '\0');
        return all;
    }
};

void assert_values(const Clip& clip, const Recording& file) {
    assert_int_equal(clip.frames(), file.frames);
    assert_int_equal(clip.values.cols(), 3 * file.points);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t c = 0; c < clip.values.cols(); ++c)
            assert_true(clip.values(i, c) == Recording::value(i, c / 3, static_cast<int>(c % 3)));
}

bool notes(const Clip& clip, std::string_view part) {
    return std::ranges::any_of(
        clip.notes, [&](const std::string& note) { return note.find(part) != note.npos; });
}

void test_processors_and_storage(void**) {
    for (const int processor : {intel, dec, mips})
        for (const bool reals : {true, false}) {
            Recording file;
            file.processor = processor;
            file.reals = reals;
            file.analog = 5;
            const std::string bytes = file.bytes();
            assert_true(sniff(bytes) == Format::c3d);
            const Clip clip = parse(bytes, Format::c3d);
            assert_values(clip, file);
            assert_true(clip.fps == 100);
            assert_int_equal(clip.space, 3);
            assert_string_equal(clip.channel_names[3].c_str(), "LTOE_x");
            assert_int_equal(clip.notes.size(), 1);
            assert_true(notes(clip, "not read: 5 analog channels"));
        }
}

void test_missing_points(void**) {
    for (const bool reals : {true, false}) {
        Recording file;
        file.reals = reals;
        file.residual = [&](std::int64_t frame, std::int64_t point) {
            return frame == 2 && point == 1 ? -1 : reals && frame == 3 ? NAN : 0.25;
        };
        const Clip clip = parse(file.bytes(), Format::c3d);
        for (int c = 0; c < 9; ++c) {
            assert_int_equal(std::isnan(clip.values(2, c)), c / 3 == 1);
            assert_int_equal(std::isnan(clip.values(3, c)), reals);
            assert_false(std::isnan(clip.values(1, c)));
        }
    }
}

void test_more_points_than_a_parameter_has_labels(void**) {
    Recording file;
    file.points = 300;
    file.frames = 2;
    file.labels.clear();
    for (int p = 0; p < 255; ++p)
        file.labels.push_back("m" + std::to_string(p));
    file.group("POINT", 1);
    file.texts("LABELS2", 1, {"another", ""});
    const Clip clip = parse(file.bytes(), Format::c3d);
    assert_values(clip, file);
    assert_string_equal(clip.channel_names[3UL * 254].c_str(), "m254_x");
    assert_string_equal(clip.channel_names[3UL * 255].c_str(), "another_x");
    assert_string_equal(clip.channel_names[3UL * 256].c_str(), "p257_x");
    assert_true(notes(clip, "44 of 300: 'p257', 'p258'"));
}

void test_parameters_elsewhere(void**) {
    Recording file;
    file.parameters_from = 11;
    assert_values(parse(file.bytes(), Format::c3d), file);
}

Recording long_recording(std::int64_t stated) {
    Recording file;
    file.points = 1;
    file.labels = {"HEAD"};
    file.frames = 70000;
    file.reals = false;
    file.stated = stated;
    return file;
}

void test_more_frames_than_the_header_can_count(void**) {
    for (const std::int64_t stated : {69952, 65535}) { // begins anew, stays
        Recording file = long_recording(stated);
        file.frames = 69952; // full blocks, and another one
        const Clip clip = parse(file.bytes() + std::string(block, '\0'), Format::c3d);
        assert_values(clip, file);
        assert_true(notes(clip, "by its size, the file holds 69952"));
    }
    Recording trial = long_recording(65535);
    trial.frames = 69999; // the rest of the last block has room for another
    trial.group("TRIAL", 2);
    trial.words("ACTUAL_START_FIELD", 2, {1, 0});
    trial.words("ACTUAL_END_FIELD", 2, {69999 % 65536, 1});
    const Clip clip = parse(trial.bytes(), Format::c3d);
    assert_values(clip, trial);
    assert_true(clip.notes.empty());
    Recording stated = long_recording(65535);
    stated.frames = 69999;
    stated.group("POINT", 1);
    stated.real_values("LONG_FRAMES", 1, {69999});
    assert_values(parse(stated.bytes(), Format::c3d), stated);
}

void test_files_of_another_length(void**) {
    Recording file;
    file.frames = 400;
    const std::string whole = file.bytes();
    ASSERT_FAILS(Status::format, "the file holds 234 of the 400 frames",
                 parse(whole.substr(0, whole.size() * 6 / 10), Format::c3d));
    ASSERT_FAILS(Status::format, "cut off", parse(whole.substr(0, 700), Format::c3d));
    ASSERT_FAILS(Status::format, "only the start of one",
                 parse(whole.substr(0, block), Format::c3d));
    ASSERT_FAILS(Status::format, "not a C3D file", parse("HIERARCHY\nROOT hip\n", Format::c3d));
    ASSERT_FAILS(Status::format, "not a C3D file", parse("", Format::c3d));
    Recording longer;
    longer.frames = 400;
    longer.stated = 300;
    const Clip clip = parse(longer.bytes(), Format::c3d);
    assert_int_equal(clip.frames(), 300);
    assert_true(notes(clip, "states 300 frames, which are read, and has bytes for 405"));
    // A statement that does not fit is no reason to refuse the one that does.
    Recording cropped;
    cropped.group("TRIAL", 2);
    cropped.words("ACTUAL_START_FIELD", 2, {1, 0});
    cropped.words("ACTUAL_END_FIELD", 2, {1000, 0});
    assert_values(parse(cropped.bytes(), Format::c3d), cropped);
    // Nor is an end without a start a statement, or a number that no frame has.
    Recording open;
    open.frames = 400; // the rest of the last block has room for another
    open.group("TRIAL", 2);
    open.words("ACTUAL_END_FIELD", 2, {400, 0});
    assert_values(parse(open.bytes(), Format::c3d), open);
    longer.group("TRIAL", 2);
    longer.real_values("ACTUAL_START_FIELD", 2, {-1e30, 0});
    longer.words("ACTUAL_END_FIELD", 2, {300, 0});
    assert_int_equal(parse(longer.bytes(), Format::c3d).frames(), 300);
}

void test_events(void**) {
    Recording file;
    file.first = 704;
    file.group("EVENT", 3);
    file.texts("LABELS", 3, {"Foot Strike", "Foot Off"});
    file.texts("CONTEXTS", 3, {"Left", "Right"});
    file.real_values("TIMES", 3, {0, 7.05, 0, 7.035});
    file.texts("LABELS2", 3, {"Later"});
    file.real_values("TIMES2", 3, {1, 0});
    Clip clip = parse(file.bytes(), Format::c3d);
    assert_int_equal(clip.events.size(), 3);
    assert_true(notes(clip, "1 of 3 events are before the first or after the last frame"));
    assert_string_equal(clip.events[0].label.c_str(), "Foot Off");
    assert_string_equal(clip.events[0].context.c_str(), "Right");
    assert_true(std::abs(clip.events[0].frame - 0.5) < 1e-4);
    assert_true(std::abs(clip.events[1].frame - 2) < 1e-4);
    assert_true(std::abs(clip.events[2].frame - (6000 - 703)) < 1e-4);
    assert_string_equal(clip.events[2].context.c_str(), "");
    const Clip part = cut(clip, {{1, 3}});
    assert_int_equal(part.events.size(), 1);
    assert_true(std::abs(part.events[0].frame - 1) < 1e-4);
    const Clip twice = cut(clip, {{2, 4}, {0, 3}});
    assert_int_equal(twice.events.size(), 3);
    assert_true(std::abs(twice.events[1].frame - 2.5) < 1e-4);
}

void test_events_beyond_the_header(void**) {
    Recording file;
    file.first = 70000;
    file.group("TRIAL", 2);
    file.words("ACTUAL_START_FIELD", 2, {70000 % 65536, 1});
    file.words("ACTUAL_END_FIELD", 2, {70003 % 65536, 1});
    file.group("EVENT", 3);
    file.texts("LABELS", 3, {"Foot Strike"});
    file.texts("CONTEXTS", 3, {"Left"});
    file.real_values("TIMES", 3, {11, 40.01});
    const Clip clip = parse(file.bytes(), Format::c3d);
    assert_int_equal(clip.frames(), 4);
    assert_true(std::abs(clip.events[0].frame - 2) < 1e-3);
    const Clip image = mirrored(clip, Axis::z);
    assert_string_equal(image.events[0].context.c_str(), "Right");
    assert_string_equal(image.events[0].label.c_str(), "Foot Strike");
}

void test_events_of_the_header(void**) {
    for (const int processor : {intel, dec, mips}) {
        Recording file;
        file.processor = processor;
        file.header_events = {{0.02, "RHS "}, {0.015, "LTO "}};
        const Clip clip = parse(file.bytes(), Format::c3d);
        assert_int_equal(clip.events.size(), 2);
        assert_string_equal(clip.events[0].label.c_str(), "LTO");
        assert_true(std::abs(clip.events[1].frame - 2) < 1e-4);
    }
}

void test_events_without_a_rate(void**) {
    Recording file;
    file.rate = 0;
    file.header_events = {{0.02, "RHS "}};
    const Clip unknown = parse(file.bytes(), Format::c3d);
    assert_true(unknown.fps == 0 && unknown.events.empty());
    assert_true(notes(unknown, "1 of 1 events have no time"));
    ReadOptions options;
    options.fps = 50;
    const Clip given = parse(Recording(file).bytes(), Format::c3d, options);
    assert_int_equal(given.events.size(), 1);
}

void test_rates(void**) {
    Recording file;
    file.group("POINT", 1);
    file.real_values("RATE", 1, {50});
    const Clip clip = parse(file.bytes(), Format::c3d);
    assert_true(clip.fps == 50);
    assert_true(notes(clip, "the header says 100 frames a second, and POINT:RATE 50"));
}

/// A body that is wider than tall, as somebody who sits and reaches.
void test_the_axis_that_points_up(void**) {
    for (const auto& [text, up] :
         {std::pair{"+Z", Axis::z}, {"Y", Axis::y}, {"-x", Axis::x}, {"Z-", Axis::z}}) {
        Recording file;
        file.frames = 40;
        file.group("POINT", 1);
        file.texts("Y_SCREEN", 1, {text});
        file.texts("UNITS", 1, {"mm"});
        const Clip clip = parse(file.bytes(), Format::c3d);
        assert_true(clip.up == up);
        assert_true(points_up(clip) == up);
        const FeatureRows made = feature_rows(clip, {}, {}, GapRule::fill);
        assert_true(made.up == up);
        for (const std::string& note : made.notes)
            assert_true(note.find("guessed") == note.npos);
        assert_true(feature_rows(clip, {}, Axis::y, GapRule::fill).up == Axis::y);
        const bool is_down = std::strchr(text, '-') != nullptr;
        assert_int_equal(notes(clip, "turned over"), is_down);
        const int axis = static_cast<int>(up) - 1, beside = (axis + 1) % 3;
        for (const int each : {0, 1, 2}) {
            const double sign = is_down && (each == axis || each == beside) ? -1 : 1;
            assert_true(clip.values(3, each) == sign * Recording::value(3, 0, each));
        }
        assert_string_equal(clip.unit.c_str(), "mm");
    }
    Recording silent;
    silent.group("POINT", 1);
    silent.texts("Y_SCREEN", 1, {"up"});
    const Clip clip = parse(silent.bytes(), Format::c3d);
    assert_true(clip.up == Axis::none);
    assert_true(notes(clip, "POINT:Y_SCREEN is 'up': no axis"));
}

void test_results_of_a_model(void**) {
    Recording file;
    file.points = 4;
    file.labels = {"LHipAngles", "LForceps", "CentreOfMass", "RTOE"};
    file.group("POINT", 1);
    file.texts("SCALARS", 1, {"CentreOfMass"});
    const Clip clip = parse(file.bytes(), Format::c3d);
    assert_int_equal(clip.values.cols(), 6);
    assert_string_equal(clip.channel_names[0].c_str(), "LForceps_x");
    assert_true(clip.values(0, 3) == Recording::value(0, 3, 0));
    assert_true(notes(clip, "2 of 4 points: 'LHipAngles', 'CentreOfMass'"));
}

void test_files_without_points(void**) {
    Recording file;
    file.points = 0;
    file.labels.clear();
    file.analog = 2;
    file.group("ANALOG", 2);
    file.words("USED", 2, {2});
    file.texts("LABELS", 2, {"Fx", "Fz"});
    file.group("ROTATION", 3);
    file.words("USED", 3, {21});
    ASSERT_FAILS(Status::format,
                 "has no points; it holds 2 analog channels: 'Fx', 'Fz'; rotations of 21 segments",
                 parse(file.bytes(), Format::c3d));
    Recording angles;
    angles.labels = {"LHipAngles", "LKneeAngles", "LAnkleAngles"};
    ASSERT_FAILS(Status::format, "it holds results of a model: 'LHipAngles', 'LKneeAngles'",
                 parse(angles.bytes(), Format::c3d));
    Recording empty;
    empty.points = 0;
    empty.has_labels = false;
    ASSERT_FAILS(Status::format, "it holds nothing else", parse(empty.bytes(), Format::c3d));
}

void test_damaged_parameters(void**) {
    Recording file;
    file.group("POINT", 1);
    file.entry("SCALE", 1, std::string{-1, 7, -1, -1, -1, -1, -1, -1, -1});
    ASSERT_FAILS(Status::format, "longer than its place", parse(file.bytes(), Format::c3d));
    Recording infinite;
    const std::string bytes = infinite.bytes();
    std::string wrong = bytes;
    wrong.replace(bytes.size() - block + 4, 4, infinite.real(INFINITY));
    ASSERT_FAILS(Status::not_finite, "frame 0: point 0 is infinite", parse(wrong, Format::c3d));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(test_processors_and_storage),
        cmocka_unit_test(test_missing_points),
        cmocka_unit_test(test_more_points_than_a_parameter_has_labels),
        cmocka_unit_test(test_parameters_elsewhere),
        cmocka_unit_test(test_more_frames_than_the_header_can_count),
        cmocka_unit_test(test_files_of_another_length),
        cmocka_unit_test(test_events),
        cmocka_unit_test(test_events_beyond_the_header),
        cmocka_unit_test(test_events_of_the_header),
        cmocka_unit_test(test_events_without_a_rate),
        cmocka_unit_test(test_rates),
        cmocka_unit_test(test_the_axis_that_points_up),
        cmocka_unit_test(test_results_of_a_model),
        cmocka_unit_test(test_files_without_points),
        cmocka_unit_test(test_damaged_parameters),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
