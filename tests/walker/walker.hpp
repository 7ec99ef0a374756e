// SPDX-License-Identifier: BSD-3-Clause
// A synthetic walker whose motion units and cycles are known exactly. It stands at attention, makes
// a first step, walks a number of cycles of two steps, makes a last step, and stands. See
// README.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace walker {

struct Settings {
    double fps = 120;
    int cycles = 3;
    double period = 1.1;       ///< seconds per cycle (with a ramp: at the first landing)
    double stand_before = 1.0; ///< seconds
    double stand_after = 1.0;  ///< seconds
    double stride = 1.0;       ///< amplitude of all joint angles, relative to normal walking
    double ramp = 0;           ///< relative gain in tempo from the first landing to the last
    double turn = 0;           ///< degrees to the left per cycle
    double sway = 0;           ///< sway of the standing body about the ankles, degrees rms
    double height = 175;       ///< height of the body, cm
    bool right_first = false;  ///< step first with the right foot
    double noise = 0;          ///< standard deviation on every rotation channel, degrees
    std::uint64_t seed = 1;    ///< seed of the noise
    int t_pose_frames = 0;     ///< frames at the start in which a T-pose turns into standing
    std::string order = "ZXY"; ///< order of the rotation channels of all joints
};

/// Half-open interval in frames and exact seconds; `begin` is the first frame at or after
/// `begin_s`.
struct Interval {
    std::string kind;
    std::int64_t begin = 0;
    std::int64_t end = 0;
    double begin_s = 0;
    double end_s = 0;
};

constexpr std::size_t channel_count = 57; ///< 3 root positions, then 18 joints x 3 rotations

struct Walk {
    Settings settings;
    std::int64_t frames = 0;
    double period = 0;            ///< mean seconds per cycle
    std::vector<double> channels; ///< frames x channel_count, cm and degrees
    std::vector<Interval> units; ///< preparing, initial, cyclic, final, wind-up; without empty ones
    std::vector<Interval> cycles;
};

/// Throws std::invalid_argument if a setting is out of range.
Walk make_walk(const Settings& settings);

std::string bvh_text(const Walk& walk);
/// JSON with the field names of `stltsa decompose --json`.
std::string borders_text(const Walk& walk);

} // namespace walker
