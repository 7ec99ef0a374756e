// SPDX-License-Identifier: BSD-3-Clause
// From the parts of a recording to its segments, in rows: cyclic stretches with the motion into and
// out of them, repetitions, single actions, and rests between them.
#pragma once

#include <string>
#include <vector>

#include "motion/behaviors/repetitions.hpp"
#include "motion/recording/parts.hpp"
#include "motion/recording/recording.hpp"

namespace stltsa::motion {

/// A segment in rows.
struct Draft {
    SegmentKind kind = SegmentKind::action;
    double begin = 0;
    double end = 0;
    std::vector<CyclicStretch> stretches; ///< cyclic: claimed
    std::vector<Rows> motions;            ///< repetitions; of an action, itself
    int group = -1;                       ///< of the motions; -1: cyclic or a rest
    bool known_motion = false;            ///< it is seen elsewhere between pauses
    bool is_hole = false;                 ///< a rest of which nothing is known
    int label = -1;
    double gain = 0;             ///< of the first border in prices; 0: at a rest, or at the start
    double candidate_period = 0; ///< rows
    double best_match = 0;
    std::string reason;

    Rows rows() const;
    std::vector<Interval> cycles() const;
};

/// Cover all rows of the signal. `of_shapes`: no motion continues across a border of parts.
std::vector<Draft> make_drafts(const Signal& signal, const std::vector<Part>& parts,
                               const Pauses& pauses, bool of_shapes);

/// Sets the labels of all that moves: the same motions share one.
void set_labels(const KernelFeatures& features, std::vector<Draft>& drafts);

/// Neighbors with one label that touch become one.
void join_neighbors(std::vector<Draft>& drafts);

} // namespace stltsa::motion
