// SPDX-License-Identifier: BSD-3-Clause
// Points in space, such as markers: names, gaps, and what is removed.
#include "clip/testing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "clip/features/gaps.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/points.hpp"
#include "clip/features/prepare.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
using stltsa::Matrix;

constexpr double fps = 60;
constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Where a body is at a time in seconds: x, y, height, heading.
struct Place {
    double x = 0, y = 0, height = 0, heading = 0;
};

/// Ten points of a body that walks at one step a second, z up; the place varies over time.
template <class PlaceAt>
Clip walker(double seconds, const PlaceAt& place_at) {
    constexpr std::int64_t count = 10;
    Clip clip;
    clip.fps = fps;
    clip.space = 3;
    clip.channel_names = columns_of_points(count);
    clip.values = Matrix(static_cast<std::int64_t>(seconds * fps), 3 * count);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        const double t = static_cast<double>(i) / fps;
        const Place place = place_at(t);
        for (std::int64_t p = 0; p < count; ++p) {
            const double side = p % 2 == 0 ? -1 : 1;
            const auto level = static_cast<double>(p / 2);
            const double swing = 0.25 * std::abs(level - 2) / 2 *
                                 std::sin(2 * std::numbers::pi * t) * (level < 2 ? side : -side);
            const double forward = 0.05 * level + swing;
            const double across = side * (0.1 + 0.04 * level);
            const double c = std::cos(place.heading), s = std::sin(place.heading);
            clip.values(i, 3 * p) = place.x + c * forward - s * across;
            clip.values(i, 3 * p + 1) = place.y + s * forward + c * across;
            clip.values(i, 3 * p + 2) =
                place.height + 0.1 + 0.4 * level + 0.03 * std::cos(4 * std::numbers::pi * t);
        }
    }
    return clip;
}

Clip walker_in_place() {
    return walker(20, [](double) { return Place(); });
}

Matrix rows(const Clip& clip) {
    return features(clip, Features::points, Axis::z);
}

/// Root mean square of the entries of rows first to last.
double rms(const Matrix& a, std::int64_t first, std::int64_t last) {
    double sum = 0;
    for (std::int64_t i = first; i < last; ++i)
        for (std::int64_t c = 0; c < a.cols(); ++c)
            sum += a(i, c) * a(i, c);
    return std::sqrt(sum / static_cast<double>((last - first) * a.cols()));
}

Matrix difference(const Matrix& a, const Matrix& b) {
    Matrix result = Matrix::unset(a.rows(), a.cols());
    for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
        result.data()[i] = a.data()[i] - b.data()[i];
    return result;
}

void other_matrices_stay_raw(void**) {
    Clip clip = walker_in_place();
    assert_true(feature_kind(clip, {}) == Features::points);
    check_same(features(clip, Features::raw, {}), clip.values, 0);
    clip.values(3, 0) = clip.values(3, 1) = clip.values(3, 2) = 0;
    check_same(features(clip, Features::raw, {}), clip.values, 0);
    clip.space = 0;
    clip.channel_names.clear();
    assert_true(feature_kind(clip, {}) == Features::raw);
    check_same(features(clip, {}, {}), clip.values, 0);
    check_same(features(clip, Features::points, Axis::z), rows(clip), 0); // unless asked for
}

void only_points_can_be_points(void**) {
    Clip clip;
    clip.values = Matrix(5, 10);
    ASSERT_FAILS(Status::unsupported, "three columns", features(clip, Features::points, {}));
    ASSERT_FAILS(Status::unsupported, "use positions",
                 features(parse(small_bvh, Format::bvh), Features::points, {}));
}

void place_and_heading_of_the_recording_are_removed(void**) {
    const Matrix wanted = rows(walker_in_place());
    for (const double heading : {0.0, 0.7, 3.0, -2.0})
        check_same(rows(walker(20,
                               [=](double) {
                                   return Place{300, -20, 5, heading};
                               })),
                   wanted, 1e-9);
}

