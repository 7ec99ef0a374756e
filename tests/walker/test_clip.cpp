// SPDX-License-Identifier: BSD-3-Clause
// The walker's clip agrees with its borders, and every setting has its documented effect.
#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "reading.hpp"

extern "C" {
#include <cmocka.h> // last: it defines fail as a macro
}

namespace {

using namespace walker;

void borders_cover_the_clip(void**) {
    for (const double fps : {15.0, 29.97, 120.0}) {
        Settings s;
        s.fps = fps;
        const Walk walk = make_walk(s);
        const char* kinds[] = {"preparing", "initial", "cyclic", "final", "wind-up"};
        assert_int_equal(walk.units.size(), 5);
        std::int64_t frame = 0;
        double second = 0;
        for (std::size_t u = 0; u < 5; ++u) {
            assert_string_equal(walk.units[u].kind.c_str(), kinds[u]);
            assert_true(walk.units[u].begin == frame && walk.units[u].begin_s == second);
            frame = walk.units[u].end;
            second = walk.units[u].end_s;
            assert_true(std::fabs(second - static_cast<double>(frame) / fps) < 1 / fps);
        }
        assert_int_equal(frame, walk.frames);
        assert_int_equal(walk.channels.size(), walk.frames * 57);
    }
}

void cycles_tile_the_cyclic_unit(void**) {
    Settings s;
    s.cycles = 5;
    s.ramp = 0.25;
    const Walk walk = make_walk(s);
    assert_int_equal(walk.cycles.size(), 5);
    double second = unit(walk, "cyclic").begin_s;
    double length = 1e9;
    for (const Interval& c : walk.cycles) {
        assert_true(c.begin_s == second);
        assert_true(c.end_s - c.begin_s < length); // the tempo rises
        length = c.end_s - c.begin_s;
        second = c.end_s;
    }
    assert_true(second == unit(walk, "cyclic").end_s);
}

void absent_standing_leaves_its_unit_out(void**) {
    Settings s;
    s.stand_before = s.stand_after = 0;
    const Walk walk = make_walk(s);
    assert_int_equal(walk.units.size(), 3);
    assert_int_equal(walk.units.front().begin, 0);
    assert_int_equal(walk.units.back().end, walk.frames);
    assert_true(walk.units.back().end_s == static_cast<double>(walk.frames) / s.fps);
}

void nothing_moves_while_standing(void**) {
    Settings s;
    const Walk walk = make_walk(s);
    const Interval& before = unit(walk, "preparing");
    const Interval& after = unit(walk, "wind-up");
    for (std::int64_t f = 0; f < before.end; ++f)
        assert_true(same_row(walk, f, walk, 0));
    for (std::int64_t f = after.begin; f < after.end; ++f)
        assert_true(same_row(walk, f, walk, after.begin));
    // The frame at the border is the first or last frame of standing.
    assert_true(same_row(walk, before.end, walk, 0));
    assert_false(same_row(walk, before.end + 1, walk, 0));
    assert_false(same_row(walk, after.begin - 1, walk, after.begin));
}

void attention_is_the_same_before_and_after(void**) {
    for (const double turn : {0.0, 30.0}) {
        Settings s;
        s.turn = turn;
        const Walk walk = make_walk(s);
        const double* first = row(walk, 0);
        const double* last = row(walk, walk.frames - 1);
        for (std::size_t c = 6; c < channel_count; ++c)
            assert_true(std::fabs(first[c] - last[c]) < 1e-9);
        assert_true(std::fabs(first[1] - last[1]) < 1e-9);
        assert_true(std::fabs(ahead(joints(walk, 0))) < 1e-9);
        assert_true(std::fabs(ahead(joints(walk, walk.frames - 1))) < 1e-9);
    }
}

void frame_rate_does_not_move_anything(void**) {
    Settings s;
    const Walk fine = make_walk(s);
    for (const double fps : {15.0, 30.0, 24.0}) {
        s.fps = fps;
        const Walk coarse = make_walk(s);
        const auto every = static_cast<std::int64_t>(120 / fps);
        for (std::size_t u = 1; u < 5; ++u)
            assert_true(coarse.units[u].begin_s == fine.units[u].begin_s);
        for (std::int64_t f = 0; f < coarse.frames; ++f)
            for (std::size_t c = 0; c < channel_count; ++c)
                assert_true(std::fabs(row(coarse, f)[c] - row(fine, f * every)[c]) < 1e-9);
    }
}

void same_seed_same_bytes(void**) {
    Settings s;
    s.noise = 3;
    s.cycles = 1;
    const std::string text = bvh_text(make_walk(s));
    assert_true(text == bvh_text(make_walk(s)));
    s.seed = 2;
    assert_false(text == bvh_text(make_walk(s)));
}

void noise_is_white_and_as_large_as_asked(void**) {
    Settings s;
    s.cycles = 20;
    const Walk clean = make_walk(s);
    s.noise = 3;
    const Walk noisy = make_walk(s);
    for (std::size_t c = 0; c < channel_count; ++c) {
        double sum = 0;
        double squares = 0;
        double lagged = 0;
        double before = 0;
        for (std::int64_t f = 0; f < clean.frames; ++f) {
            const double e = row(noisy, f)[c] - row(clean, f)[c];
            sum += e;
            squares += e * e;
            lagged += e * before;
            before = e;
        }
        const auto n = static_cast<double>(clean.frames);
        if (c < 3) {
            assert_true(squares == 0);
            continue;
        }
        // Five standard errors each.
        assert_true(std::fabs(sum / n) < 5 * 3 / std::sqrt(n));
        assert_true(std::fabs(std::sqrt(squares / n) - 3) < 5 * 3 / std::sqrt(2 * n));
        assert_true(std::fabs(lagged / squares) < 5 / std::sqrt(n));
    }
}

void rotation_order_does_not_move_the_body(void**) {
    Settings s;
    s.turn = 50;
    const Walk first = make_walk(s);
    for (const char* order : {"XYZ", "XZY", "YXZ", "YZX", "ZYX"}) {
        s.order = order;
        const Walk walk = make_walk(s);
        for (std::int64_t f = 0; f < walk.frames; f += 37)
            for (const std::size_t joint : {left_arm + 2UL, right_thigh + 3UL, std::size_t{head}})
                assert_true(distance(joints(walk, f).at[joint], joints(first, f).at[joint]) < 1e-6);
    }
}

void t_pose_replaces_the_first_frames(void**) {
    Settings s;
    const Walk plain = make_walk(s);
    s.t_pose_frames = 4;
    const Walk walk = make_walk(s);
    assert_int_equal(walk.frames, plain.frames);
    assert_true(std::all_of(row(walk, 0) + 3, row(walk, 1), [](double a) { return a == 0; }));
    assert_false(same_row(walk, 3, plain, 3));
    for (std::int64_t f = 4; f < walk.frames; ++f)
        assert_true(same_row(walk, f, plain, f));
}

void sway_moves_the_standing_body_only(void**) {
    Settings s;
    const Walk still = make_walk(s);
    s.sway = 0.5;
    const Walk walk = make_walk(s);
    assert_false(same_row(walk, 10, walk, 50));
    const double size = distance(joints(walk, 50).at[head], joints(still, 50).at[head]);
    assert_true(size > 0.1 && size < 5);
    assert_true(distance(ankle(joints(walk, 50), left), ankle(joints(still, 50), left)) < 1e-9);
    const std::int64_t walking = unit(walk, "cyclic").begin;
    assert_true(same_row(walk, walking, still, walking));
}

void texts_say_what_the_walk_is(void**) {
    Settings s;
    s.fps = 30;
    const Walk walk = make_walk(s);
    const std::string text = bvh_text(walk);
    const auto count = [&](const std::string& word) {
        int n = 0;
        for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
            ++n;
        return n;
    };
    assert_int_equal(count("JOINT") + count("ROOT"), 18);
    assert_int_equal(count("rotation"), 54);
    assert_int_equal(count("position"), 3);
    assert_true(text.find("Frame Time: 0.03333333333333333\n") != std::string::npos);
    const auto json = nlohmann::json::parse(borders_text(walk));
    assert_int_equal(json["clip"]["frames"].get<std::int64_t>(), walk.frames);
    assert_true(json["period_s"].get<double>() == walk.period);
    assert_int_equal(json["units"].size(), 5);
    assert_true(json["units"][2]["end_s"].get<double>() == unit(walk, "cyclic").end_s);
    assert_int_equal(json["cycles"].size(), 3);
}

void bad_settings_are_refused(void**) {
    const auto refused = [](auto change) {
        Settings s;
        change(s);
        try {
            make_walk(s);
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    };
    assert_true(refused([](Settings& s) { s.fps = 0; }));
    assert_true(refused([](Settings& s) { s.fps = NAN; }));
    assert_true(refused([](Settings& s) { s.cycles = 0; }));
    assert_true(refused([](Settings& s) { s.stand_after = -1; }));
    assert_true(refused([](Settings& s) { s.order = "XXZ"; }));
    assert_false(refused([](Settings&) {}));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(borders_cover_the_clip),
        cmocka_unit_test(cycles_tile_the_cyclic_unit),
        cmocka_unit_test(absent_standing_leaves_its_unit_out),
        cmocka_unit_test(nothing_moves_while_standing),
        cmocka_unit_test(attention_is_the_same_before_and_after),
        cmocka_unit_test(frame_rate_does_not_move_anything),
        cmocka_unit_test(same_seed_same_bytes),
        cmocka_unit_test(noise_is_white_and_as_large_as_asked),
        cmocka_unit_test(rotation_order_does_not_move_the_body),
        cmocka_unit_test(t_pose_replaces_the_first_frames),
        cmocka_unit_test(sway_moves_the_standing_body_only),
        cmocka_unit_test(texts_say_what_the_walk_is),
        cmocka_unit_test(bad_settings_are_refused),
    };
    return cmocka_run_group_tests_name("walker clip", tests, nullptr, nullptr);
}
