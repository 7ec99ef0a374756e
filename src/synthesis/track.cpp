// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/track.hpp"

#include <algorithm>
#include <cmath>

#include "clip/features/tpose.hpp"
#include "linalg/simd.hpp"

namespace stltsa::synthesis {
namespace {

/// Half the time span of the velocities, which makes them independent of the frame rate.
constexpr double velocity_reach_s = 0.025;

void place_frames(const Body& body, Track& track) {
    const std::size_t count = body.skeleton().joints.size();
    track.postures =
        Matrix(track.frames() + 1, static_cast<std::int64_t>(3 * (count - body.root())));
    track.roots.reserve(static_cast<std::size_t>(track.frames()));
    clip::Heading heading = body.heading();
    clip::Pose pose;
    for (std::int64_t frame = 0; frame < track.frames(); ++frame) {
        pose.place(body.skeleton(), track.values.row(frame));
        track.roots.push_back(body.read(pose, heading.next(pose)));
        const RootState& root = track.roots.back();
        double* out = track.postures.row(frame);
        for (std::size_t j = body.root(); j < count; ++j) {
            const Vec3 p = rotate(conjugate(root.yaw), pose.position[j] - root.position);
            out = std::copy(p.begin(), p.end(), out);
        }
    }
}

void check_finite(const Track& track) {
    for (std::int64_t i = 0; i < track.frames(); ++i)
        if (!std::all_of(track.postures.row(i), track.postures.row(i) + track.postures.cols(),
                         [](double value) { return std::isfinite(value); }))
            fail(Status::not_finite,
                 "the values in frame {} of {} are too large: the positions of its joints are not "
                 "finite",
                 i, track.name);
}

/// The posture after the last one, extrapolated.
void extrapolate(Matrix& postures) {
    const std::int64_t end = postures.rows() - 1;
    const double* last = postures.row(end - 1);
    const double* before = postures.row(std::max<std::int64_t>(0, end - 2));
    for (std::int64_t c = 0; c < postures.cols(); ++c)
        postures(end, c) = 2 * last[c] - before[c];
}

/// Central differences, over a shorter span near the ends; at the ends the slope of a parabola.
Matrix velocities(ConstMatrixView postures, double fps) {
    const std::int64_t last = postures.rows - 1;
    const std::int64_t most = std::max<std::int64_t>(1, std::llround(velocity_reach_s * fps));
    Matrix result(postures.rows + 1, postures.cols);
    const auto slope = [&](std::int64_t i, std::int64_t a, std::int64_t b) {
        axpy(fps / static_cast<double>(b - a), postures.row(b), result.row(i), postures.cols);
        axpy(-fps / static_cast<double>(b - a), postures.row(a), result.row(i), postures.cols);
    };
    for (std::int64_t i = 1; i < last; ++i) {
        const std::int64_t reach = std::min({most, i, last - i});
        slope(i, i - reach, i + reach);
    }
    const std::int64_t reach = std::min(most, last / 2);
    for (const auto& [end, inward] : {std::pair(std::int64_t{0}, reach), std::pair(last, -reach)}) {
        if (reach == 0)
            continue;
        slope(end, end, end + inward);
        slope(end, end, end + inward);
        for (std::int64_t c = 0; c < postures.cols; ++c)
            result(end, c) -= fps * (postures(end + 2 * inward, c) - postures(end, c)) /
                              static_cast<double>(2 * inward);
    }
    std::copy_n(result.row(last), postures.cols, result.row(last + 1));
    return result;
}

} // namespace

Track make_track(const Body& body, const Matrix& values, double fps, std::string name) {
    Track track;
    track.name = std::move(name);
    track.values = values;
    track.fps = fps;
    place_frames(body, track);
    check_finite(track);
    extrapolate(track.postures);
    const ConstMatrixView postures = track.postures.view().block(0, track.frames());
    track.first = clip::tpose_frames(postures);
    track.velocities = velocities(postures, fps);
    return track;
}

Step step_to(const Body& body, const Track& track, std::int64_t frame) {
    if (track.frames() < 2)
        return {};
    const std::int64_t to = std::clamp<std::int64_t>(frame, 1, track.frames() - 1);
    return body.step(track.root(to - 1), track.root(to));
}

double squared_distance(const Track& a, std::int64_t i, const Track& b, std::int64_t j,
                        double velocity_s) {
    const std::int64_t columns = a.postures.cols();
    return stltsa::squared_distance(a.postures.row(i), b.postures.row(j), columns) +
           velocity_s * velocity_s *
               stltsa::squared_distance(a.velocities.row(i), b.velocities.row(j), columns);
}

double posture_size(const Track& track, std::int64_t frame) {
    const double* p = track.postures.row(frame);
    return std::sqrt(dot(p, p, track.postures.cols()));
}

} // namespace stltsa::synthesis
