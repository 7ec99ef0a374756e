// SPDX-License-Identifier: BSD-3-Clause
// Writes clips and reads them back: the same bits and the same skeleton.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "clip/arrays/arrays.hpp"
#include "clip/bvh/form.hpp"
#include "clip/features/features.hpp"
#include "clip/files/read_file.hpp"
#include "clip/files/write_file.hpp"
#include "clip/formats.hpp"
#include "clip/stretch.hpp"
#include "clip/text/number.hpp"
#include "clip/write.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;
namespace fs = std::filesystem;

std::string content_of(const std::string& path) {
    return read_file(path);
}

void check_same_bits(const Matrix& a, const Matrix& b) {
    assert_int_equal(a.rows(), b.rows());
    assert_int_equal(a.cols(), b.cols());
    assert_memory_equal(a.data(), b.data(),
                        static_cast<std::size_t>(a.rows() * a.cols()) * sizeof(double));
}

bool same(const Quaternion& a, const Quaternion& b) {
    return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z;
}

void check_same_skeleton(const Skeleton& a, const Skeleton& b) {
    assert_int_equal(a.joints.size(), b.joints.size());
    for (std::size_t j = 0; j < a.joints.size(); ++j) {
        assert_string_equal(a.joints[j].name.c_str(), b.joints[j].name.c_str());
        assert_int_equal(a.joints[j].parent, b.joints[j].parent);
        assert_true(a.joints[j].offset == b.joints[j].offset);
        assert_true(a.joints[j].channels == b.joints[j].channels);
        assert_true(same(a.joints[j].axis, b.joints[j].axis));
        assert_true(a.joints[j].end_site == b.joints[j].end_site);
    }
    assert_true(a.fixed_axes == b.fixed_axes);
}

void check_same(const Clip& a, const Clip& b) {
    check_same_bits(a.values, b.values);
    check_same_skeleton(*a.skeleton, *b.skeleton);
    assert_true(a.fps == b.fps && a.frame_time == b.frame_time);
    assert_true(a.channel_names == b.channel_names);
}

/// Writes under this name and reads again.
Clip through_file(const Clip& clip, const char* name, const ReadOptions& options = {}) {
    const TemporaryFolder folder;
    write(clip, folder.path(name));
    return read(folder.path(name), options);
}

void check_same_positions(const Clip& a, const Clip& b, double relative) {
    const Matrix p = positions(a);
    const Matrix q = positions(b);
    assert_int_equal(p.rows(), q.rows());
    assert_int_equal(p.cols(), q.cols());
    double largest = 0;
    for (std::int64_t i = 0; i < p.rows() * p.cols(); ++i)
        largest = std::max(largest, std::abs(p.data()[i]));
    for (std::int64_t i = 0; i < p.rows() * p.cols(); ++i)
        ASSERT_NEAR(p.data()[i], q.data()[i], relative * largest);
}

/// Numbers that are hard to write exactly.
constexpr double numbers[] = {0.0,
                              -0.0,
                              1.0 / 3,
                              1e300,
                              -1.7976931348623157e308,
                              5e-324,
                              1e-5,
                              9.9e-6,
                              1e16,
                              1e15,
                              123456789.123456789,
                              0.1 + 0.2,
                              2.5e-9,
                              -360,
                              1e22,
                              3e-10,
                              4.35};

void numbers_read_back_to_the_same_bits(void**) {
    Random random;
    std::vector<double> all(std::begin(numbers), std::end(numbers));
    for (int i = 0; i < 20000; ++i)
        all.push_back(random.next() * std::pow(10, static_cast<int>(random.below(40)) - 20));
    for (const double number : all) {
        std::string text;
        append_number(text, number);
        const double again = *parse_number(text);
        assert_memory_equal(&again, &number, sizeof number);
    }
    std::string text;
    for (const double number : {0.1, 1e5, -2.0, 1e-7, 0.0})
        append_number(text += ' ', number);
    assert_string_equal(text.c_str(), " 0.1 100000 -2 1e-07 0");
}

