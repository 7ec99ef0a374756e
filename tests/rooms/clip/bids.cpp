// SPDX-License-Identifier: BSD-3-Clause
// Motion-BIDS: a motion file with the files that describe it.
#include "clip/testing.hpp"

#include <algorithm>

#include "clip/csv/bids.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using Names = std::vector<std::string>;

const std::string channels = "name\ttype\tcomponent\ttracked_point\tunits\tstatus\n"
                             "t\tLATENCY\tn/a\tn/a\ts\tgood\n"
                             "a1\tPOS\tz\tHeel\tmm\tgood\na2\tPOS\tx\tHeel\tmm\tgood\n"
                             "a3\tPOS\ty\tHeel\tmm\tgood\na4\tORNT\tquat_x\tHeel\tn/a\tbad\n"
                             "a5\tJNTANG\tn/a\tn/a\tdeg\tgood\n";

void names_of_channels(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a_channels.tsv", "\xEF\xBB\xBF" + channels);
    assert_true(channel_names(path) ==
                (Names{"time (s)", "Heel_z (mm)", "Heel_x (mm)", "Heel_y (mm)", "Heel_ornt_quat_x",
                       "a5_jntang (deg)"}));
    ASSERT_FAILS(Status::format, "there is no tracked_point",
                 channel_names(folder.write("b", "name\tcomponent\ttype\n")));
    ASSERT_FAILS(Status::format, "has no rows",
                 channel_names(folder.write("c", channels.substr(0, channels.find('\n')))));
}

/// The member of the outermost object, not a text or a member of another that is named so.
void rates(void**) {
    const TemporaryFolder folder;
    const auto rate = [&](const std::string& json) {
        return sampling_frequency(folder.write("a.json", json));
    };
    assert_true(rate("{\"SamplingFrequency\": 60}") == 60);
    assert_true(rate("{\"a\":\"SamplingFrequency\",\n\"SamplingFrequency\" : 59.94,\"b\":1}") ==
                59.94);
    assert_true(rate("{\"a\": {\"SamplingFrequency\": 7}, \"b\": [1, {\"c\": 2}]}") == 0);
    for (const char* json : {"", "{", "{\"SamplingFrequency\"", "{\"SamplingFrequency\": \"n/a\"}",
                             "{\"SamplingFrequency\": -1}", "{\"\\", "\"SamplingFrequency\": 5"})
        assert_true(rate(json) == 0);
}

void files_that_apply(void**) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path("d/sub-1/motion"));
    const std::string motion = folder.write("d/sub-1/motion/sub-1_task-a_run-2_motion.tsv", "1\n");
    assert_true(find_beside(motion, "_motion.json").empty());
    folder.write("task-a_motion.json", "{}"); // outside the dataset: d is no subject
    const std::string top = folder.write("d/task-a_motion.json", "{}");
    folder.write("d/task-b_motion.json", "{}");
    assert_true(find_beside(motion, "_motion.json") == top);
    const std::string near = folder.write("d/sub-1/motion/sub-1_task-a_motion.json", "{}");
    folder.write("d/sub-1/motion/sub-1_task-a_run-3_motion.json", "{}");
    assert_true(find_beside(motion, "_motion.json") == near);
    const std::string own = folder.write("d/sub-1/motion/sub-1_task-a_run-2_motion.json", "{}");
    assert_true(find_beside(motion, "_motion.json") == own);
    assert_true(motion_file(folder.path("d")) == motion && motion_file(motion) == motion);
    assert_true(motion_file(folder.path("d/sub-1/")) == motion);
}

/// Without a table of channels it is a table like any other.
void motion_files(void**) {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("a_motion.tsv", "0\t3\t1\t2\t0\t9\n.5\t6\t4\tn/a\t0\t9\n");
    assert_int_equal(read(path, {}).space, 0);
    folder.write("a_channels.tsv", channels);
    folder.write("a_motion.json", "{\"SamplingFrequency\": 30}");
    const Clip clip = read(path, {});
    assert_true(clip.space == 0 && clip.fps == 2); // of LATENCY; one point is too few beside others
    assert_int_equal(clip.values.cols(), 5);
    const std::string damaged = folder.write("a_motion.json", "{\"SamplingFrequency\" 30}");
    const auto notes = read(path, {}).notes;
    assert_true(std::ranges::find(notes, "no valid SamplingFrequency in " + damaged) !=
                notes.end());
    folder.write("a_channels.tsv", channels + "a6\tMISC\tn/a\tn/a\tn/a\tgood\n");
    ASSERT_FAILS(Status::format, "a_motion.tsv:1: 6 cells, but ", read(path, {}));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(names_of_channels),
        cmocka_unit_test(rates),
        cmocka_unit_test(files_that_apply),
        cmocka_unit_test(motion_files),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
