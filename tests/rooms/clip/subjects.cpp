// SPDX-License-Identifier: BSD-3-Clause
// Several people or animals in one file.
#include "clip/testing.hpp"

#include "clip/features/subjects.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

Clip csv(std::string_view text, const std::string& subject = {}) {
    ReadOptions options;
    options.subject = subject;
    return parse(text, Format::csv, options);
}

using Names = std::vector<std::string>;

const Names markers = {"LHEE", "RHEE", "LTOE", "RTOE", "LASI", "RASI", "SACR"};
const Names keypoints = {"nose", "tail", "left_ear", "right_ear"};
const Names numbers = {"1", "2", "3", "4"};

/// Each name behind each of the beginnings.
Names behind(const Names& beginnings, const Names& names) {
    Names all;
    for (const std::string& beginning : beginnings)
        for (const std::string& name : names)
            all.push_back(beginning + name);
    return all;
}

/// Names of the subjects; "?" after them if they are doubtful.
std::string subjects_in(const Names& names, Named kind = Named::points,
                        const std::vector<Subject>& stated = {}) {
    const SubjectsOfNames found = subjects_of_names(names, stated, kind);
    std::string text;
    for (const Subject& subject : found.subjects)
        text += (text.empty() ? "" : ", ") + subject.name;
    return text + (found.doubtful ? "?" : "");
}

#define ASSERT_SUBJECTS(expected, ...)                                                             \
    assert_string_equal(subjects_in(__VA_ARGS__).c_str(), expected)

void colons_are_behind_subjects(void**) {
    ASSERT_SUBJECTS("Viktor", {"Viktor:LHEE", "Viktor:RHEE"});
    ASSERT_SUBJECTS("A, B", {"A:heel", "B:toe", "ball"});
    ASSERT_SUBJECTS("", {"LHEE", "heel:", ":heel", ""});
    ASSERT_SUBJECTS("", Names());
    // Several levels.
    ASSERT_SUBJECTS("A, B", behind({"scene:A:", "scene:B:"}, markers));
    ASSERT_SUBJECTS("A, B", behind({"ref:scene:A:", "ref:scene:B:"}, numbers));
    Names floor = behind({"scene:A:", "scene:B:"}, markers);
    floor.insert(floor.end(), {"floor:1", "floor:2"});
    ASSERT_SUBJECTS("scene:A, scene:B, floor", floor);
    ASSERT_SUBJECTS("A", {"A:body:hip", "A:rig:thumb", "A:body:knee"});
    // Nobody's, and parts of a body.
    ASSERT_SUBJECTS("A", {"A:heel", "A:toe", "Unlabeled:1234", "*12", "unlabelled 3:x"});
    ASSERT_SUBJECTS("", behind({"LeftFoot:", "RightFoot:", "Pelvis:"}, numbers));
    ASSERT_SUBJECTS("", behind({"L:", "R:"}, {"heel", "toe", "knee"}));
}

void other_separators_need_names_of_bodies(void**) {
    for (const char* separator : {"_", ".", "-", "|", " ", "/", " - "}) {
        ASSERT_SUBJECTS(
            "Anna, Ben",
            behind({std::string("Anna") + separator, std::string("Ben") + separator}, markers));
        ASSERT_SUBJECTS(
            "",
            behind({std::string("Thigh") + separator, std::string("Shank") + separator}, numbers));
    }
    ASSERT_SUBJECTS("P1, P2", behind({"P1", "P2"}, markers));
    ASSERT_SUBJECTS("Anna_Smith, Ben_Jones", behind({"Anna_Smith_", "Ben_Jones_"}, markers));
    ASSERT_SUBJECTS("resident, intruder", behind({"resident_", "intruder_"}, keypoints));
    ASSERT_SUBJECTS("Body0, Body1", behind({"Body0_", "Body1_"}, keypoints));
    ASSERT_SUBJECTS("L, M", behind({"L_", "M_"}, markers));
    Names fewer = behind({"A_", "B_"}, markers);
    fewer.erase(fewer.begin(), fewer.begin() + 4); // fewer than half of the names are common
    ASSERT_SUBJECTS("", fewer);
}