void bvh_comes_back(void**) {
    const std::string named = replaced(replaced(small_bvh, "JOINT Leg", "JOINT  the left  Leg "),
                                       "End Site", "End Site toe tip");
    const std::string mixed = replaced(small_bvh, "Xposition Yposition Zposition Zrotation",
                                       "Zposition Zrotation Xposition Yposition");
    const std::string rigid = replaced(small_bvh, "OFFSET 3.0 5.0 0.0\n    CHANNELS 1 Xrotation",
                                       "OFFSET 3.0 5.0 0.0\n JOINT\n{\nOFFSET 0 0 1e-300\n"
                                       "CHANNELS 1 Xrotation\n}\n");
    for (const std::string& text : {small_bvh, named, mixed, rigid}) {
        Clip clip = parse(text, Format::bvh);
        check_same(through_file(clip, "a.bvh"), clip);
        for (std::int64_t c = 0; c < clip.values.cols(); ++c)
            for (std::int64_t i = 0; i < clip.frames(); ++i)
                clip.values(i, c) = numbers[static_cast<std::size_t>(7 * i + c) % 17];
        check_same(through_file(clip, "a.BVH"), clip);
    }
}

/// A file lists each branch to its end; arrays may list the joints level by level.
void bvh_of_joints_in_another_order(void**) {
    SkeletonArrays arrays;
    const struct {
        const char* name;
        int parent;
        Vec3 offset;
    } joints[] = {{"hip", -1, {0, 9, 0}},
                  {"left knee", 0, {1, -4, 0}},
                  {"right knee", 0, {-1, -4, 0}},
                  {"left foot", 1, {0, -4, 1}},
                  {"right foot", 2, {0, -4, 2}}};
    for (const auto& [name, parent, offset] : joints) {
        Joint& joint = arrays.skeleton.joints.emplace_back();
        joint.name = name;
        joint.parent = parent;
        joint.offset = offset;
        joint.channels = {Channel::rz, Channel::rx, Channel::ry};
    }
    const Matrix angles = [] {
        Random random;
        Matrix values(6, 15);
        for (std::int64_t i = 0; i < 6 * 15; ++i)
            values.data()[i] = 40 * random.next();
        return values;
    }();
    arrays.form = RotationForm::channels;
    arrays.rotations = angles.view();
    arrays.fps = 25;
    const Clip clip = clip_from_skeleton(arrays);
    const Clip back = through_file(clip, "levels.bvh");
    const std::size_t order[] = {0, 1, 3, 2, 4};
    const Matrix at = positions(clip), found = positions(back);
    assert_int_equal(back.skeleton->joints.size(), 5);
    for (std::size_t to = 0; to < 5; ++to) {
        const Joint &joint = back.skeleton->joints[to], &from = clip.skeleton->joints[order[to]];
        assert_string_equal(joint.name.c_str(), from.name.c_str());
        assert_int_equal(joint.parent, to == 0 ? -1 : to == 1 || to == 3 ? 0 : to - 1);
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            for (std::int64_t c = 0; c < 3; ++c)
                ASSERT_NEAR(found(i, 3 * static_cast<std::int64_t>(to) + c),
                            at(i, 3 * static_cast<std::int64_t>(order[to]) + c), 1e-12);
    }
}

/// Breaks within a stretch remain, and each seam is another; those at its ends are none.
void breaks_are_cut_with_the_clip(void**) {
    Clip clip;
    clip.fps = 100;
    clip.values = Matrix(100, 1);
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 0) = static_cast<double>(i);
    clip.breaks = {10, 30, 60};
    const Clip made = cut(clip, {{20, 60}, {60, 80}, {5, 11}});
    assert_true((made.breaks == std::vector<std::int64_t>{10, 40, 60, 65}));
    assert_int_equal(made.frames(), 66);
    assert_true(made.values(10, 0) == 30 && made.values(40, 0) == 60 && made.values(65, 0) == 10);
}

void bvh_has_the_usual_layout(void**) {
    assert_string_equal(find_format(Format::bvh)->write(parse(small_bvh, Format::bvh)).c_str(),
                        R"(HIERARCHY
ROOT Hips
{
	OFFSET 0 0 0
	CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
	JOINT Leg
	{
		OFFSET 1 -2 0.5
		CHANNELS 3 Zrotation Xrotation Yrotation
		End Site
		{
			OFFSET 0 -4 0
		}
	}
	JOINT Arm
	{
		OFFSET 3 5 0
		CHANNELS 1 Xrotation
		End Site
		{
			OFFSET 6 0 0
		}
	}
}
MOTION
Frames: 3
Frame Time: 0.0083333
1 2 3 0 0 0 0 0 0 0
2 3 4 10 20 30 40 50 60 70
3 4 5 11 21 31 41 51 61 71
)");
}

