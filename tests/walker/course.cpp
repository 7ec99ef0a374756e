// SPDX-License-Identifier: BSD-3-Clause
#include "course.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gait.hpp"

namespace walker {
namespace {

constexpr double double_support = toe_off - 0.5; // cycles
// The root pivots on the heel up to this phase, then on the ball; at this phase the foot is flat.
constexpr double heel_until = 0.2;
// Duration of the half steps from and to standing, relative to steady walking: the largest value at
// which the phase starts from rest and never runs backward.
constexpr double stretch = 2.5;
// Share of such a half step in which the amplitude rises or falls, so that the leg is lifted before
// it moves forward.
constexpr double lift_share = 0.6;

/// A minimum-jerk curve from 0 to 1 (Flash and Hogan, J. Neurosci. 5, 1985).
double minimum_jerk(double u) {
    const double v = std::clamp(u, 0.0, 1.0);
    return v * v * v * (10 + v * (-15 + 6 * v));
}

/// Goes from 0 at rest to 1 at the slope `stretch`, without acceleration at both ends.
double speed_up(double u) {
    return u * u * u * ((10 - 4 * stretch) + u * ((7 * stretch - 15) + u * (6 - 3 * stretch)));
}

double fraction(double x) {
    return x - std::floor(x);
}

Vector on_floor(Vector v) {
    return {v.x, 0, v.z};
}

} // namespace

Course::Course(const Settings& s)
    : settings_(s), body_(make_body(s.height)), sole_(make_sole(s.height)),
      passing_(find_passing()), last_lift_(s.cycles + toe_off), tempo_(1 / s.period),
      last_tempo_((1 + s.ramp) * tempo_) {
    tempo_gain_ = (last_tempo_ * last_tempo_ - tempo_ * tempo_) / (2 * last_lift_);
    borders_.onset = s.stand_before;
    landing_s_ = borders_.onset + stretch * (0.5 - passing_) / tempo_;
    for (int c = 0; c <= s.cycles; ++c)
        borders_.passes.push_back(landing_s_ + seconds_to(c + passing_));
    last_lift_s_ = landing_s_ + seconds_to(last_lift_);
    borders_.standstill = last_lift_s_ + stretch * (passing_ + 0.5 - toe_off) / last_tempo_;
    borders_.end = borders_.standstill + s.stand_after;
    set_footprints();
}

/// Phase of the standing leg when both ankles are level along the heading.
double Course::find_passing() const {
    const auto left_is_ahead = [&](double phase) {
        const Pose p = make_pose(body_, sole_, {{phase, phase + 0.5}, settings_.stride, 0, {}, 0});
        return p.legs[left].ankle.z > p.legs[right].ankle.z;
    };
    double low = 0.2;
    double high = 0.4;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (left_is_ahead(middle) ? low : high) = middle;
    }
    return low;
}

/// Time from the first landing; the inverse of progress = tempo t + gain t^2 / 2.
double Course::seconds_to(double progress) const {
    return 2 * progress / (tempo_ + std::sqrt(tempo_ * tempo_ + 2 * tempo_gain_ * progress));
}

Course::State Course::gait_state(double t) const {
    const double onset = borders_.onset;
    if (t < landing_s_) {
        const double u = std::clamp((t - onset) / (landing_s_ - onset), 0.0, 1.0);
        return {(0.5 - passing_) * (speed_up(u) - 1), minimum_jerk(u / lift_share), 0};
    }
    if (t < last_lift_s_) {
        const double since = t - landing_s_;
        return {since * (tempo_ + since * tempo_gain_ / 2), 1, 0};
    }
    const double stop = borders_.standstill;
    const double left_over = std::clamp((stop - t) / (stop - last_lift_s_), 0.0, 1.0);
    const double gap = passing_ + 0.5 - toe_off;
    return {last_lift_ + gap * (1 - speed_up(left_over)), minimum_jerk(left_over / lift_share), 0};
}

Course::State Course::state(double t) const {
    State s = gait_state(t);
    s.lean = (1 - s.amplitude) * sway(t);
    return s;
}

