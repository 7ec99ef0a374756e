// SPDX-License-Identifier: BSD-3-Clause
// Actions between rests, and which of them are one motion.
#pragma once

#include <vector>

#include "motion/period/signal.hpp"

namespace stltsa::motion {

/// Where the body keeps still for a moment.
std::vector<Rows> find_rests(const Signal& signal);

/// Where the body keeps still between motions: in its home posture, the one in which it rests most,
/// or for long. Other rests are part of a motion, such as arms held up.
struct Pauses {
    std::vector<Rows> rests;
    std::vector<bool> home; ///< for each rest
};
Pauses find_pauses(const Signal& signal, const std::vector<Rows>& rests);

/// Motions between pauses. Only rows of `ranges` count, which are ascending.
std::vector<Rows> find_motions(const Signal& signal, const Pauses& pauses,
                               const std::vector<Rows>& ranges);

/// 0: the same motion, 1 and more: unrelated; the poses are compared by dynamic time warping,
/// relative to how far they move.
double unlikeness(const Signal& signal, Rows a, Rows b);

/// Group of each motion, numbered by first appearance.
std::vector<int> group_motions(const Signal& signal, const std::vector<Rows>& motions);

/// Largest unlikeness within a group.
constexpr double same_motion = 0.25;

} // namespace stltsa::motion
