// SPDX-License-Identifier: BSD-3-Clause
#include "report/figure/side_view.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "base/text.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::report {

using clip::operator+, clip::operator-, clip::operator*, clip::Vec3;

namespace {

double quantile(std::vector<double>& values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

/// The lowest and the highest joint.
std::pair<double, double> heights(const std::vector<Vec3>& body) {
    const auto lower = [](const Vec3& a, const Vec3& b) { return a[2] < b[2]; };
    const auto [low, high] = std::ranges::minmax_element(body, lower);
    return {(*low)[2], (*high)[2]};
}

} // namespace

SideView::SideView(const clip::Clip& clip, clip::Axis up)
    : clip_(clip), heading_(clip, clip::body_root(clip), up),
      up_(static_cast<std::size_t>(up) - 1) {
    const std::size_t root = heading_.root();
    const double share = 1 / static_cast<double>(clip.frames());
    std::vector<Vec3> mean(clip.skeleton->joints.size() - root);
    std::vector<double> lowest;
    double xx = 0, xy = 0, yy = 0, tallest = 0;
    Vec3 travel{}, before{}; // of the root, as the body is turned
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        if (frame % 1024 == 0)
            checkpoint();
        const std::vector<Vec3> joints = body(frame);
        for (std::size_t j = 0; j < joints.size(); ++j) {
            mean[j] = mean[j] + share * joints[j];
            xx += share * joints[j][0] * joints[j][0];
            xy += share * joints[j][0] * joints[j][1];
            yy += share * joints[j][1] * joints[j][1];
        }
        const auto [low, high] = heights(joints);
        lowest.push_back(low);
        tallest = std::max(tallest, high - low);
        if (frame > 0)
            travel =
                travel + rotate(conjugate(heading_.next(pose_)), pose_.position[root] - before);
        before = pose_.position[root];
    }
    for (const Vec3& p : mean) {
        xx -= p[0] * p[0];
        xy -= p[0] * p[1];
        yy -= p[1] * p[1];
    }
    const double most = 0.5 * std::atan2(2 * xy, xx - yy);
    const double ahead =
        travel[(up_ + 1) % 3] * std::cos(most) + travel[(up_ + 2) % 3] * std::sin(most);
    forward_ = {std::copysign(1.0, ahead) * std::cos(most),
                std::copysign(1.0, ahead) * std::sin(most)};
    // One floor for all frames shows a jump, but not a body that climbs.
    if (quantile(lowest, 0.95) - quantile(lowest, 0.05) < 0.5 * tallest)
        floor_ = quantile(lowest, 0.5);
    const auto right_of = [&](const Vec3& p) { return p[0] * forward_.y - p[1] * forward_.x; };
    double reach = 0;
    for (const Vec3& p : mean)
        reach = std::max(reach, std::abs(right_of(p)));
    for (std::size_t j = 1; j < mean.size(); ++j)
        bones_.push_back({static_cast<std::size_t>(clip.skeleton->joints[root + j].parent) - root,
                          j, right_of(mean[j]) < -0.1 * reach});
    for (const Bone& bone : bones_) // the one that begins at the head, or else ends there
        if (is_head(bone.from) ? head_ == nullptr || !is_head(head_->from)
                               : is_head(bone.to) && head_ == nullptr)
            head_ = &bone;
    const auto [low, high] = heights(mean);
    head_radius_ = head_ == nullptr ? 0 : (high - low) / 16;
}

bool SideView::is_head(std::size_t joint) const {
    const std::string& name = clip_.skeleton->joints[heading_.root() + joint].name;
    return clip::to_lower(name).find("head") != name.npos;
}

/// Two horizontal coordinates of each joint, without the body's path and yaw, and its height.
std::vector<Vec3> SideView::body(std::int64_t frame) {
    pose_.place(*clip_.skeleton, clip_.values.row(frame));
    const clip::Quaternion back = conjugate(heading_.next(pose_));
    std::vector<Vec3> joints;
    for (std::size_t j = heading_.root(); j < pose_.position.size(); ++j) {
        const Vec3 p = rotate(back, pose_.position[j] - pose_.position[heading_.root()]);
        joints.push_back({p[(up_ + 1) % 3], p[(up_ + 2) % 3], pose_.position[j][up_]});
    }
    return joints;
}

/// One point per joint: x forward of the root, y up from the ground.
std::vector<Point> SideView::posture(std::int64_t frame) {
    const std::vector<Vec3> joints = body(frame);
    const double ground = floor_.value_or(heights(joints).first);
    std::vector<Point> points;
    for (const Vec3& p : joints)
        points.push_back({p[0] * forward_.x + p[1] * forward_.y, p[2] - ground});
    return points;
}

Rect SideView::box(std::int64_t frame) {
    const std::vector<Point> points = posture(frame);
    const auto [left, right] = std::ranges::minmax_element(points, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax_element(points, {}, &Point::y);
    const double bottom = std::min(0.0, low->y); // the head may be higher than the joints
    return {left->x, bottom, right->x - left->x, high->y + head_radius_ - bottom};
}

void SideView::draw(Svg& svg, std::int64_t frame, Point ground, double scale) {
    const Rect around = box(frame);
    std::vector<Point> points = posture(frame);
    for (Point& p : points)
        p = {ground.x + scale * (p.x - around.x - 0.5 * around.width), ground.y - scale * p.y};
    svg.open(format_text(R"(class="posture" data-frame="{}" stroke-linecap="round")", frame));
    for (const bool far : {true, false}) {
        std::string d;
        for (const Bone& bone : bones_)
            if (bone.far == far)
                d += "M" + pair(points[bone.from]) + "L" + pair(points[bone.to]);
        svg.path(d, stroke("bones", far ? "#a0a0a0" : ink, 0.85 * bold_line));
    }
    if (head_ != nullptr) {
        const Point neck = points[head_->from], crown = points[head_->to];
        const double length = distance(neck, crown), radius = scale * head_radius_;
        svg.circle(between(neck, crown, length > 0 ? std::max(0.5, radius / length) : 0), radius,
                   fill("head", ink));
    }
    svg.close();
}

} // namespace stltsa::report
