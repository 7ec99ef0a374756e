// SPDX-License-Identifier: BSD-3-Clause
// What is done when in a recording, and what of it repeats. Everything counts in samples; the room
// results maps them to frames of the source.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "motion/decomposition.hpp"

namespace stltsa::recording {

/// Same values as STLTSA_SEGMENT_* (checked in capi).
enum class SegmentKind : std::int32_t {
    cyclic = 1,      ///< cycles back to back
    repetitions = 2, ///< one action again and again, with pauses
    action = 3,      ///< a motion that is seen once
    rest = 4,
};

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A stretch of one behavior, [begin, end) in samples, not rounded.
struct Segment {
    SegmentKind kind = SegmentKind::action;
    double begin = 0;
    double end = 0;
    int label = -1;              ///< 0 for A, in order of appearance; -1: a rest
    double likeness = unknown;   ///< mean likeness to the others of its label; NaN: there are none
    double period = 0;           ///< median of the cycles; 0: not cyclic
    double candidate_period = 0; ///< seen, but not claimed; 0: none
    std::int64_t count = 0;      ///< cycles or repetitions
    std::vector<double> energy;  ///< of the motion of each column of the samples; empty: a rest
    bool open_begin = false;     ///< the recording begins within this motion
    bool open_end = false;
    double confidence = 0;
    double begin_confidence = unknown; ///< of its first border; NaN at the start
    std::string reason;                ///< why no cycles are claimed
};

struct Cycle {
    std::int64_t segment = 0;
    double begin = 0;
    double end = 0;
    int side = -1;             ///< 0 or 1; -1: unknown
    double likeness = unknown; ///< to the mean cycle of its segment
    double confidence = 0;
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
    double likeness = unknown; ///< mean likeness to the others of its label
    double confidence = 0;
};

struct Unit {
    motion::UnitKind kind = motion::UnitKind::action;
    std::int64_t segment = 0;
    double begin = 0;
    double end = 0;
};

/// Samples [begin, end) of which nothing is known, because most of the body was not recorded.
struct Hole {
    double begin = 0;
    double end = 0;
};

struct Options {
    motion::DecomposeOptions single; ///< of a clip of one motion
    /// Number in motion; unset: as many as the behavior changes.
    std::optional<std::int64_t> segments;
    double smoothed_s = 0; ///< sigma of the Gaussian that smoothed the samples
    double size = 0;       ///< of the body: norm of its mean pose; 0: the samples are no positions
    /// One weight for each column of the samples: positive where the sum of weighted velocities is,
    /// one side of the body moves forward. Empty: the body is unknown.
    std::vector<double> side;
    /// Whether all cycles begin with the same side, at the cost of half a cycle; otherwise each
    /// cycle states the side with which it begins.
    bool begin_with_side = true;
    std::vector<Hole> holes; ///< ascending
};

struct Recording {
    /// Embedding and curve: of the whole clip, or traced through the segments that have cycles.
    motion::Decomposition shown;
    std::vector<Segment> segments; ///< cover [0, samples) without gap or overlap
    std::vector<Unit> units;       ///< so do these
    std::vector<Cycle> cycles;
    std::vector<Step> steps;
    std::vector<Repetition> repetitions;
};

} // namespace stltsa::recording