void a_frame_rate_that_was_given_is_written(void**) {
    ReadOptions options;
    options.fps = 25;
    const Clip clip = parse(small_bvh, Format::bvh, options);
    assert_true(clip.frame_time == 0);
    const Clip again = through_file(clip, "a.bvh");
    assert_true(again.fps == 25 && again.frame_time == 0.04);
}

/// The arm has position channels with these values in every frame.
std::string bvh_with_moving_arm(const char* x_y_z) {
    std::string text = replaced(small_bvh, "CHANNELS 1 Xrotation",
                                "CHANNELS 4 Xposition Yposition Zposition Xrotation");
    for (const char* last : {" 0\n2 3", " 70\n", " 71\n"})
        text = replaced(text, last, std::string(" ") + x_y_z + last);
    return text;
}

void positions_are_written_to_replace_offsets(void**) {
    const Clip replacing = parse(bvh_with_moving_arm("3.1 5 0"), Format::bvh);
    assert_false(replacing.skeleton->joints[3].adds);
    check_same(through_file(replacing, "a.bvh"), replacing);
    const Clip adding = parse(bvh_with_moving_arm("0.1 0 0"), Format::bvh);
    assert_true(adding.skeleton->joints[3].adds);
    const Clip again = through_file(adding, "a.bvh");
    assert_false(again.skeleton->joints[3].adds);
    assert_true(again.values(1, 9) == 3.1 && again.values(1, 10) == 5);
    check_same_positions(again, adding, 0);
}

void positions_that_would_be_misread_are_converted(void**) {
    for (const bool add : {false, true}) {
        Clip clip = parse(bvh_with_moving_arm("3 5 0"), Format::bvh);
        clip.skeleton = with_positions(*std::move(clip.skeleton), add);
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            for (std::int64_t c = 9; c < 12; ++c)
                clip.values(i, c) = add ? 4 : 0.5; // looks like the other meaning
        assert_true(positions_add_to_offsets(clip) != add);
        const Clip again = through_file(clip, "a.bvh");
        assert_true(again.skeleton->joints[3].adds != add);
        check_same_positions(again, clip, 1e-15);
    }
}

struct SmallAmc {
    TemporaryFolder folder;
    ReadOptions options;
    Clip clip;

    explicit SmallAmc(const std::string& amc = small_amc, const std::string& asf = small_asf) {
        options.skeleton = folder.write("small.asf", asf);
        clip = parse(amc, Format::amc, options);
    }
};

void amc_comes_back(void**) {
    const std::string radians = replaced(replaced(small_amc, ":DEGREES\n", ""), "90", "1.5");
    const std::string slow = replaced(small_amc, ":DEGREES", ":SAMPLES-PER-SECOND 59.94\n:DEGREES");
    const std::string asf_in_radians = replaced(small_asf, "angle deg", "angle rad");
    for (const auto& [amc, asf] :
         {std::pair{small_amc, small_asf}, {radians, asf_in_radians}, {slow, small_asf}}) {
        const SmallAmc small(amc, asf);
        check_same(through_file(small.clip, "a.amc", small.options), small.clip);
    }
    assert_string_equal(find_format(Format::amc)->write(SmallAmc().clip).c_str(),
                        replaced(small_amc, "#!OML:ASF small.ASF\n", "").c_str());
}

void amc_has_its_skeleton_beside_it(void**) {
    const SmallAmc small;
    const TemporaryFolder folder;
    const std::string other = replaced(small_asf, "length 10", "length 20");
    for (const char* name : {"X_1.ASF", "x.asf"}) // would be found if there were no x_1.asf
        folder.write(name, other);
    const std::string amc = folder.path("x_1.amc");
    for (int time = 0; time < 2; ++time) {
        write(small.clip, amc);
        const Clip again = read(amc, {});
        check_same(again, small.clip);
        assert_true(again.skeleton->asf == small_asf);
    }
    write(cut(small.clip, {{1, 2}}), folder.path("part.amc"));
    check_same_bits(positions(read(folder.path("part.amc"), {})),
                    positions(cut(small.clip, {{1, 2}})));
}

