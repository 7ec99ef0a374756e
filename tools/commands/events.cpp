// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/events.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

std::optional<double> number_in(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// Frames by name, from "131=strike" and "2.5s=strike".
std::map<std::string, std::vector<double>> marks_of(const Arguments& arguments, double fps) {
    std::map<std::string, std::vector<double>> marks;
    for (const std::string& typed : arguments.marks) {
        const std::size_t sign = typed.find('=');
        std::string_view place = std::string_view(typed).substr(0, sign);
        const bool seconds = place.ends_with('s');
        if (seconds)
            place.remove_suffix(1);
        const auto value = number_in(place);
        if (!value || sign == std::string::npos || sign + 1 == typed.size())
            throw Failure(Exit::usage,
                          fmt::format("--mark is given '{}': it takes FRAME=NAME, such as "
                                      "131=strike or 2.5s=strike",
                                      typed));
        if (seconds && !(fps > 0))
            throw Failure(Exit::usage, fmt::format("--mark {}: the frame rate is unknown: give a "
                                                   "frame, or --fps",
                                                   typed));
        marks[typed.substr(sign + 1)].push_back(seconds ? *value * fps : *value);
    }
    return marks;
}

struct Analyzed {
    std::string path;
    stltsa::Phase phase;
};

Analyzed analyzed(const Session& session, const std::string& path, const stltsa::Clip& clip) {
    const stltsa::Decomposition found = stltsa::decompose(clip, session.options());
    return {path, stltsa::find_phase(clip, found, session.options())};
}

void append(const Analyzed& from, const Analyzed& in,
            const std::map<std::string, std::vector<double>>& marks, EventTable& table) {
    for (const auto& [name, frames] : marks) {
        const stltsa::Events found = from.phase.events(frames, in.phase);
        table.searches.push_back({in.path, name, found.count(), found.likeness()});
        for (const stltsa::Event& event : found.all())
            table.events.push_back({in.path, name, event});
        if (found.count() == 0)
            table.warnings.push_back(
                fmt::format("{}: no motion like the marked one, so no {} (likeness {:.2f})",
                            in.path, name, found.likeness()));
        else if (found.likeness() < doubtful_likeness)
            table.warnings.push_back(fmt::format(
                "{}: the motion differs from the marked one (likeness {:.2f}, below {}): mark one "
                "{} in this clip if the place must be exact",
                in.path, found.likeness(), doubtful_likeness, name));
    }
}

} // namespace

Exit run_events(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Clip& clip = session.open_input();
    const auto marks = marks_of(arguments, clip.fps());
    const Analyzed from = analyzed(session, arguments.input, clip);
    EventTable table;
    append(from, from, marks, table);
    for (const std::string& path : arguments.pieces)
        append(from, analyzed(session, path, session.open_clip(path)), marks, table);
    sort_events(table);
    session.finish({[&] { return events_json(table); }, [&] { return events_report(table); },
                    table.warnings, [&] { return events_csv(table); }});
    return Exit::done;
}

} // namespace tool
