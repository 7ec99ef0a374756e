// SPDX-License-Identifier: BSD-3-Clause
// What is done when in a recording, and what of it repeats. Everything counts in samples; the room
// results maps them to frames of the source.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/warning.hpp"
#include "linalg/matrix.hpp"
#include "ltsa/parameters.hpp"
#include "motion/cycles/sides.hpp"

namespace stltsa::motion {

/// Same values as STLTSA_SEGMENT_* (checked in capi).
enum class SegmentKind : std::int32_t {
    cyclic = 1,      ///< cycles back to back
    repetitions = 2, ///< one action again and again, with pauses
    action = 3,      ///< a motion that is seen once
    rest = 4,
};

/// A stretch of one behavior, [begin, end) in samples, not rounded.
struct Segment {
    SegmentKind kind = SegmentKind::action;
    double begin = 0;
    double end = 0;
    int label = -1;              ///< 0 for A, in order of appearance; -1: a rest
    double likeness = none;      ///< mean likeness to the others of its label; NaN: there are none
    double period = 0;           ///< median of the cycles; 0: not cyclic
    double candidate_period = 0; ///< seen, but not claimed; 0: none
    std::int64_t count = 0;      ///< cycles or repetitions
    std::vector<double> energy;  ///< of the motion of each column of the samples; empty: a rest
    bool open_begin = false;     ///< the recording begins within this motion
    bool open_end = false;
    double confidence = 0;
    double begin_confidence = none; ///< of its first border; NaN at the start
    std::string reason;             ///< why no cycles are claimed
    Halves halves;                  ///< of its cycles
};

struct Cycle {
    std::int64_t segment = 0;
    double begin = 0;
    double end = 0;
    int side = -1;          ///< 0 or 1; -1: unknown
    double likeness = none; ///< to the mean cycle of its segment
    double confidence = 0;
    bool at_strikes = false; ///< it lasts from strike to strike
};

/// Half of a cycle in which one side of the body does what the other does in the next.
struct Step {
    std::int64_t segment = 0;
    std::int64_t cycle = 0;
    double begin = 0;
    double end = 0;
    int side = 0;
};

struct Repetition {
    std::int64_t segment = 0;
    double begin = 0;
    double end = 0;
    double likeness = none; ///< mean likeness to the others of its label
    double confidence = 0;
};

/// Same values as STLTSA_UNIT_* (checked in capi).
enum class UnitKind : std::int32_t {
    preparing = 1,
    initial = 2,
    cyclic = 3,
    final = 4,
    wind_up = 5,
    action = 6, ///< motion without claimed cycles
    hold = 8,   ///< keeping a posture between motions that is not the one at rest
};

struct Unit {
    UnitKind kind = UnitKind::action;
    std::int64_t segment = 0;
    double begin = 0;
    double end = 0;
};

/// The reason of a rest that is a hole.
inline constexpr const char* nothing_recorded = "nothing recorded";

/// Samples [begin, end) of which nothing is known, because most of the body was not recorded. They
/// become a rest. An empty one only divides, where a clip was cut.
struct Hole {
    double begin = 0;
    double end = 0;
};

struct Recording;

struct Options {
    PeriodRange periods;
    /// Number in motion; unset: as many as the behavior changes.
    std::optional<std::int64_t> segments;
    double smoothed_s = 0; ///< sigma of the Gaussian that smoothed the samples
    double size = 0;       ///< of the body: norm of its mean pose; 0: the samples are no positions
    /// One weight for each column of the samples: positive where the sum of weighted velocities is,
    /// one side of the body moves forward. Empty: the body is unknown.
    std::vector<double> side;
    /// Weights of a motion that both sides do alike, each in its step: of the side with positive
    /// weights in `side`, and of the other.
    std::vector<double> one_side, other_side;
    /// Whether the side of one_side moves forward while the sum of `side` is positive.
    std::optional<bool> forward;
    /// Whether cycles begin with the same side even if that costs one: the sides of a skeleton are
    /// known, those of points depend on names and layout.
    bool begin_with_side = true;
    std::vector<Hole> holes; ///< ascending
    /// Rotations of the joints, samples x columns, by which behaviors are told apart as well;
    /// empty: none.
    Matrix rotations;
    /// The strikes of each motion, in samples, given an answer without them; unset: none are known.
    std::function<std::vector<Strikes>(const Recording&)> strikes;
    // For messages only.
    std::string jump; ///< where the pose jumps; empty: nowhere
    double jump_s = no_time;
    bool in_space = false; ///< the samples may contain the body's path through space
};

/// The coordinates of all segments with cycles, and the fit of the longest one.
struct Curve {
    Matrix coords;             ///< samples x 2: the coordinate, and one a quarter of a cycle behind
    std::vector<double> curve; ///< the coordinate; 0 outside segments with cycles
    // Of the longest segment with cycles: its first 12 periods, 24 samples in each.
    ltsa::Parameters parameters;
    int coordinate = 0;   ///< 1-based, of those of the fit; 0: no fit
    double cyclicity = 0; ///< of that coordinate, at most 1
    std::vector<double> eigenvalues;
    double residual = 0, error_estimate = 0;
    double period = 0;      ///< samples; 0: nothing is cyclic
    double lag_quality = 0; ///< match of the velocities one period apart, at most 1
};

struct Recording {
    Curve curve;
    std::vector<Segment> segments; ///< cover [0, samples) without gap or overlap
    std::vector<Unit> units;       ///< so do these
    std::vector<Cycle> cycles;
    std::vector<Step> steps;
    std::vector<Repetition> repetitions;
    Matrix label_likeness; ///< labels x labels: mean over pairs of their segments; NaN: no pair
    std::int64_t representative = -1; ///< of the longest cyclic segment: its first cycle
    std::int64_t best = -1;           ///< and the one most like its mean cycle
    std::string reason;               ///< why nothing repeats; empty if something does
    Warnings warnings;
};

} // namespace stltsa::motion
