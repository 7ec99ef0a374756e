// SPDX-License-Identifier: BSD-3-Clause
// Events that were found in clips.
#pragma once

#include <string>
#include <vector>

#include <stltsa.hpp>

namespace tool {

/// Below it events of another clip are to be trusted less: walks of several people have 0.89 to
/// 0.96.
inline constexpr double doubtful_likeness = 0.95;

struct NamedEvent {
    std::string clip; ///< as given
    std::string name;
    stltsa::Event event;
};

/// What was looked for where.
struct EventSearch {
    std::string clip;
    std::string name;
    std::int64_t count = 0;
    double likeness = 1;
};

struct EventTable {
    std::vector<NamedEvent> events;
    std::vector<EventSearch> searches;
    std::vector<std::string> warnings;
};

/// By time within each clip.
void sort_events(EventTable& table);

std::string events_json(const EventTable& table);
std::string events_csv(const EventTable& table);
std::string events_report(const EventTable& table);

} // namespace tool