void skeletons_of_others_stay(void**) {
    const SmallAmc small;
    const TemporaryFolder folder;
    const std::string other = folder.write("x.asf", "another");
    ASSERT_FAILS(Status::io, "x.asf: exists and is another skeleton",
                 write(small.clip, folder.path("x.amc")));
    assert_true(content_of(other) == "another" && !fs::exists(folder.path("x.amc")));
    fs::create_symlink("no folder/y.amc", folder.path("y.amc"));
    ASSERT_FAILS(Status::io, "y.amc: cannot write", write(small.clip, folder.path("y.amc")));
    assert_false(fs::exists(folder.path("y.asf")));
    assert_int_equal(::mkfifo(folder.path("p.asf").c_str(), 0600), 0);
    ::alarm(20); // opening the pipe to compare its content would wait forever
    ASSERT_FAILS(Status::io, "p.asf: is not a regular file",
                 write(small.clip, folder.path("p.amc")));
    ::alarm(0);
    fs::create_symlink("/dev/null", folder.path("z.amc"));
    write(small.clip, folder.path("z.amc"));
    assert_false(fs::exists(folder.path("z.asf")));
}

/// All features of ASF: a turned root, orders of axes, bones with one and two axes, a rigid bone
/// with a child.
std::string elaborate_asf() {
    std::string asf = replaced(small_asf, "orientation 0 0 0", "orientation 10 -20 30");
    asf = replaced(asf, "position 0 0 0", "position 3 -2 1");
    asf = replaced(asf, "axis XYZ\n", "axis ZXY\n");
    asf = replaced(asf, "order TX TY TZ RX RY RZ", "order RY TX TZ RX TY RZ");
    asf = replaced(asf, "dof rx ry rz", "dof rz rx");
    return replaced(asf, "root thigh spine\n    thigh shank",
                    "root spine\n    spine thigh\n"
                    "thigh shank");
}

void amc_becomes_a_bvh_of_the_same_motion(void**) {
    const std::string amc =
        replaced(replaced(small_amc, "thigh 5 6 7", "thigh 5 6"), "thigh 6 7 8", "thigh 100 -70");
    for (const Clip& clip : {SmallAmc().clip, SmallAmc(amc, elaborate_asf()).clip}) {
        const Clip bvh = through_file(clip, "a.bvh");
        assert_true(bvh.fps == 120 && bvh.format == Format::bvh);
        for (std::size_t j = 0; j < clip.skeleton->joints.size(); ++j)
            assert_true(bvh.skeleton->joints[j].name == clip.skeleton->joints[j].name);
        check_same_positions(bvh, clip, 1e-14);
        check_same(through_file(bvh, "a.bvh"), bvh);
    }
}

void angles_do_not_jump_when_amc_becomes_bvh(void**) {
    Clip clip = SmallAmc().clip; // the thigh's axis is turned by 20 degrees about z
    clip.values = Matrix(80, clip.values.cols());
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        clip.values(i, 6) = 10 * static_cast<double>(i);
    const Clip bvh = through_file(clip, "a.bvh");
    for (std::int64_t i = 1; i < bvh.frames(); ++i)
        for (std::int64_t c = 6; c < 9; ++c)
            ASSERT_NEAR(bvh.values(i, c), bvh.values(i - 1, c), 15);
    check_same_positions(bvh, clip, 1e-14);
}

void bare_numbers_come_back(void**) {
    const std::string named = "time,a,\"b, c\",t d\n0,1,2,3\n0.5,5,6,7\n1,9,8,6.5\n";
    const std::string nameless = "a,,time\n3,5,0\n4,6,1\n";
    for (const std::string& text :
         {named, nameless, std::string("1 2\n3 4\n"), std::string("x\n1\n2\n"),
          std::string("\"x y\"\n1\n2\n"), std::string("1;2;3\n"),
          std::string("time,1,2\n0,1,2\n0.01,5,6\n")}) {
        const Clip clip = parse(text, Format::csv);
        const Clip csv = through_file(clip, "a.csv");
        check_same_bits(csv.values, clip.values);
        assert_true(csv.channel_names == clip.channel_names && csv.fps == clip.fps);
        check_same_bits(through_file(clip, "a.npy").values, clip.values);
    }
}

void numbers_of_poses_go_into_tables(void**) {
    const Clip clip = parse(replaced(small_bvh, "ROOT Hips", "ROOT \"#1\" of, all"), Format::bvh);
    const Clip csv = through_file(clip, "a.csv");
    check_same_bits(csv.values, clip.values);
    assert_true(csv.fps == 120);
    assert_string_equal(csv.channel_names[0].c_str(), "\"#1\" of, all.tx");
    assert_string_equal(csv.channel_names[9].c_str(), "Arm.rx");
    check_same_bits(through_file(clip, "a.npy").values, clip.values);
}

