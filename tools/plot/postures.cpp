// SPDX-License-Identifier: BSD-3-Clause
#include "plot/postures.hpp"

#include <algorithm>
#include <cmath>

#include "plot/stick_figure.hpp"

namespace tool::plot {
namespace {

constexpr std::int64_t most_slots = 13;
constexpr std::int64_t fewest_slots = 5;
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

void add_extrema(const Figure& figure, std::vector<std::int64_t>& events) {
    const std::vector<double>& y = figure.curve;
    for (std::size_t i = 1; i + 1 < y.size(); ++i)
        if ((y[i] - y[i - 1]) * (y[i + 1] - y[i]) < 0)
            events.push_back(figure.frame_of(static_cast<std::int64_t>(i)));
}

std::vector<std::int64_t> events_of(const Figure& figure) {
    std::vector<std::int64_t> events;
    for (const stltsa::Interval& unit : figure.units)
        events.push_back(unit.begin);
    for (const stltsa::Interval& cycle : figure.cycles) {
        events.push_back(cycle.begin);
        events.push_back(cycle.end);
    }
    add_extrema(figure, events);
    return events;
}

std::int64_t frame_for_slot(const std::vector<std::int64_t>& events, double middle, double reach) {
    const auto distance = [&](std::int64_t frame) {
        return std::abs(static_cast<double>(frame) - middle);
    };
    const auto nearest = std::ranges::min_element(events, {}, distance);
    if (nearest != events.end() && distance(*nearest) <= reach)
        return *nearest;
    return static_cast<std::int64_t>(middle);
}

} // namespace

PosturePlan plan_postures(const Figure& figure, double width, double height) {
    const Size largest = largest_posture(*figure.bodies);
    if (largest.height <= 0)
        return {};
    PosturePlan plan;
    plan.scale = height / largest.height;
    constexpr double air = 4;
    const double room = largest.width * plan.scale + air;
    const auto fitting = static_cast<std::int64_t>(2 * width / room);
    const std::int64_t slots =
        std::min(figure.frames, std::clamp(fitting, fewest_slots, most_slots));
    plan.scale *= std::min(1.0, 2 * width / static_cast<double>(slots) / room);

    const std::vector<std::int64_t> events = events_of(figure);
    const double slot = static_cast<double>(figure.frames) / static_cast<double>(slots);
    for (std::int64_t i = 0; i < slots; ++i)
        plan.frames.push_back(
            frame_for_slot(events, (static_cast<double>(i) + 0.5) * slot, 0.35 * slot));
    return plan;
}

} // namespace tool::plot
