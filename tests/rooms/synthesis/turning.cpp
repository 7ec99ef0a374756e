// SPDX-License-Identifier: BSD-3-Clause
// Loops of straight walks and of turning walks.
#include "clip/testing.hpp"
#include "synthesis/synthesis.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using namespace stltsa::synthesis;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::int64_t repeats = 12;

/// A walk with cycles of 60 frames whose heading, in degrees, is 5 sin of the cycle plus this.
template <class Heading>
Clip heading_for(const Heading& heading) {
    Walk walk;
    walk.seconds = 8;
    Clip clip = walking(walk);
    double x = 0;
    double z = 0;
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        const double t = static_cast<double>(i) / walk.fps;
        const double direction = heading(t);
        clip.values(i, 0) = x;
        clip.values(i, 2) = z;
        clip.values(i, 3) = direction + 5 * std::sin(2 * std::numbers::pi * t);
        x += std::sin(direction * degree) * walk.speed / walk.fps;
        z += std::cos(direction * degree) * walk.speed / walk.fps;
    }
    return clip;
}

/// Degrees by which each repetition of frames [180, 240) turns, except the first and the last,
/// which do not change; and the turn of the source between the cuts.
std::pair<double, double> turns(const Clip& clip) {
    const Piece pieces[] = {{&clip, 180, 240, repeats}};
    Options options;
    options.up = Axis::y;
    const Synthesis made = synthesize(pieces, options);
    assert_int_equal(made.seams.size(), repeats - 1);
    const Body body = body_of(clip);
    const auto turned = [&](const Track& track, std::int64_t begin, std::int64_t end) {
        double sum = 0;
        for (std::int64_t i = begin + 1; i <= end; ++i)
            sum += step_to(body, track, i).turn / degree;
        return sum;
    };
    const Seam& first = made.seams[1];
    const double loop = turned(track_of(made.clip), first.frame, made.seams.back().frame);
    return {loop / static_cast<double>(made.seams.size() - 2),
            turned(track_of(clip), first.cut_begin, first.cut_end)};
}

/// Swaying left and right: the repeated cycle happens to end at another heading.
void a_straight_walk_stays_straight(void**) {
    const auto [loop, source] = turns(heading_for([](double t) { return 2.5 * std::sin(2 * t); }));
    assert_true(std::abs(source) > 1); // otherwise the test is void
    ASSERT_NEAR(loop, 0, 1e-6);
}

void a_real_turn_continues(void**) {
    for (const double each : {2.0, 8.0, 40.0, -40.0}) {
        const auto [loop, source] = turns(heading_for([each](double t) { return each * t; }));
        ASSERT_NEAR(source, each, 1e-6);
        ASSERT_NEAR(loop, each, 1e-6);
    }
}

/// Straight before, and to the other side later: only more than the usual sway is a turn.
void a_turn_of_one_cycle_is_repeated(void**) {
    const auto [loop, source] = turns(heading_for([](double t) {
        return t < 3 ? 0.5 * std::sin(7 * t) : t < 4 ? 40 * (t - 3) : 80 - 10 * t;
    }));
    assert_true(source > 25);
    ASSERT_NEAR(loop, source, 3);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_straight_walk_stays_straight),
        cmocka_unit_test(a_real_turn_continues),
        cmocka_unit_test(a_turn_of_one_cycle_is_repeated),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