void path_is_removed(void**) {
    const Matrix wanted = rows(walker_in_place());
    check_same(rows(walker(20,
                           [](double t) {
                               return Place{1.3 * t, 2 * std::sin(0.4 * t)};
                           })),
               wanted, 1e-9);
    check_same(rows(walker(20, [](double t) { return Place{t < 10 ? t : 20 - t}; })), wanted, 1e-9);
}

/// The heading of a frame does not matter at all.
void turning_path_is_removed(void**) {
    constexpr double turn = std::numbers::pi;
    const Matrix wanted = rows(walker_in_place());
    const auto circle = [](double t) {
        return Place{std::cos(0.4 * t), std::sin(0.4 * t), 0, 0.4 * t};
    };
    const auto there_and_back = [](double t) {
        return Place{t < 10 ? t : 20 - t, 0, 0, turn * std::clamp(2 * (t - 10), 0.0, 1.0)};
    };
    check_same(rows(walker(20, circle)), wanted, 1e-9);
    check_same(rows(walker(20, there_and_back)), wanted, 1e-9);
}

/// Two points that circle beside the body turn the running reference a little in each round.
void heading_does_not_drift(void**) {
    Clip clip = walker(120, [](double) { return Place(); });
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (const std::int64_t p : {8, 9}) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / fps;
            clip.values(i, 3 * p) += 0.3 * std::cos(angle);
            clip.values(i, 3 * p + 1) += 0.3 * std::sin(angle);
        }
    const Matrix found = rows(clip);
    const auto heading = [&](std::int64_t first) { // from the left to the right feet
        double a = 0, b = 0;
        for (std::int64_t i = first; i < first + 600; ++i) {
            a += found(i, 3) - found(i, 0);
            b += found(i, 4) - found(i, 1);
        }
        return std::atan2(b, a);
    };
    for (const std::int64_t first : {1200, 3600, 6600})
        ASSERT_NEAR(heading(first), heading(0), 0.01);
}

/// A slope goes, a jump stays.
void slow_height_is_removed(void**) {
    const Matrix wanted = rows(walker_in_place());
    const auto jump = [](double t) {
        return std::abs(t - 10) < 0.25 ? 0.4 - 6.4 * (t - 10) * (t - 10) : 0;
    };
    const Matrix up_hill = rows(walker(20, [](double t) { return Place{t, 0, 0.1 * t, 0}; }));
    assert_true(rms(difference(up_hill, wanted), 480, 720) < 1e-3);
    const Matrix jumps = rows(walker(20, [&](double t) { return Place{0, 0, jump(t), 0}; }));
    for (const std::int64_t i : {540, 595, 600, 605, 660})
        ASSERT_NEAR(jumps(i, 2) - wanted(i, 2), jump(static_cast<double>(i) / fps), 0.03);
}

void points_in_a_plane_keep_their_heading(void**) {
    // In a plane, a body has two headings, and a walk would turn it around at each step.
    Clip flat = walker(20, [](double) { return Place(); });
    for (std::int64_t i = 0; i < flat.frames(); ++i)
        for (std::int64_t c = 1; c < flat.values.cols(); c += 3)
            flat.values(i, c) = 2;
    const FeatureRows made = points(flat, Axis::z, GapRule::fill);
    assert_true(made.notes.back().find("not the heading") != std::string::npos);
    for (std::int64_t i = 0; i < flat.frames(); ++i) {
        ASSERT_NEAR(made.rows(i, 1), 0, 1e-12);
        ASSERT_NEAR(made.rows(i, 0) - made.rows(i, 3), flat.values(i, 0) - flat.values(i, 3),
                    1e-12);
    }
}

