// SPDX-License-Identifier: BSD-3-Clause
#include "plot/side_view.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace tool::plot {
namespace {

/// The quantile of the values.
double quantile(std::vector<double> values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

std::string lower(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Yaw of a rotation about axis `up`: the twist of its swing-twist split.
Point yaw_of(const stltsa::Matrix& rotations, std::int64_t frame, int up) {
    const double angle = 2 * std::atan2(rotations(frame, 1 + up), rotations(frame, 0));
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

SideView::SideView(Bodies bodies) : bodies_(std::move(bodies)) {
    for (std::int64_t frame = 0; frame < frames(); ++frame)
        yaw_.push_back(yaw_of(bodies_.rotations, frame, bodies_.up));
    find_forward();
    find_ground();
    find_bones();
    find_head();
}

double SideView::coordinate(std::int64_t frame, std::size_t joint, int axis) const {
    return bodies_.positions(frame, 3 * static_cast<std::int64_t>(joint) + axis);
}

/// Root and yaw removed, turned so that `forward` is forward. The horizontal axes follow the up
/// axis cyclically, so that first x second = up, and right = forward x up.
SideView::Body SideView::body_point(std::int64_t frame, std::size_t joint) const {
    const int first = (bodies_.up + 1) % 3;
    const int second = (bodies_.up + 2) % 3;
    const double x = coordinate(frame, joint, first) - coordinate(frame, 0, first);
    const double y = coordinate(frame, joint, second) - coordinate(frame, 0, second);
    const Point yaw = yaw_[static_cast<std::size_t>(frame)];
    const double u = yaw.x * x + yaw.y * y;
    const double v = -yaw.y * x + yaw.x * y;
    return {u * forward_.x + v * forward_.y, u * forward_.y - v * forward_.x,
            coordinate(frame, joint, bodies_.up)};
}

std::vector<SideView::Body> SideView::mean_posture() const {
    std::vector<Body> mean(bodies_.joints.size(), Body{0, 0, 0});
    const double share = 1.0 / static_cast<double>(frames());
    for (std::int64_t frame = 0; frame < frames(); ++frame)
        for (std::size_t joint = 0; joint < mean.size(); ++joint) {
            const Body point = body_point(frame, joint);
            mean[joint].forward += share * point.forward;
            mean[joint].right += share * point.right;
            mean[joint].height += share * point.height;
        }
    return mean;
}

void SideView::find_forward() {
    const std::vector<Body> mean = mean_posture();
    const auto [low, high] = std::ranges::minmax_element(mean, {}, &Body::height);
    if (const auto travel = direction_of_travel(high->height - low->height))
        forward_ = *travel;
    else
        forward_ = direction_of_toes(mean);
}

/// Direction of the root's net motion in the body's heading; empty if the body mostly stays in
/// place.
std::optional<Point> SideView::direction_of_travel(double body_height) const {
    const int first = (bodies_.up + 1) % 3;
    const int second = (bodies_.up + 2) % 3;
    Point net;
    double path = 0;
    for (std::int64_t frame = 1; frame < frames(); ++frame) {
        const double x = coordinate(frame, 0, first) - coordinate(frame - 1, 0, first);
        const double y = coordinate(frame, 0, second) - coordinate(frame - 1, 0, second);
        const Point yaw = yaw_[static_cast<std::size_t>(frame)];
        net.x += yaw.x * x + yaw.y * y;
        net.y += -yaw.y * x + yaw.x * y;
        path += std::hypot(x, y);
    }
    const double length = std::hypot(net.x, net.y);
    if (length < 0.5 * path || length < 0.5 * body_height)
        return std::nullopt;
    return Point{net.x / length, net.y / length};
}

/// Perpendicular to the axis along which the mean posture is widest (shoulders, hips, arms),
/// towards the side to which the lowest bones (feet) point. In `mean`, forward = first and right =
/// -second.
Point SideView::direction_of_toes(const std::vector<Body>& mean) const {
    double xx = 0, xy = 0, yy = 0;
    for (const Body& point : mean) {
        xx += point.forward * point.forward;
        xy -= point.forward * point.right;
        yy += point.right * point.right;
    }
    const double widest = 0.5 * std::atan2(2 * xy, xx - yy);
    const Point across{-std::sin(widest), std::cos(widest)};

    const auto [low, high] = std::ranges::minmax_element(mean, {}, &Body::height);
    const double knee = low->height + 0.2 * (high->height - low->height);
    double feet = 0;
    for (std::size_t joint = 1; joint < mean.size(); ++joint) {
        const Body& from = mean[static_cast<std::size_t>(bodies_.joints[joint].parent)];
        if (mean[joint].height < knee && from.height < knee)
            feet += (mean[joint].forward - from.forward) * across.x -
                    (mean[joint].right - from.right) * across.y;
    }
    return feet < 0 ? Point{-across.x, -across.y} : across;
}

/// One floor for all frames, so that a jump is visible; if the body climbs, the lowest joint of
/// each frame.
void SideView::find_ground() {
    std::vector<double> lowest;
    double tallest = 0;
    for (std::int64_t frame = 0; frame < frames(); ++frame) {
        double low = coordinate(frame, 0, bodies_.up);
        double high = low;
        for (std::size_t joint = 1; joint < bodies_.joints.size(); ++joint) {
            low = std::min(low, coordinate(frame, joint, bodies_.up));
            high = std::max(high, coordinate(frame, joint, bodies_.up));
        }
        lowest.push_back(low);
        tallest = std::max(tallest, high - low);
    }
    const bool level = quantile(lowest, 0.95) - quantile(lowest, 0.05) < 0.5 * tallest;
    ground_ = level ? std::vector<double>(lowest.size(), quantile(lowest, 0.5)) : lowest;
}

void SideView::find_bones() {
    const std::vector<Body> mean = mean_posture();
    double reach = 0;
    for (const Body& point : mean)
        reach = std::max(reach, std::abs(point.right));
    for (std::size_t joint = 1; joint < mean.size(); ++joint) {
        const double right = mean[joint].right / std::max(reach, 1e-300);
        const Depth depth = right > 0.1 ? Depth::near : right < -0.1 ? Depth::far : Depth::middle;
        bones_.push_back({static_cast<std::size_t>(bodies_.joints[joint].parent), joint, depth});
    }
}

/// The bone from the head joint to its child; if it has none, the bone to the head joint.
void SideView::find_head() {
    const auto is_head = [&](std::size_t joint) {
        return lower(bodies_.joints[joint].name).find("head") != std::string::npos;
    };
    const auto found = std::ranges::find_if(
        bones_, [&](const Bone& bone) { return is_head(bone.from) || is_head(bone.to); });
    if (found == bones_.end())
        return;
    const std::size_t joint = is_head(found->from) ? found->from : found->to;
    const auto beyond = std::ranges::find(bones_, joint, &Bone::from);
    const Bone& bone = beyond == bones_.end() ? *found : *beyond;
    const std::vector<Body> mean = mean_posture();
    const auto [low, high] = std::ranges::minmax_element(mean, {}, &Body::height);
    head_ = Head{bone.from, bone.to, (high->height - low->height) / 16};
}

std::vector<Point> SideView::posture(std::int64_t frame) const {
    std::vector<Point> points;
    for (std::size_t joint = 0; joint < bodies_.joints.size(); ++joint) {
        const Body point = body_point(frame, joint);
        points.push_back({point.forward, point.height - ground_[static_cast<std::size_t>(frame)]});
    }
    return points;
}

} // namespace tool::plot
