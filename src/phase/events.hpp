// SPDX-License-Identifier: BSD-3-Clause
// An event that is marked once or a few times, found wherever the phase comes round again.
#pragma once

#include <vector>

#include "phase/searched.hpp"

namespace stltsa::phase {

struct Event {
    double row = 0;      ///< not rounded
    double error_ms = 0; ///< a guess of the size of its error
};

/// The event at a place, in every cycle or once in every repetition, in order of time. The mean of
/// three places: where the phase comes round, where velocity and acceleration are like those around
/// the marks, and where they are like those of the other cycles. Outside the cycles, the phase
/// alone counts.
std::vector<Event> find_events(const Searched& in, const Place& marks);

/// The same in another motion with the same features.
std::vector<Event> find_events(const Searched& from, const Place& marks, const Searched& in);

/// Correlation of the mean cycles at the best shift.
double likeness(const Searched& from, const Searched& in);

} // namespace stltsa::phase
