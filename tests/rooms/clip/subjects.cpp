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

void prefixes_are_subjects(void**) {
    assert_true(subject_of("Viktor:LHEE") == "Viktor" && subject_of("a:b:heel") == "a");
    for (const char* name : {"LHEE", "heel:", ":heel", ""})
        assert_true(subject_of(name).empty());
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

const std::string two = "A:heel_x,A:heel_y,B:heel_x,B:heel_y\n1,2,3,4\n5,6,7,8\n";

void points_of_others_are_left_out(void**) {
    ASSERT_FAILS(Status::argument, "there are 2 subjects, 'A', 'B'", csv(two));
    const Clip clip = csv(two, "B");
    assert_true(clip.subject == "B" && clip.values.cols() == 2 && clip.values(0, 0) == 3 &&
                clip.values(1, 1) == 8);
    assert_true(clip.channel_names == (std::vector<std::string>{"B:heel_x", "B:heel_y"}));
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
        cmocka_unit_test(prefixes_are_subjects),
        cmocka_unit_test(one_of_several_is_chosen),
        cmocka_unit_test(one_subject_needs_no_choice),
        cmocka_unit_test(points_of_others_are_left_out),
        cmocka_unit_test(individuals),
        cmocka_unit_test(rows_of_tracks),
        cmocka_unit_test(rows_that_are_not_frames),
        cmocka_unit_test(columns_of_text),
        cmocka_unit_test(dates_are_times),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