/// While the points are almost above each other, their direction is noise.
void heading_is_held_while_the_shape_collapses(void**) {
    Clip clip = walker_in_place();
    const auto collapsed = [](std::int64_t i) { return i >= 600 && i < 630; };
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        for (std::int64_t c = 0; collapsed(i) && c < clip.values.cols(); c += 3) {
            const double x = clip.values(i, c);
            clip.values(i, c) = -0.01 * clip.values(i, c + 1); // a quarter turn
            clip.values(i, c + 1) = 0.01 * x;
        }
    const Matrix wanted = rows(walker_in_place());
    const Matrix found = rows(clip);
    for (const std::int64_t i : {590, 615, 640}) {
        // Direction of the first point, relative to where it is without the collapse.
        const double cross = wanted(i, 0) * found(i, 1) - wanted(i, 1) * found(i, 0);
        const double dot = wanted(i, 0) * found(i, 0) + wanted(i, 1) * found(i, 1);
        ASSERT_NEAR(std::atan2(cross, dot), collapsed(i) ? std::numbers::pi / 2 : 0, 1e-3);
    }
}

void features_of_a_body_that_comes_and_goes(void**) {
    const Clip whole = walker(20, [](double t) { return Place{1.3 * t, 0, 0, 0.1 * t}; });
    Clip clip = whole;
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        if (i < 500 || i >= 900)
            std::fill_n(clip.values.row(i), 30, gap);
    Clip alone = whole;
    alone.values = copied(whole.values.view().block(500, 400));
    const FeatureRows made = points(clip, Axis::z, GapRule::fill);
    const Matrix wanted = rows(alone);
    assert_int_equal(made.rows.rows(), clip.frames());
    for (std::int64_t i = 0; i < clip.frames(); ++i)
        assert_memory_equal(made.rows.row(i), wanted.row(std::clamp<std::int64_t>(i - 500, 0, 399)),
                            30 * sizeof(double));
    assert_true(made.notes.front() ==
                "frames 0 to 499: most points are missing, so no motion is found there");
    ASSERT_FAILS(Status::not_finite, "frames 0 to 499: most points are missing",
                 points(clip, Axis::z, GapRule::refuse));
}

void points_without_names_have_numbers(void**) {
    Clip clip;
    clip.values = Matrix(10, 12);
    for (std::int64_t i = 0; i < 10; ++i)
        clip.values(i, 9) = 1;
    for (const std::vector<std::string>& all :
         {std::vector<std::string>(), std::vector<std::string>(12)}) {
        clip.channel_names = all;
        const FeatureRows made = points(clip, Axis::z, GapRule::fill);
        assert_true(made.notes.front().ends_with("left out: 1, 2, 3"));
    }
}

/// Points that drop out change little, whether as zeros or as gaps, and those that are left out
/// change nothing for the others.
void missing_points_do_not_move_the_others(void**) {
    const Clip whole = walker(20, [](double t) { return Place{1.3 * t}; });
    const Matrix wanted = rows(whole);
    for (const double missing : {0.0, gap}) {
        Clip clip = whole;
        for (std::int64_t i = 300; i < 303; ++i)
            std::fill_n(clip.values.row(i) + 6, 3, missing);
        assert_true(rms(difference(rows(clip), wanted), 300, 303) < 0.01);
    }
    Clip more = whole;
    more.channel_names = columns_of_points(11);
    more.values = Matrix(whole.frames(), 33);
    for (std::int64_t i = 0; i < whole.frames(); ++i)
        std::copy_n(whole.values.row(i), 30, more.values.row(i));
    const FeatureRows made = points(more, Axis::z, GapRule::fill);
    assert_true(made.notes.front().find("left out: 'm10'") != std::string::npos);
    for (std::int64_t i = 0; i < whole.frames(); ++i) {
        for (std::int64_t c = 0; c < 30; ++c)
            ASSERT_NEAR(made.rows(i, c), wanted(i, c), 1e-9);
        assert_true(made.rows(i, 30) == 0 && made.rows(i, 31) == 0 && made.rows(i, 32) == 0);
    }
}

void too_few_points_stay(void**) {
    Clip clip;
    clip.fps = fps;
    clip.values = Matrix(50, 6);
    for (std::int64_t i = 0; i < 50; ++i)
        for (std::int64_t c = 0; c < 6; ++c)
            clip.values(i, c) = 1 + static_cast<double>(i * c);
    const FeatureRows made = points(clip, {}, GapRule::fill);
    check_same(made.rows, clip.values, 0);
    assert_true(made.up == Axis::none && made.notes.size() == 1);
    assert_true(points_up(clip) == Axis::none);
}

