// SPDX-License-Identifier: BSD-3-Clause
// Malformed BVH files: the status, and a message with the line number.
#include "clip/testing.hpp"

namespace {

using namespace clip_testing;

void refuses(const std::string& text, Status status, std::string_view part, int line) {
    check_fails(
        status, part, [&] { parse(text, Format::bvh); }, __FILE__, line);
}
#define REFUSES(from, to, status, part)                                                            \
    refuses(replaced(small_bvh, from, to), Status::status, part, __LINE__)

void in_the_hierarchy(void**) {
    REFUSES("HIERARCHY\n", "", format, "test:1: a BVH file must begin with HIERARCHY");
    REFUSES("ROOT Hips", "JOINT Hips", format, "test:2: 'JOINT' is outside ROOT");
    REFUSES("ROOT Hips\n{", "ROOT Hips\n", format, "test:4: '{' is missing after 'Hips' on line 2");
    REFUSES("OFFSET 1.0 -2.0 0.5", "OFFSET 1.0 -2.0", format,
            "test:9: OFFSET must be followed by three numbers, not 'CHANNELS'");
    REFUSES("OFFSET 1.0 -2.0 0.5", "OFFSET 1.0 -2.0 nan", not_finite,
            "test:8: the OFFSET of joint 'Leg'");
    REFUSES("    OFFSET 1.0 -2.0 0.5\n", "", format,
            "test:13: joint 'Leg' on line 6 has no OFFSET");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS 2 Xrotation", format,
            "test:19: 'End' is not a channel");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS Xrotation", format,
            "test:18: CHANNELS must be followed by the number of channels");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS -1 Xrotation", format, "test:18: CHANNELS must");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS 1 Xscale", format, "test:18: 'Xscale' is not");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS 1 Wrotation", format, "test:18: 'Wrotation' is not");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS 99999999999999999999 Xrotation", format, "test:18:");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS 2 Xposition xPosition", format,
            "test:18: joint 'Arm' has one 'xPosition' too many: a joint has at most 6 channels");
    std::string seven = "CHANNELS 7";
    for (const char* axis : {"X", "Y", "Z", "X", "Y", "Z", "X"})
        seven += std::string(" ") + axis + "rotation";
    REFUSES("CHANNELS 1 Xrotation", seven, format,
            "test:18: joint 'Arm' has one 'Xrotation' too many");
    REFUSES("CHANNELS 1 Xrotation", "CHANNELS 1 Xposition CHANNELS 1 Xposition", format,
            "test:18: joint 'Arm' has one 'Xposition' too many");
    REFUSES("JOINT Arm", "JOINT " + std::string(257, 'a'), format, "257 bytes; at most 256");
    REFUSES("End Site", "End Site " + std::string(300, 'a'), format, "300 bytes; at most 256");
    parse(replaced(small_bvh, "JOINT Arm", "JOINT " + std::string(256, 'a')), Format::bvh);
    REFUSES("End Site", "End Sit", format, "test:10: 'End' must be followed by 'Site'");
    REFUSES("      OFFSET 0.0 -4.0 0.0\n", "OFFSET 0 -4 0\nJOINT Toe\n{\nOFFSET 0 0 0\n}\n", format,
            "test:14: an End Site may have only an OFFSET");
    REFUSES("JOINT Leg", "JIONT Leg", format, "test:6: 'JIONT' is not expected here");
    REFUSES("JOINT Arm", "ROOT Arm", format, "test:15: ROOT is inside joint 'Hips'");
    REFUSES("}\nMOTION", "}\nROOT Other\n{\nOFFSET 0 0 0\n}\nMOTION", unsupported,
            "test:25: a second ROOT");
    REFUSES("}\nMOTION", "MOTION", format,
            "test:24: MOTION comes before the closing brace of joint 'Hips' on line 2");
    REFUSES("}\nMOTION", "}\n}\nMOTION", format, "test:25: '}' is outside ROOT");
    refuses(small_bvh.substr(0, small_bvh.find("MOTION")), Status::format, "no MOTION was found",
            __LINE__);
    refuses("HIERARCHY\nMOTION\nFrames: 1\nFrame Time: 1\n1\n", Status::format,
            "test:2: the hierarchy has no ROOT", __LINE__);
    refuses("HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\nFrame Time: 1\n1\n",
            Status::format, "no joint has CHANNELS", __LINE__);
    refuses("", Status::format, "test:1:", __LINE__);
    refuses("\xFF\xFEH\0I\0", Status::format, "UTF-16", __LINE__);
    refuses(small_bvh + std::string(3, '\0'), Status::format, "not a text file", __LINE__);
}

