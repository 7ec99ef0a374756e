// SPDX-License-Identifier: BSD-3-Clause
#include "walker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "course.hpp"

namespace walker {
namespace {

void require(bool good, const char* what) {
    if (!good)
        throw std::invalid_argument(what);
}

void check(const Settings& s) {
    require(s.fps > 0 && s.fps <= 10000, "fps must lie in (0, 10000]");
    require(s.cycles >= 1 && s.cycles <= 100000, "cycles must lie in [1, 100000]");
    require(s.period > 0.1 && s.period <= 100, "period must lie in (0.1, 100] seconds");
    require(s.stand_before >= 0 && s.stand_before <= 1e5, "standing must lie in [0, 1e5] seconds");
    require(s.stand_after >= 0 && s.stand_after <= 1e5, "standing must lie in [0, 1e5] seconds");
    require(std::isfinite(s.turn), "turn must be finite");
    require(s.stride >= 0.5 && s.stride <= 1.2, "stride must lie in [0.5, 1.2]");
    require(s.ramp > -0.9 && s.ramp <= 9, "ramp must lie in (-0.9, 9]");
    require(s.sway >= 0 && s.sway <= 5, "sway must lie in [0, 5] degrees");
    require(s.height > 0, "height must be positive");
    require(s.noise >= 0, "noise must not be negative");
    require(s.t_pose_frames >= 0, "t_pose_frames must not be negative");
    std::string sorted = s.order;
    std::sort(sorted.begin(), sorted.end());
    require(sorted == "XYZ", "order must be a permutation of XYZ");
}

/// Standard normal numbers that are the same on every platform: the standard leaves the algorithm
/// of std::normal_distribution open (Box and Muller, Ann. Math. Statist. 29, 1958).
class Normal {
  public:
    explicit Normal(std::uint64_t seed) : bits_(seed) {}
    double operator()() {
        const double radius = std::sqrt(-2 * std::log(1 - uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

  private:
    double uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    std::mt19937_64 bits_;
};

std::vector<double> frame_channels(const Course& course, double t, const std::string& order) {
    const Vector root = course.root(t);
    const Pose pose = course.pose(t);
    std::vector<double> row{root.x, root.y, root.z};
    for (const Rotation& r : pose.local)
        for (const double angle : euler(r, order))
            row.push_back(angle);
    return row;
}

/// The first frame at or after the moment, tolerating rounding errors.
std::int64_t frame_at(double seconds, double fps) {
    return static_cast<std::int64_t>(std::ceil(seconds * fps - 1e-6));
}

Interval make_interval(const char* kind, double begin, double end, double fps) {
    return {kind, frame_at(begin, fps), frame_at(end, fps), begin, end};
}

void set_borders(Walk& walk, const Borders& b) {
    const double fps = walk.settings.fps;
    const double end = static_cast<double>(walk.frames) / fps;
    const auto add = [&](const char* kind, double from, double to) {
        const Interval unit = make_interval(kind, from, to, fps);
        if (unit.end > unit.begin)
            walk.units.push_back(unit);
    };
    add("preparing", 0, b.onset);
    add("initial", b.onset, b.passes.front());
    add("cyclic", b.passes.front(), b.passes.back());
    add("final", b.passes.back(), b.standstill);
    add("wind-up", b.standstill, end);
    walk.units.back().end_s = end;
    for (std::size_t c = 0; c + 1 < b.passes.size(); ++c)
        walk.cycles.push_back(make_interval("cycle", b.passes[c], b.passes[c + 1], fps));
}

/// The start that many motion capture converters leave: all rotations zero, then a few frames that
/// lead to the first real pose.
void add_t_pose(Walk& walk) {
    const std::int64_t n = std::min<std::int64_t>(walk.settings.t_pose_frames, walk.frames);
    for (std::int64_t f = 0; f < n; ++f)
        for (std::size_t c = 3; c < channel_count; ++c)
            walk.channels[static_cast<std::size_t>(f) * channel_count + c] *=
                static_cast<double>(f) / static_cast<double>(n);
}

void add_noise(Walk& walk) {
    Normal normal(walk.settings.seed);
    for (std::size_t i = 0; i < walk.channels.size(); ++i)
        if (i % channel_count >= 3)
            walk.channels[i] += walk.settings.noise * normal();
}

} // namespace

Walk make_walk(const Settings& settings) {
    check(settings);
    const Course course(settings);
    const Borders& borders = course.borders();
    Walk walk;
    walk.settings = settings;
    walk.frames = frame_at(borders.end, settings.fps);
    walk.period = (borders.passes.back() - borders.passes.front()) / settings.cycles;
    for (std::int64_t f = 0; f < walk.frames; ++f) {
        const double t = static_cast<double>(f) / settings.fps;
        const std::vector<double> row = frame_channels(course, t, settings.order);
        walk.channels.insert(walk.channels.end(), row.begin(), row.end());
    }
    set_borders(walk, borders);
    if (settings.noise > 0)
        add_noise(walk);
    add_t_pose(walk);
    return walk;
}

} // namespace walker
