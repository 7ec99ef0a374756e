// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stltsa::synthesis {
namespace {

/// The steps from each frame of a loop to the next, and from the last to the one after it.
std::vector<Step> steps_of(const Body& body, const Track& made, const Step& closing) {
    std::vector<Step> steps;
    for (std::int64_t frame = 1; frame < made.frames(); ++frame)
        steps.push_back(body.step(made.root(frame - 1), made.root(frame)));
    steps.push_back(body.step(made.root(made.frames() - 1), body.after(made.root(0), closing)));
    return steps;
}

double turn_of(const std::vector<Step>& steps) {
    double turn = 0;
    for (const Step& step : steps)
        turn += step.turn;
    return turn;
}

} // namespace

Loop travel_of(const Body& body, const Track& made, const Step& closing) {
    Loop loop;
    loop.travel = body.after(made.root(0), closing).position - made.root(0).position;
    loop.turn = turn_of(steps_of(body, made, closing));
    return loop;
}

void put_in_place(const Body& body, const Track& made, const Step& closing, Matrix& values) {
    std::vector<Step> steps = steps_of(body, made, closing);
    const auto count = static_cast<double>(steps.size());
    const double turn = turn_of(steps) / count;
    std::vector<RootState> path{made.root(0)}; // straight: one more state than frames
    for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i].turn -= turn;
        path.push_back(body.after(path.back(), steps[i]));
    }
    const Vec3 travel = path.back().position - path.front().position;
    for (std::int64_t frame = 0; frame < made.frames(); ++frame) {
        RootState state = made.root(frame);
        const RootState& straight = path[static_cast<std::size_t>(frame)];
        const auto up = static_cast<std::size_t>(body.up());
        const double height = state.position[up];
        state.position = straight.position - (static_cast<double>(frame) / count) * travel;
        state.position[up] = height;
        state.yaw = straight.yaw;
        double* row = values.row(frame);
        if (frame > 0) // of equivalent angles, those nearest to the frame before
            std::copy_n(values.row(frame - 1), body.root_channels(), row);
        body.write(state, row);
    }
}

} // namespace stltsa::synthesis