void parts_of_one_body(void**) {
    ASSERT_SUBJECTS("", behind({"LTHI_", "RTHI_", "LSHA_", "RSHA_"}, numbers));
    ASSERT_SUBJECTS("", behind({"hip_", "knee_", "ankle_"}, {"left", "right"}));
    ASSERT_SUBJECTS("", behind({"L_", "R_"}, {"heel", "toe", "knee", "hip"}));
    ASSERT_SUBJECTS("", behind({"front_", "hind_"}, {"left_paw", "right_paw", "left_knee"}));
    ASSERT_SUBJECTS("", behind({"FL_", "FR_", "HL_", "HR_"}, {"paw", "knee", "hip"}));
    ASSERT_SUBJECTS("", behind({"near_fore_", "off_fore_", "off_hind_"}, {"hoof", "knee", "hip"}));
    ASSERT_SUBJECTS("", behind({"L_", "R_"}, {"eye_left", "eye_right", "mouth_left"}));
    ASSERT_SUBJECTS("",
                    behind({"subtalar_", "mtp_", "hip_"}, {"left_heel", "right_heel", "left_toe"}));
    ASSERT_SUBJECTS("", behind({"Pelvis_", "Head_"}, {"left_front", "right_front", "left_back"}));
    ASSERT_SUBJECTS("", behind({"S1_", "S2_", "S3_"}, {"a", "b", "c", "d"}));
    ASSERT_SUBJECTS("", {"hip", "knee", "left_hip", "left_knee", "right_hip", "right_knee"});
}

void numbered_words_are_subjects(void**) {
    ASSERT_SUBJECTS("person0, person1", behind({"person0_", "person1_"}, {"a", "b"}));
    ASSERT_SUBJECTS("mouse_1, mouse_2", behind({"mouse_1_", "mouse_2_"}, keypoints));
    ASSERT_SUBJECTS("mouseA, mouseB", {"mouseA.nose", "mouseB.nose"});
    ASSERT_SUBJECTS("mouse1, mouse2", {"nose_mouse1", "tail_mouse1", "nose_mouse2"});
    ASSERT_SUBJECTS("mouse_1, mouse_2", {"nose_mouse_1", "tail_mouse_1", "nose_mouse_2"});
    ASSERT_SUBJECTS("mouse1, mouse2", {"mouse1Nose", "mouse2Nose"});
    ASSERT_SUBJECTS("fish1, fish2", {"fish1", "fish2"});
    ASSERT_SUBJECTS("", {"person_1", "person_2", "person_3"}); // keypoints of one
    ASSERT_SUBJECTS("", {"mouse1_nose", "mouse1_tail", "cage_corner"});
}

void one_without_a_prefix(void**) {
    for (const char* prefix : {"B:", "B_"}) {
        Names names = markers;
        const Names others = behind({prefix}, markers);
        names.insert(names.end(), others.begin(), others.end());
        names.insert(names.end(), {"ball", "*12"});
        ASSERT_SUBJECTS("unnamed, B", names);
        assert_false(subjects_of_names(names, {}, Named::points).of.back().has_value());
    }
    ASSERT_SUBJECTS("scene, B", behind({"scene:", "scene:B:"}, markers));
}

/// Blocks, or side by side.
void the_same_names_twice(void**) {
    ASSERT_SUBJECTS("1, 2", behind({"", ""}, markers));
    ASSERT_SUBJECTS("1, 2",
                    behind({"", ""}, behind({"M"}, {"1", "2", "3", "4", "5", "6", "7", "8"})));
    ASSERT_SUBJECTS("A 1, A 2", behind({"A:", "A:"}, markers));
    ASSERT_SUBJECTS("1, 2", {"LHEE", "LHEE", "RHEE", "RHEE", "SACR", "SACR", "T10"});
    const SubjectsOfNames blocks = subjects_of_names(
        Names{"LHEE", "RHEE", "SACR", "RHEE", "SACR", "LHEE", "CLAV"}, {}, Named::points);
    assert_true(blocks.of[2] == 0 && blocks.of[3] == 1 && blocks.of[6] == 1);
    ASSERT_SUBJECTS("", {"LHEE", "LHEE", "RHEE", "RHEE", "C7", "CLAV", "STRN"}); // mistakes
    ASSERT_SUBJECTS("",
                    {"LHEE", "LHEE", "RHEE", "RHEE", "SACR", "SACR", "C7", "CLAV", "STRN", "T10"});
    ASSERT_SUBJECTS("", Names(20, "marker"));
    ASSERT_SUBJECTS("1, 2?", behind({"", ""}, {"hip", "knee", "ankle"})); // or two legs
}