void clips_that_a_format_cannot_hold_are_refused(void**) {
    const TemporaryFolder folder;
    const Clip bvh = parse(small_bvh, Format::bvh);
    for (const char* name : {"a.txt", "a", ".bvh", "a.bvh.gz"})
        ASSERT_FAILS(Status::argument, ".bvh, .amc, .csv, .npy", write(bvh, folder.path(name)));
    ASSERT_FAILS(Status::unsupported, "read from AMC", write(bvh, folder.path("a.amc")));
    const Clip numbers_only = parse("1,2\n3,4\n", Format::csv);
    ASSERT_FAILS(Status::unsupported, "needs a skeleton",
                 write(numbers_only, folder.path("a.bvh")));
    ASSERT_FAILS(Status::unsupported, "read from AMC", write(numbers_only, folder.path("a.amc")));
    Clip timeless = parse(replaced(small_bvh, "0.0083333", "0"), Format::bvh);
    ASSERT_FAILS(Status::unsupported, "option fps", write(timeless, folder.path("a.bvh")));
    timeless.fps = 1e-9;
    ASSERT_FAILS(Status::unsupported, "takes at most 1 s", write(timeless, folder.path("a.bvh")));
    assert_true(fs::is_empty(folder.path("")));
}

void a_file_is_replaced_whole(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.txt", "old");
    assert_int_equal(chmod(path.c_str(), 0640), 0);
    fs::create_symlink("a.txt", folder.path("link"));
    write_file(folder.path("link"), "new");
    assert_true(fs::is_symlink(folder.path("link")));
    fs::create_symlink("new.txt", folder.path("link to nothing yet"));
    write_file(folder.path("link to nothing yet"), "first");
    assert_true(fs::is_symlink(folder.path("link to nothing yet")));
    assert_true(content_of(folder.path("new.txt")) == "first");
    assert_true(content_of(path) == "new");
    assert_int_equal(fs::status(path).permissions(), fs::perms(0640));
    assert_int_equal(std::distance(fs::directory_iterator(folder.path("")), {}), 4);
}

void a_file_that_cannot_be_written_stays(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.txt", "old");
    // At most ten bytes per file from here on.
    (void)std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit small{10, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Failure failure = failure_of([&] { write_file(path, "twelve bytes"); });
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_true(failure.status == Status::io);
    assert_true(failure.text.find("a.txt: cannot write: File too large") != failure.text.npos);
    assert_true(content_of(path) == "old");
    assert_int_equal(std::distance(fs::directory_iterator(folder.path("")), {}), 1);

    ASSERT_FAILS(Status::io, "cannot write: No such file or directory: create the folder first",
                 write_file(folder.path("b/c"), ""));
    ASSERT_FAILS(Status::io, "cannot write: Is a directory: give a file in this folder",
                 write_file(folder.path(""), ""));
    fs::create_symlink("/dev/full", folder.path("full"));
    ASSERT_FAILS(Status::io, "cannot write: No space left", write_file(folder.path("full"), "x"));
    assert_true(fs::is_symlink(folder.path("full")));
}

void names_of_temporary_files_in_use_are_skipped(void**) {
    const TemporaryFolder folder;
    const std::string left = folder.write(stltsa::format_text(".stltsa-{}-0.tmp", getpid()), "x");
    write_file(folder.path("a"), "new");
    assert_true(content_of(folder.path("a")) == "new" && content_of(left) == "x");
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(numbers_read_back_to_the_same_bits),
        cmocka_unit_test(bvh_comes_back),
        cmocka_unit_test(bvh_of_joints_in_another_order),
        cmocka_unit_test(breaks_are_cut_with_the_clip),
        cmocka_unit_test(bvh_has_the_usual_layout),
        cmocka_unit_test(a_frame_rate_that_was_given_is_written),
        cmocka_unit_test(positions_are_written_to_replace_offsets),
        cmocka_unit_test(positions_that_would_be_misread_are_converted),
        cmocka_unit_test(amc_comes_back),
        cmocka_unit_test(amc_has_its_skeleton_beside_it),
        cmocka_unit_test(skeletons_of_others_stay),
        cmocka_unit_test(amc_becomes_a_bvh_of_the_same_motion),
        cmocka_unit_test(angles_do_not_jump_when_amc_becomes_bvh),
        cmocka_unit_test(bare_numbers_come_back),
        cmocka_unit_test(numbers_of_poses_go_into_tables),
        cmocka_unit_test(clips_that_a_format_cannot_hold_are_refused),
        cmocka_unit_test(a_file_is_replaced_whole),
        cmocka_unit_test(a_file_that_cannot_be_written_stays),
        cmocka_unit_test(names_of_temporary_files_in_use_are_skipped),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