void up_is_guessed_and_said(void**) {
    for (const double speed : {0.0, 1.3}) { // on a treadmill, and through the room
        const Clip upright = walker(20, [=](double t) { return Place{speed * t}; });
        for (std::int64_t up = 1; up <= 3; ++up) {
            Clip clip = upright;
            for (std::int64_t i = 0; i < clip.frames(); ++i)
                for (std::int64_t c = 0; c < clip.values.cols(); ++c)
                    clip.values(i, c / 3 * 3 + (c + up) % 3) = upright.values(i, c);
            const Prepared prepared = prepare(clip, {});
            assert_true(prepared.features == Features::points);
            assert_int_equal(static_cast<std::int64_t>(prepared.up), up);
            assert_true(points_up(clip) == prepared.up);
            assert_true(prepared.notes.front().starts_with("up axis guessed"));
            assert_true(prepare(clip, {{}, prepared.up}).notes.size() == 1);
        }
    }
}

void up_is_not_along_the_path(void**) {
    Clip beast = walker(20, [](double t) { return Place{1.3 * t}; });
    for (std::int64_t i = 0; i < beast.frames(); ++i)
        for (std::int64_t p = 0; p < 10; ++p)
            beast.values(i, 3 * p) += 0.5 * static_cast<double>(p);
    assert_true(points_up(beast) == Axis::z);
}

void works_without_a_frame_rate(void**) {
    Clip clip = walker_in_place();
    clip.fps = 0;
    const FeatureRows made = points(clip, Axis::z, GapRule::fill);
    assert_true(made.notes.front().starts_with("frame rate unknown"));
    assert_true(std::abs(rms(made.rows, 0, 1200) / rms(rows(walker_in_place()), 0, 1200) - 1) <
                0.05);
}

std::string csv(std::string_view header) {
    return std::string(header) + "\n0,1,2,3,4,5,6,7,8,9\n0.1,1,2,3,,NaN,,7,8,9\n"
                                 "0.2,2,2,3,4,5,6,7,8,9\n";
}

void csv_of_points_may_have_gaps(void**) {
    const Clip clip = parse(csv("time,a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z"), Format::csv);
    assert_int_equal(clip.values.cols(), 9);
    assert_true(std::isnan(clip.values(1, 4)));
    const FeatureRows made = feature_rows(clip, {}, Axis::z);
    assert_true(made.notes.front().find("'b' (1 in all)") != std::string::npos);
    ASSERT_FAILS(Status::not_finite, "1 values in all: 'b'",
                 feature_rows(clip, {}, Axis::z, GapRule::refuse));
    // Of columns that are no points as well.
    const Clip other = parse(csv("time,a,b,c,d,e,f,g,h,i"), Format::csv);
    const FeatureRows raw = feature_rows(other, {}, {});
    assert_true(raw.rows(1, 3) == 4 && raw.rows(1, 4) == 5 && raw.rows(1, 5) == 6);
    assert_true(raw.notes.front().starts_with("columns without a value"));
}

/// A point that is lost for longer than the body needs for a step is where the others imply.
void long_gaps_are_predicted(void**) {
    const Clip whole = walker(20, [](double t) { return Place{1.3 * t}; });
    const Matrix wanted = rows(whole);
    Clip clip = whole;
    for (std::int64_t i = 300; i < 390; ++i)
        std::fill_n(clip.values.row(i) + 6, 3, gap);
    for (const GapRule rule : {GapRule::fill, GapRule::skip}) {
        const FeatureRows made = points(clip, Axis::z, rule);
        ASSERT_NEAR(rms(difference(made.rows, wanted), 300, 390), 0, 0.02); // of strides 0.5 wide
        assert_true(made.holes.empty());
        assert_true(made.notes.front().find("from the others") != std::string::npos);
    }
    ASSERT_FAILS(Status::not_finite, "set option gaps to fill or skip",
                 points(clip, Axis::z, GapRule::refuse));
}