void what_cannot_be_decided(void**) {
    ASSERT_SUBJECTS("cam1, cam2?", behind({"cam1_", "cam2_"}, keypoints));
    ASSERT_SUBJECTS("unnamed, filtered?", behind({"", "filtered_"}, markers));
    Names many = behind({"M"}, {"1", "2", "3", "4", "5", "6", "7", "8"});
    ASSERT_SUBJECTS("Anna, Ben?", behind({"Anna_", "Ben_"}, many));
    Names ends;
    for (const char* end : {"_1", "_2"})
        for (const char* const name : {"LHEE", "RHEE", "LTOE", "RTOE", "LKNE", "RKNE", "C7", "T10"})
            ends.push_back(std::string(name) + end);
    ASSERT_SUBJECTS("1, 2?", ends);
    many = behind({"Anna_", "Ben_"}, many);
    const SubjectPoints all = points_of_subject(many, "", "file");
    assert_true(all.points.size() == 16 && all.subject.empty());
    assert_string_equal(all.note.c_str(),
                        "points of the same names are read as those of one subject: if they are of "
                        "several, 'Anna', 'Ben', choose one with option subject");
    const SubjectPoints ben = points_of_subject(many, "Ben", "file");
    assert_true(ben.points.size() == 8 && ben.points[0] == 8);
}

/// Sensors and joints of one body have the same quantities.
void columns_of_other_quantities(void**) {
    for (const Names& quantities : {Names{"acc", "gyr", "mag"}, Names{"left_flexion", "left_knee"}})
        ASSERT_SUBJECTS("", behind({"EMG_", "IMU_"}, quantities), Named::columns);
    ASSERT_SUBJECTS("", behind({"IMU1:", "IMU2:"}, {"acc", "gyr", "mag"}), Named::columns);
    ASSERT_SUBJECTS("", behind({"hip_", "knee_"}, {"flexion_l", "flexion_r", "rotation_l"}),
                    Named::columns);
    const Names angles = {"hip_flexion", "knee_flexion", "ankle_flexion"};
    ASSERT_SUBJECTS("Anna, Ben", behind({"Anna:", "Ben:"}, angles), Named::columns);
    ASSERT_SUBJECTS("person1, person2", behind({"person1_", "person2_"}, angles), Named::columns);
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 'person1', 'person2'",
                 csv("person1_knee,person1_hip,person2_knee\n1,2,3\n4,5,6\n"));
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 'person1', 'person2'",
                 parse("nRows=2\nendheader\ntime\tperson1_knee\tperson2_knee\n0\t1\t2\n1\t3\t4\n",
                       Format::mot, {}));
    const Clip clip = csv("person1_knee,person1_hip,person2_knee\n1,2,3\n4,5,6\n", "person1");
    assert_true(clip.values.cols() == 2 && clip.channel_names[1] == "person1_hip");
}

void the_word_of_the_file(void**) {
    const std::vector<Subject> stated = {{"Anna", "left:"}, {"Ben", "B"}, {"Cleo", "Cleo:"}};
    Names names = {"left:LHEE", "BLHEE", "LHEE", "*12", "left:RHEE"};
    ASSERT_SUBJECTS("Anna, Ben, Cleo", names, Named::points, stated);
    const SubjectsOfNames found = subjects_of_names(names, stated, Named::points);
    assert_true(found.of[1] == 1 && found.of[2] == 2 && !found.of[3] && found.of[4] == 0);
    const SubjectPoints silent = points_of_subject({"p1", "p2"}, "", "file", stated);
    assert_true(silent.points.size() == 2 &&
                silent.note.find("the file has 3 subjects, 'Anna'") == 0);
    // One that is stated is not the only one if names say so.
    ASSERT_SUBJECTS("Anna", markers, Named::points, {{"Anna", "Anna:"}});
    ASSERT_SUBJECTS("unnamed, B", behind({"", "B:"}, markers), Named::points, {{"B", "B:"}});
}

void one_of_several_is_chosen(void**) {
    const std::vector<std::string> names = {"A:heel", "B:heel", "ball", "A:toe"};
    ASSERT_FAILS(Status::argument, "file: there are 2 subjects, 'A', 'B': choose one with option",
                 points_of_subject(names, "", "file"));
    ASSERT_FAILS(Status::argument, "option subject is 'C', but the subjects are 'A', 'B'",
                 points_of_subject(names, "C", "file"));
    const SubjectPoints a = points_of_subject(names, "A", "file");
    assert_true(a.subject == "A" && a.points == (std::vector<std::size_t>{0, 3}));
    assert_string_equal(a.note.c_str(),
                        "subject 'A' of 2: 'A', 'B'; 1 points of no subject are left out");
}