void in_the_header_of_the_data(void**) {
    REFUSES("Frames: 3\n", "", format, "test:26: 'Frames:' is expected here");
    REFUSES("Frames: 3", "Frames 3", format, "test:26: 'Frames:' is expected here, not 'Frames 3'");
    REFUSES("Frames: 3", "Frames:", format,
            "test:26: 'Frames:' must be followed by the number of frames");
    REFUSES("Frames: 3", "Frames: 3.5", format, "test:26: 'Frames:' must be");
    REFUSES("Frames: 3", "Frames: -3", format, "test:26: 'Frames:' must be");
    REFUSES("Frames: 3", "Frames: 0", format, "test:26: the file has no frames");
    REFUSES("Frame Time: 0.0083333\n", "", format, "test:27: 'Frame Time:' is expected here");
    REFUSES("0.0083333", "soon", format,
            "test:27: 'Frame Time:' must be followed by a number of seconds");
    REFUSES("0.0083333", "-0.01", format,
            "test:27: 'Frame Time:' must be followed by a number of seconds");
    for (const char* none : {"1e300", "1e-300", "1.1", "24", "33.3"})
        REFUSES("0.0083333", none, format,
                std::string("test:27: invalid Frame Time ") +
                    (none[1] == 'e' ? "1e"
                                    : std::string(none) + " s; expected 1e-06 s to 1 s: if " +
                                          none + " is a rate, or milliseconds, set option fps"));
    parse(replaced(small_bvh, "0.0083333", "1"), Format::bvh);
    stltsa::clip::ReadOptions options;
    options.fps = 30;
    assert_true(parse(replaced(small_bvh, "0.0083333", "30"), Format::bvh, options).fps == 30);
    REFUSES("0.0083333", "nan", format,
            "test:27: 'Frame Time:' must be followed by a number of seconds");
}

void in_the_data(void**) {
    REFUSES("3 4 5 11", "3 4 x 11", format,
            "test:30: 'x' is not a number (frame 2, channel 'Hips.tz')");
    REFUSES("10 20 30", "10 nan 30", not_finite, "test:29: frame 1, channel 'Hips.rx' is nan");
    REFUSES("10 20 30", "10 1e999 30", not_finite, "test:29: frame 1, channel 'Hips.rx' is inf");
    REFUSES("10 20 30", "10 1,5 30", format, "test:29: '1,5' is not a number");
}

void data_that_end_early(void**) {
    REFUSES(
        "Frames: 3", "Frames: 5", format,
        "test:30: the file declares 5 frames of 10 channels, but has 3 frames: is it cut off? If "
        "not, correct 'Frames:'");
    REFUSES(" 61 71\n", " 61", format, "has 2 frames and 9 numbers: is it cut off?");
    // Must not allocate anything of this size.
    REFUSES("Frames: 3", "Frames: 1000000000000", format, "has 3 frames");
    REFUSES("Frames: 3", "Frames: 9223372036854775807", format, "has 3 frames");
    refuses(small_bvh.substr(0, small_bvh.find("1 2 3 0")), Status::format, "has 0 frames",
            __LINE__);
}

void rows_of_the_wrong_length(void**) {
    REFUSES("Frames: 3", "Frames: 1", format,
            "test:30: the file declares 1 frames of 10 channels, but has 3 frames: correct "
            "'Frames:' if all belong to the motion");
    REFUSES("61 71\n", "61 71\n81\n", format, "but has 3 frames and 1 numbers: correct 'Frames:'");
    REFUSES("2 3 4 10", "2 3 4 9 10", format, "test:29: frame 1 has more numbers");
    REFUSES("2 3 4 10", "2 3 10", format, "test:29: frame 1 has fewer numbers");
    // One number too many and one too few: the total is correct.
    refuses(replaced(replaced(small_bvh, "1 2 3 0", "1 2 3 0 0"), "2 3 4 10", "2 3 10"),
            Status::format, "test:28: frame 0 has more numbers", __LINE__);
    REFUSES("61 71\n", "61 71 81\n", format, "test:30: frame 2 has more numbers");
}

void hierarchies_without_end(void**) {
    std::string deep = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n";
    for (int i = 0; i < 200000; ++i)
        deep += "JOINT b\n{\n";
    refuses(deep, Status::unsupported, "more than 4096 joints", __LINE__);
}

void files_that_cannot_be_read(void**) {
    const TemporaryFolder folder;
    ASSERT_FAILS(Status::io, "none.bvh: cannot open: No such file",
                 stltsa::clip::read(folder.path("none.bvh"), {}));
    ASSERT_FAILS(Status::io, "give the folder to stltsa batch",
                 stltsa::clip::read(folder.path(""), {}));
    ASSERT_FAILS(Status::format,
                 "bad.bvh:1:", stltsa::clip::read(folder.write("bad.bvh", "x\n"), {}));
    ASSERT_FAILS(Status::format, "a skeleton without motion",
                 stltsa::clip::read(folder.write("only.asf", small_asf), {}));
    ASSERT_FAILS(Status::format, "wide.txt:1: the text is UTF-16",
                 stltsa::clip::read(folder.write("wide.txt", "\xFF\xFEx"), {}));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(in_the_hierarchy),
        cmocka_unit_test(in_the_header_of_the_data),
        cmocka_unit_test(in_the_data),
        cmocka_unit_test(data_that_end_early),
        cmocka_unit_test(rows_of_the_wrong_length),
        cmocka_unit_test(hierarchies_without_end),
        cmocka_unit_test(files_that_cannot_be_read),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