/// Two slow waves of unequal length, for the sway of quiet standing.
double Course::sway(double t) const {
    const auto wave = [&](double hertz) { return std::sin(2 * std::numbers::pi * hertz * t); };
    return settings_.sway * std::numbers::sqrt2 * (0.8 * wave(0.27) + 0.6 * wave(0.61));
}

Side Course::side_of(int step) const {
    return (step % 2 == 0) == settings_.right_first ? right : left;
}

double Course::heading(double progress) const {
    return settings_.turn * (progress + 0.5 - passing_);
}

/// The heading of the body when it stands on this foot alone.
double Course::print_heading(int step) const {
    const double standstill = last_lift_ + passing_ + 0.5 - toe_off;
    return step < 0 ? 0 : heading(std::min(step / 2.0 + passing_, standstill));
}

/// Heading of the footprint; in the air the foot turns towards the next one. The first and the last
/// swing are half swings.
double Course::foot_heading(double progress, Side side) const {
    const bool first = side == side_of(0);
    const double cycle = std::floor(progress + (first ? 0 : 0.5));
    const double phase = progress + (first ? 0 : 0.5) - cycle;
    const int step = static_cast<int>(2 * cycle) - (first ? 0 : 1);
    const double lift = progress < 0 ? passing_ + 0.5 : toe_off;
    const double landing = progress < last_lift_ - double_support ? 1 : passing_ + 0.5;
    const double from = print_heading(step);
    return from +
           (print_heading(step + 2) - from) * minimum_jerk((phase - lift) / (landing - lift));
}

Moment Course::moment(const State& s) const {
    Moment m;
    m.phase[side_of(0)] = fraction(s.progress);
    m.phase[side_of(1)] = fraction(s.progress + 0.5);
    m.amplitude = settings_.stride * s.amplitude;
    m.heading = heading(s.progress);
    for (const Side side : {left, right})
        m.foot_heading[side] = foot_heading(s.progress, side);
    m.lean = s.lean;
    return m;
}

/// Places each footprint under the new foot in the middle of double support.
void Course::set_footprints() {
    const Vector ball_up{0, sole_.ball_height, 0};
    const LegPose start = pose(0.0).legs[side_of(-1)];
    prints_.push_back({on_floor(start.heel), on_floor(start.ball) + ball_up});
    for (int step = 0; step < 2 * settings_.cycles + 2; ++step) {
        const Pose p = pose(State{step / 2.0 + double_support / 2, 1, 0});
        const Side side = side_of(step);
        const Vector root = prints_.back().ball - p.legs[other(side)].ball;
        const Vector heel = on_floor(root + p.legs[side].heel);
        const Rotation facing = about_y(print_heading(step) + sign(side) * toe_out);
        prints_.push_back({heel, on_floor(heel + facing * (sole_.ball - sole_.heel)) + ball_up});
    }
}

Pose Course::pose(const State& s) const {
    return make_pose(body_, sole_, moment(s));
}

Pose Course::pose(double t) const {
    return pose(state(t));
}

/// Derives the root from the feet on the floor; during double support the weight moves from the old
/// foot to the new one.
Vector Course::root(double t) const {
    const State s = state(t);
    const Pose p = pose(s);
    const int step = std::max(-1, static_cast<int>(std::floor(2 * s.progress)));
    const double phase = s.progress - step / 2.0;
    const LegPose& leg = p.legs[side_of(step)];
    const Footprint& print = prints_[static_cast<std::size_t>(step + 1)];
    const bool on_heel = step >= 0 && phase < heel_until;
    const Vector by_new = on_heel ? print.heel - leg.heel : print.ball - leg.ball;
    if (step < 0 || phase >= double_support)
        return by_new;
    const LegPose& old_leg = p.legs[other(side_of(step))];
    const Vector by_old = prints_[static_cast<std::size_t>(step)].ball - old_leg.ball;
    const double weight = minimum_jerk(phase / double_support);
    return weight * by_new + (1 - weight) * by_old;
}

} // namespace walker