void one_subject_needs_no_choice(void**) {
    const SubjectPoints all = points_of_subject({"A:heel", "ball"}, "", "file");
    assert_true(all.subject == "A" && all.points.size() == 2 && all.note.empty());
    const SubjectPoints none = points_of_subject({"heel", "ball"}, "", "file");
    assert_true(none.subject.empty() && none.points.size() == 2);
    ASSERT_FAILS(Status::argument, "test: option subject is 'A', but the file names no subjects",
                 csv("heel_x,heel_y\n1,2\n3,4\n", "A"));
    ASSERT_FAILS(Status::argument, "names no subjects", csv("1,2\n3,4\n", "A"));
}

/// As programs number columns of the same name.
void counted_columns(void**) {
    const std::string rows = "\n1,2,3,4,5,6,7,8,9,10,11,12\n2,2,3,4,5,6,7,8,9,10,11,12\n";
    for (const std::string count : {".1", "_1"}) {
        std::string head;
        for (const std::string& end : {std::string(), count})
            for (const char* point : {"nose", "LHEE", "RHEE"})
                for (const char* axis : {"_x", "_y"})
                    head += (head.empty() ? "" : ",") + std::string(point) + axis + end;
        ASSERT_FAILS(Status::argument, "there are 2 subjects, '1', '2'", csv(head + rows));
        const Clip second = csv(head + rows, "2");
        assert_true(second.values.cols() == 6 && second.values(0, 0) == 7 && second.space == 2);
        assert_string_equal(second.channel_names[0].c_str(), "nose_x");
    }
    // All x before all y.
    const Clip by_axis =
        csv("nose_x,l_ear_x,tail_x,nose_x,l_ear_x,tail_x,nose_y,l_ear_y,tail_y,nose_y,"
            "l_ear_y,tail_y" +
                rows,
            "2");
    assert_true(by_axis.values.cols() == 6 && by_axis.values(0, 0) == 4 &&
                by_axis.values(0, 1) == 10);
    // A marker with a number is none.
    assert_true(csv("M_x,M_y,M_1_x,M_1_y,N_x,N_y\n1,2,3,4,5,6\n1,2,3,4,5,6\n").values.cols() == 6);
}

const std::string two = "A:heel_x,A:heel_y,B:heel_x,B:heel_y\n1,2,3,4\n5,6,7,8\n";

void points_of_others_are_left_out(void**) {
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 'A', 'B'", csv(two));
    const Clip clip = csv(two, "B");
    assert_true(clip.subject == "B" && clip.values.cols() == 2 && clip.values(0, 0) == 3 &&
                clip.values(1, 1) == 8);
    assert_true(clip.channel_names == (std::vector<std::string>{"B:heel_x", "B:heel_y"}));
    // Also if the columns are not taken as points.
    const Clip raw =
        csv("A:heel_x,A:heel_y,A:light,B:heel_x,B:heel_y,B:light\n1,2,3,4,5,6\n1,2,3,4,5,6\n", "B");
    assert_true(raw.channel_names == (Names{"B:heel_x", "B:heel_y", "B:light"}));
}

/// Individuals of DeepLabCut.
void individuals(void**) {
    const std::string text = "scorer,n,n,n,n,n,n\nindividuals,m1,m1,m1,m2,m2,m2\n"
                             "bodyparts,nose,nose,nose,nose,nose,nose\n"
                             "coords,x,y,likelihood,x,y,likelihood\n"
                             "0,1,2,1,3,4,1\n1,5,6,1,7,8,1\n";
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 'm1', 'm2'", csv(text));
    const Clip clip = csv(text, "m2");
    assert_true(clip.values.cols() == 2 && clip.values(1, 0) == 7);
    assert_string_equal(clip.channel_names[0].c_str(), "m2:nose_x");
    std::string other = text;
    assert_true(csv(other.replace(other.find("individuals"), 11, "Track"), "m2").subject == "m2");
    // The line says that they are individuals, whatever their names.
    for (const char* name : {"m1", "m2"})
        while (other.find(name) != std::string::npos)
            other.replace(other.find(name), 2, name == std::string("m1") ? "left" : "right");
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 'left', 'right'", csv(other));
}