/// At an end there is no line to a later place, however short the gap is.
void gaps_at_the_ends_are_predicted(void**) {
    const Clip whole = walker(20, [](double t) { return Place{1.3 * t}; });
    const Matrix wanted = rows(whole);
    Clip clip = whole;
    for (std::int64_t i = 0; i < 12; ++i) {
        std::fill_n(clip.values.row(i) + 6, 3, gap);
        std::fill_n(clip.values.row(clip.frames() - 1 - i) + 9, 3, gap);
    }
    const Matrix off = difference(rows(clip), wanted);
    for (std::int64_t i = 0; i < 12; ++i)
        printf("%g %g %g  %g %g %g\n", off(i, 6), off(i, 7), off(i, 8),
               off(clip.frames() - 1 - i, 9), off(clip.frames() - 1 - i, 10),
               off(clip.frames() - 1 - i, 11));
    for (std::int64_t i = 0; i < 12; ++i)
        for (std::int64_t c = 0; c < 3; ++c) {
            ASSERT_NEAR(off(i, 6 + c), 0, 0.02); // held in place: 0.2
            ASSERT_NEAR(off(clip.frames() - 1 - i, 9 + c), 0, 0.02);
        }
}

/// Nothing, one value, one frame.
void hostile_gaps(void**) {
    Clip nothing = walker_in_place();
    std::fill_n(nothing.values.data(), nothing.values.rows() * 30, gap);
    ASSERT_FAILS(Status::not_finite, "all points are missing",
                 points(nothing, Axis::z, GapRule::fill));
    nothing.values(700, 4) = 1; // a point needs three
    ASSERT_FAILS(Status::not_finite, "all points are missing",
                 points(nothing, Axis::z, GapRule::fill));
    std::fill_n(nothing.values.row(700), 3, 1.0);
    const FeatureRows one = points(nothing, Axis::z, GapRule::fill);
    assert_true(one.holes == (std::vector<Frames>{{0, 700}, {701, 1200}}));
    for (std::int64_t i = 0; i < 1200; ++i)
        assert_true(one.rows(i, 0) == 1 && one.rows(i, 29) == 0);
    Clip frame = walker_in_place();
    frame.values = copied(frame.values.view().block(0, 1));
    std::fill_n(frame.values.data(), 6, gap);
    const FeatureRows made = points(frame, Axis::z, GapRule::fill);
    assert_true(made.rows.rows() == 1 && made.holes.empty() && std::isfinite(made.rows(0, 6)));
}

/// While most points are gone for long, nothing is known.
void holes_are_found(void**) {
    Clip clip = walker_in_place();
    for (std::int64_t i = 600; i < 660; ++i)
        std::fill_n(clip.values.row(i) + (i % 2 == 0 ? 0 : 12), 18, gap);
    for (std::int64_t i = 100; i < 114; ++i) // a shorter one
        std::fill_n(clip.values.row(i), 30, gap);
    const FeatureRows made = points(clip, Axis::z, GapRule::fill);
    assert_int_equal(made.holes.size(), 1);
    assert_true(made.holes[0].begin == 600 && made.holes[0].end == 660);
    assert_true(made.notes.back().find("removed") != std::string::npos);
}

/// Seen from above, a body that turns has a heading; seen from the side, it does not.
void points_in_two_dimensions(void**) {
    const auto flat = [](const Clip& clip, std::int64_t first, std::int64_t second) {
        Clip result;
        result.fps = fps;
        result.space = 2;
        result.values = Matrix(clip.frames(), 20);
        for (std::int64_t i = 0; i < clip.frames(); ++i)
            for (std::int64_t p = 0; p < 10; ++p) {
                result.values(i, 2 * p) = clip.values(i, 3 * p + first);
                result.values(i, 2 * p + 1) = clip.values(i, 3 * p + second);
            }
        return result;
    };
    const auto last_note = [](const Clip& clip) {
        return points(clip, {}, GapRule::fill).notes.back();
    };
    const Clip circle = walker(20, [](double t) {
        return Place{std::cos(0.4 * t), std::sin(0.4 * t), 0, 0.4 * t};
    });
    const Clip straight = walker(20, [](double t) { return Place{1.3 * t}; });
    assert_true(last_note(flat(circle, 0, 1)).find("and the heading") != std::string::npos);
    assert_true(last_note(flat(straight, 0, 2)).find("not the heading") != std::string::npos);
    const Matrix side = features(flat(straight, 0, 2), {}, {});
    assert_int_equal(side.cols(), 20);
    check_same(side, features(flat(walker_in_place(), 0, 2), {}, {}), 1e-9);
}

