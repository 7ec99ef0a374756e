// SPDX-License-Identifier: BSD-3-Clause
#include "reports/events.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "reports/json.hpp"
#include "reports/table.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

Json cycle_json(const stltsa::Event& event) {
    return event.cycle < 0 ? Json(nullptr) : Json(event.cycle);
}

/// The side of the body that the name states; empty if it states none.
std::string side_of(const NamedEvent& event) {
    const std::int32_t side = stltsa::side_of_name(event.name);
    if (side == STLTSA_SIDE_NONE)
        return "";
    return side == STLTSA_SIDE_LEFT ? "left" : "right";
}

std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

} // namespace

void sort_events(EventTable& table) {
    // Clips stay in the order in which they were given.
    for (auto begin = table.events.begin(); begin != table.events.end();) {
        const auto end = std::find_if(begin, table.events.end(), [&](const NamedEvent& event) {
            return event.clip != begin->clip;
        });
        std::stable_sort(begin, end, [](const NamedEvent& a, const NamedEvent& b) {
            return a.event.frame < b.event.frame;
        });
        begin = end;
    }
}

std::string events_json(const EventTable& table) {
    std::vector<Json> events, searches;
    for (const NamedEvent& each : table.events)
        events.push_back(JsonObject(
            "clip", each.clip, "name", each.name, "side", json_or_null(side_of(each)), "frame",
            each.event.frame, "seconds", each.event.seconds, "cycle", cycle_json(each.event),
            "confidence", each.event.confidence, "marked", each.event.marked != 0));
    for (const EventSearch& each : table.searches)
        searches.push_back(JsonObject("clip", each.clip, "name", each.name, "count", each.count,
                                      "likeness", each.likeness));
    return Json(JsonObject("format", "stltsa-events/1", "library", stltsa::version(), "events",
                           events, "searches", searches, "warnings", table.warnings))
        .text();
}

std::string events_csv(const EventTable& table) {
    std::string text = "clip,name,frame,seconds,cycle,confidence,marked,side\n";
    for (const NamedEvent& each : table.events)
        text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_cell(each.clip), csv_cell(each.name),
                            each.event.frame, each.event.seconds,
                            each.event.cycle < 0 ? "" : std::to_string(each.event.cycle),
                            each.event.confidence, each.event.marked, side_of(each));
    return text;
}

std::string events_report(const EventTable& table) {
    using enum Align;
    Table rows({left, left, left, right, right, right, right, left});
    rows.add({"clip", "event", "side", "frame", "seconds", "cycle", "confidence", ""});
    for (const NamedEvent& each : table.events)
        rows.add(
            {file_name(each.clip), each.name, side_of(each),
             fmt::format("{:.2f}", each.event.frame), fmt::format("{:.3f}", each.event.seconds),
             each.event.cycle < 0 ? "-" : std::to_string(each.event.cycle),
             fmt::format("{:.2f}", each.event.confidence), each.event.marked != 0 ? "marked" : ""});
    const std::string events = table.events.empty() ? "no events\n" : rows.text();
    const std::string warnings = listed("warning:", table.warnings);
    return events + (warnings.empty() ? "" : '\n' + warnings);
}

} // namespace tool