const std::string tracks = "track,frame_idx,instance.score,nose.x,nose.y\n"
                           "t0,5,.9,1,2\nt1,5,.9,3,4\nt0,6,.9,5,6\nt0,8,.9,7,8\nt1,6,.9,9,10\n";

/// A row for each frame of each track; a frame without a row is missing.
void rows_of_tracks(void**) {
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 't0', 't1'", csv(tracks));
    const Clip clip = csv(tracks, "t0");
    assert_true(clip.subject == "t0");
    assert_int_equal(clip.frames(), 4);
    const auto c = clip.values.cols() - 2;
    assert_true(clip.values(0, c) == 1 && clip.values(1, c + 1) == 6 && clip.values(3, c) == 7);
    assert_true(std::isnan(clip.values(2, c)));
    assert_int_equal(csv(tracks, "t1").frames(), 2);
    // Numbers are subjects, too, if a frame has several rows.
    const std::string ids = "track,frame,a_x,a_y\n0,1,1,2\n1,1,3,4\n0,2,5,6\n1,2,7,8\n";
    ASSERT_FAILS(Status::argument, "there are 2 subjects, '0', '1'", csv(ids));
    assert_true(csv(ids, "1").frames() == 2);
}

void rows_that_are_not_frames(void**) {
    ASSERT_FAILS(Status::format, "several rows of one subject are of frame 5",
                 csv("track,frame,p_x,p_y\na,5,1,2\na,5,3,4\na,6,1,2\n"));
    ASSERT_FAILS(Status::format, "several rows of one subject are of frame 5",
                 csv("track,Frame Number,p_x,p_y\na,5,1,2\na,5,3,4\na,6,1,2\n"));
    const Clip uncounted = csv("track,frame,p_x,p_y\na,0.5,1,2\na,0.7,3,4\n");
    assert_int_equal(uncounted.frames(), 2);
}

/// Columns of text are left out; a text among numbers is an error.
void columns_of_text(void**) {
    const Clip clip = csv("side,x,note\nleft,1,\nright,2,a b\n");
    assert_true(clip.values.cols() == 1 && clip.values(1, 0) == 2);
    assert_string_equal(clip.notes.at(0).c_str(), "columns of text, left out: 'side', 'note'");
    ASSERT_FAILS(Status::format, "test:2: column 1 ('a'): 'x' is not a number",
                 csv("a,b\nx,1\n2,1\n"));
    ASSERT_FAILS(Status::format, "test:3: column 1 ('a'): 'x' is not a number",
                 csv("a,b\n2,1\nx,1\n"));
    ASSERT_FAILS(Status::format, "test:2: column 1 ('a'): 'x' is not a number",
                 csv("a,b\nx,y\nx,y\n"));
}

/// A date is no text, and its blank separates no cells.
void dates_are_times(void**) {
    for (const char* text : {"when,a,b\n2024-02-29 23:59:59.5,1,2\n2024-03-01 00:00:00.000,3,4\n",
                             "when;a;b\n2023-12-31T23:59:59.5Z;1;2\n2024-01-01T00:00:00Z;3;4\n",
                             "time,a,b\n12:00:00.25,1,2\n12:00:00.75,3,4\n"}) {
        const Clip clip = csv(text);
        assert_true(clip.fps == 2 && clip.values.cols() == 2 && clip.values(1, 1) == 4);
    }
    for (const char* text : {"2024-13-01 10:00:00", "10:61:00", "2024-01-01T"})
        assert_true(csv(std::string("a,b\n1,") + text + "\n2," + text + "\n").values.cols() == 1);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(colons_are_behind_subjects),
        cmocka_unit_test(other_separators_need_names_of_bodies),
        cmocka_unit_test(parts_of_one_body),
        cmocka_unit_test(numbered_words_are_subjects),
        cmocka_unit_test(one_without_a_prefix),
        cmocka_unit_test(the_same_names_twice),
        cmocka_unit_test(what_cannot_be_decided),
        cmocka_unit_test(columns_of_other_quantities),
        cmocka_unit_test(the_word_of_the_file),
        cmocka_unit_test(one_of_several_is_chosen),
        cmocka_unit_test(one_subject_needs_no_choice),
        cmocka_unit_test(counted_columns),
        cmocka_unit_test(points_of_others_are_left_out),
        cmocka_unit_test(individuals),
        cmocka_unit_test(rows_of_tracks),
        cmocka_unit_test(rows_that_are_not_frames),
        cmocka_unit_test(columns_of_text),
        cmocka_unit_test(dates_are_times),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
