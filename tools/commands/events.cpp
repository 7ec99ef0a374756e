// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <vector>

#include <fmt/format.h>

#include "arguments/marks.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/events.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

struct Analyzed {
    std::string path;
    stltsa::Phase phase;
};

Analyzed analyzed(const Session& session, const std::string& path, const stltsa::Clip& clip) {
    const stltsa::Decomposition found = stltsa::decompose(clip, session.options());
    return {path, stltsa::find_phase(clip, found, session.options())};
}

void append(const Analyzed& from, const Analyzed& in, const Marks& marks, EventTable& table) {
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
    const auto marks = parse_marks(arguments.marks, clip.fps());
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
