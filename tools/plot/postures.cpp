// SPDX-License-Identifier: BSD-3-Clause
#include "plot/postures.hpp"

#include <algorithm>

#include "plot/stick_figure.hpp"

namespace tool::plot {
namespace {

constexpr std::int64_t most_postures = 13;
constexpr std::int64_t fewest_postures = 5;
constexpr std::int64_t frames_tried = 200;

struct Size {
    double width = 0;
    double height = 0;
};

/// The largest width and height of a posture, over a sample of the frames.
Size largest_posture(const SideView& view) {
    Size size;
    const std::int64_t stride = std::max<std::int64_t>(1, view.frames() / frames_tried);
    for (std::int64_t frame = 0; frame < view.frames(); frame += stride) {
        const Rect box = posture_box(view, frame);
        size.width = std::max(size.width, box.width);
        size.height = std::max(size.height, box.height);
    }
    return size;
}

/// Moves every second posture, from `first`, so that they are `room` apart and inside the frame.
void spread(std::vector<Posture>& postures, std::size_t first, const Rect& frame, double room) {
    double least = frame.x + 0.5 * room;
    for (std::size_t i = first; i < postures.size(); i += 2) {
        postures[i].x = std::max(postures[i].x, least);
        least = postures[i].x + room;
    }
    double most = frame.right() - 0.5 * room;
    for (std::size_t i = postures.size(); i-- > first;)
        if ((i - first) % 2 == 0) {
            postures[i].x = std::min(postures[i].x, most);
            most = postures[i].x - room;
        }
}

} // namespace

PosturePlan plan_postures(const Figure& figure, const Rect& frame, double height) {
    const Size largest = largest_posture(*figure.bodies);
    if (largest.height <= 0)
        return {};
    PosturePlan plan;
    plan.scale = height / largest.height;
    constexpr double air = 4, number = 32;
    double room = std::max(number, largest.width * plan.scale + air);
    const auto fitting = 2 * static_cast<std::int64_t>(frame.width / room);
    const auto count =
        std::min(std::clamp(fitting, fewest_postures, most_postures), std::ssize(figure.postures));
    const double widest =
        2 * frame.width / static_cast<double>(std::max<std::int64_t>(count, 2) + 1);
    plan.scale *= std::min(1.0, widest / room);
    room = std::min(room, widest);

    std::vector<std::int64_t> frames(figure.postures.begin(), figure.postures.begin() + count);
    std::ranges::sort(frames);
    for (const std::int64_t chosen : frames)
        plan.postures.push_back({chosen,
                                 frame.x + frame.width * static_cast<double>(chosen) /
                                               static_cast<double>(figure.frames),
                                 plan.postures.size() % 2 == 0});
    spread(plan.postures, 0, frame, room);
    spread(plan.postures, 1, frame, room);
    return plan;
}

} // namespace tool::plot
