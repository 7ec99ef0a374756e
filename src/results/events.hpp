// SPDX-License-Identifier: BSD-3-Clause
// Events marked in one clip, found in it or in another.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "phase/searched.hpp"
#include "results/phased.hpp"
#include "stltsa.h"

namespace stltsa::results {

struct FoundEvents {
    std::vector<stltsa_event> events; ///< in order of time
    double likeness = 1;              ///< of the mean cycles; 0: the other clip has no such motion
    Warnings warnings;
};

/// A motion and how far its phase goes beyond its cycles.
phase::Searched searched(const Phased& phased, const PhasedMotion& motion);

/// The event at the marks, which are at one place of the motion, in each cycle or repetition of it,
/// and the marks themselves in the place of what was found near them.
std::vector<stltsa_event> events_at(const phase::Searched& motion, const phase::Place& marks,
                                    const Phased& in);

/// The event at `marks`, frames of `from`, in every cycle or repetition of that motion in `in`,
/// which may be the same; at each place, if the marks are at several places of the cycle. Throws
/// Status::argument for a mark in no motion that repeats and for marks all over the cycle, and
/// Status::shape if the features of the clips differ.
FoundEvents find_events(const Phased& from, std::span<const double> marks, const Phased& in);

} // namespace stltsa::results
