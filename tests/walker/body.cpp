// SPDX-License-Identifier: BSD-3-Clause
#include "body.hpp"

#include "gait.hpp"

namespace walker {
namespace {

constexpr double leg_adduction = 2; // both legs, always: the feet are closer together than the hips
constexpr double arm_abduction = 6; // hanging arms
constexpr double head_share = 0.3;  // share of the chest's turn that neck and head each undo

LegPose make_leg(const Body& body, const Sole& sole, const Moment& m, Side side,
                 const Rotation& upright, const Rotation& pelvis) {
    const LegAngles a = leg_angles(m.phase[side]);
    const double s = m.amplitude;
    const std::size_t hip = thigh(side);
    LegPose leg;
    leg.thigh =
        upright * about_z(-sign(side) * (leg_adduction + s * a.adduction)) * about_x(-s * a.thigh);
    leg.shank = leg.thigh * about_x(s * a.knee);
    // Bending lifts the foot with the square of the amplitude, so the foot's pitch must grow with
    // the square too. Otherwise the toes would scrape the floor in small steps.
    leg.foot = about_y(m.foot_heading[side] + sign(side) * toe_out) * about_x(-s * s * a.foot);
    leg.toes = leg.foot * about_x(-s * s * a.toes);
    leg.ankle = pelvis * body[hip].offset + leg.thigh * body[hip + 1].offset +
                leg.shank * body[hip + 2].offset;
    leg.heel = leg.ankle + leg.foot * sole.heel;
    leg.ball = leg.ankle + leg.foot * sole.ball;
    return leg;
}

void set_leg(Pose& pose, Side side, const Rotation& pelvis) {
    const LegPose& leg = pose.legs[side];
    Rotation* local = &pose.local[thigh(side)];
    local[0] = inverse(pelvis) * leg.thigh;
    local[1] = inverse(leg.thigh) * leg.shank;
    local[2] = inverse(leg.shank) * leg.foot;
    local[3] = inverse(leg.foot) * leg.toes;
}

void set_arm(Pose& pose, Side side, const Moment& m, const Rotation& upright,
             const Rotation& chest) {
    const ArmAngles a = arm_angles(m.phase[side]);
    const Rotation hanging = about_z(-sign(side) * (90 - arm_abduction)); // from the T-pose
    Rotation* local = &pose.local[arm(side)];
    local[0] = inverse(chest) * upright * about_x(-m.amplitude * a.shoulder) * hanging;
    local[1] = about_y(-sign(side) * m.amplitude * a.elbow);
    local[2] = identity();
}

// The names follow the BVH files of well-known motion capture collections.
void add_side(Body& b, Side side, double h) {
    const double s = sign(side);
    const bool l = side == left;
    const std::size_t a = arm(side);
    const std::size_t t = thigh(side);
    const auto below = [](std::size_t joint) { return static_cast<int>(joint); };
    b[a] = {l ? "LeftArm" : "RightArm", spine, {s * 0.110 * h, 0.228 * h, 0}};
    b[a + 1] = {l ? "LeftForeArm" : "RightForeArm", below(a), {s * 0.186 * h, 0, 0}};
    b[a + 2] = {l ? "LeftHand" : "RightHand",
                below(a + 1),
                {s * 0.146 * h, 0, 0},
                Vector{s * 0.108 * h, 0, 0}};
    b[t] = {l ? "LeftUpLeg" : "RightUpLeg", hips, {s * 0.050 * h, 0, 0}};
    b[t + 1] = {l ? "LeftLeg" : "RightLeg", below(t), {0, -0.245 * h, 0}};
    b[t + 2] = {l ? "LeftFoot" : "RightFoot", below(t + 1), {0, -0.246 * h, 0}};
    b[t + 3] = {l ? "LeftToeBase" : "RightToeBase", below(t + 2), make_sole(h).ball,
                Vector{0, 0, 0.045 * h}};
}

} // namespace

// Lengths as fractions of the height; see README.md.
Body make_body(double h) {
    Body b{};
    b[hips] = {"Hips", -1};
    b[spine] = {"Spine", hips, {0, 0.060 * h, 0}};
    b[neck] = {"Neck", spine, {0, 0.250 * h, 0}};
    b[head] = {"Head", neck, {0, 0.052 * h, 0}, Vector{0, 0.108 * h, 0}};
    add_side(b, left, h);
    add_side(b, right, h);
    return b;
}

Sole make_sole(double h) {
    return {{0, -0.039 * h, -0.038 * h}, {0, -0.027 * h, 0.069 * h}, 0.012 * h};
}

Pose make_pose(const Body& body, const Sole& sole, const Moment& m) {
    const double s = m.amplitude;
    const TrunkAngles t = trunk_angles(m.phase[left]);
    const Rotation upright = about_y(m.heading) * about_x(m.lean);
    const Rotation pelvis = upright * about_y(-s * t.pelvis_rotation) * about_z(s * t.pelvis_list) *
                            about_x(s * t.pelvis_tilt);
    const Rotation chest = upright * about_y(-s * t.chest_rotation) * about_z(s * t.chest_list) *
                           about_x(s * t.chest_tilt);
    Pose pose;
    pose.local[hips] = pelvis;
    pose.local[spine] = inverse(pelvis) * chest;
    pose.local[neck] =
        about_y(head_share * s * t.chest_rotation) * about_x(-head_share * s * t.chest_tilt);
    pose.local[head] = pose.local[neck];
    for (const Side side : {left, right}) {
        pose.legs[side] = make_leg(body, sole, m, side, upright, pelvis);
        set_leg(pose, side, pelvis);
        set_arm(pose, side, m, upright, chest);
    }
    return pose;
}

} // namespace walker