/// The features with and without strays hardly differ, and the note counts them.
void check_strays(const Clip& clip, const Clip& disturbed, const char* note) {
    const FeatureRows made = feature_rows(disturbed, Features::points, Axis::z);
    assert_true(std::ranges::any_of(
        made.notes, [&](const std::string& each) { return each.find(note) != std::string::npos; }));
    const Matrix off = difference(made.rows, rows(clip));
    for (std::int64_t i = 0; i < off.rows() * off.cols(); ++i)
        assert_true(std::abs(off.data()[i]) < 0.02);
}

void points_that_jump_away_and_back_are_missing(void**) {
    const Clip clip = walker(20, [](double t) { return Place{1.3 * t}; });
    Clip disturbed = clip;
    for (const std::int64_t frame : {100, 101, 200, 333})
        disturbed.values(frame, 3 * 4 + 1) += 1;
    for (const std::int64_t frame : {100, 102, 700}) // exchanged
        for (std::int64_t c = 0; c < 3; ++c)
            std::swap(disturbed.values(frame, c), disturbed.values(frame, 3 * 9 + c));
    check_strays(clip, disturbed, "taken as missing there: 'm0', 'm4', 'm9' (10 in all)");
}

void fast_motion_is_no_stray(void**) {
    Clip clip = walker_in_place();
    for (std::int64_t i = 0; i < 15; ++i) // a punch of 0.25 s
        clip.values(300 + i, 3 * 4) +=
            0.3 * (1 - std::cos(std::numbers::pi * static_cast<double>(i + 1) / 8));
    for (std::int64_t i = 600; i < clip.frames(); ++i) // and a point that is somewhere else now
        clip.values(i, 3 * 7) += 0.5;
    for (const std::string& note : feature_rows(clip, Features::points, Axis::z).notes)
        assert_true(note.find("jump") == std::string::npos);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(other_matrices_stay_raw),
        cmocka_unit_test(only_points_can_be_points),
        cmocka_unit_test(place_and_heading_of_the_recording_are_removed),
        cmocka_unit_test(path_is_removed),
        cmocka_unit_test(turning_path_is_removed),
        cmocka_unit_test(heading_does_not_drift),
        cmocka_unit_test(slow_height_is_removed),
        cmocka_unit_test(points_in_a_plane_keep_their_heading),
        cmocka_unit_test(heading_is_held_while_the_shape_collapses),
        cmocka_unit_test(features_of_a_body_that_comes_and_goes),
        cmocka_unit_test(points_without_names_have_numbers),
        cmocka_unit_test(missing_points_do_not_move_the_others),
        cmocka_unit_test(too_few_points_stay),
        cmocka_unit_test(up_is_guessed_and_said),
        cmocka_unit_test(up_is_not_along_the_path),
        cmocka_unit_test(works_without_a_frame_rate),
        cmocka_unit_test(csv_of_points_may_have_gaps),
        cmocka_unit_test(long_gaps_are_predicted),
        cmocka_unit_test(gaps_at_the_ends_are_predicted),
        cmocka_unit_test(hostile_gaps),
        cmocka_unit_test(holes_are_found),
        cmocka_unit_test(points_in_two_dimensions),
        cmocka_unit_test(points_that_jump_away_and_back_are_missing),
        cmocka_unit_test(fast_motion_is_no_stray),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
