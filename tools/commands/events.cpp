// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "arguments/marks.hpp"
#include "arguments/pieces.hpp"
#include "base/side_name.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/events.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

struct Analyzed {
    std::string path;
    stltsa::Decomposition found;
    stltsa::Phase phase;
};

Analyzed analyzed(const Session& session, const std::string& path, const stltsa::Clip& clip) {
    stltsa::Decomposition found = stltsa::decompose(clip, session.options());
    stltsa::Phase phase = stltsa::find_phase(found, session.options());
    return {path, std::move(found), std::move(phase)};
}

/// Of an event on the other side of the body.
std::string other_side(const std::string& name) {
    const std::int32_t side = stltsa::side_of_name(name);
    for (const stltsa::OtherSide& other : stltsa::other_sides(name, false))
        if (static_cast<std::int32_t>(other.side) == side &&
            stltsa::side_of_name(other.name) == 1 - side)
            return other.name;
    return name + " (other side)";
}

/// The cycle of an event that was found in the mirror image is that of the clip itself.
std::int64_t cycle_at(const stltsa::Decomposition& found, double frame) {
    const std::vector<stltsa::Part> cycles = found.cycles();
    const auto cycle = std::ranges::find_if(cycles, [&](const stltsa::Part& of) {
        return static_cast<double>(of.begin) <= frame && frame < static_cast<double>(of.end);
    });
    return cycle == cycles.end() ? -1 : cycle - cycles.begin();
}

/// Adds the warnings of a search: those of the library, and of what was not found.
void warn(const stltsa::Events& found, const std::string& path, const std::string& name,
          EventTable& table) {
    for (const stltsa::Warning& warning : found.warnings())
        if (const std::string text = fmt::format("{}: {}: {}", path, name, warning.text);
            std::ranges::find(table.warnings, text) == table.warnings.end())
            table.warnings.push_back(text);
    if (found.all().empty())
        table.warnings.push_back(
            fmt::format("{}: no motion like the marked one, so no {} (likeness {:.2f})", path, name,
                        found.likeness()));
    else if (found.likeness() < doubtful_likeness)
        table.warnings.push_back(fmt::format(
            "{}: the motion differs from the marked one (likeness {:.2f}, below {}): mark one {} "
            "in this clip if the place must be exact",
            path, found.likeness(), doubtful_likeness, name));
}

void append_other_side(const Session& session, const Analyzed& from, const Analyzed& in,
                       const stltsa::Clip& clip, const Marks& marks, EventTable& table) {
    const stltsa::Clip image = clip.mirrored(session.options());
    const Analyzed mirrored = analyzed(session, in.path, image);
    for (const auto& [name, frames] : marks) {
        if (marks.contains(other_side(name)))
            continue; // both sides are marked
        const stltsa::Events found = from.phase.events(frames, mirrored.phase, session.options());
        table.searches.push_back(
            {in.path, other_side(name), std::ssize(found.all()), found.likeness()});
        warn(found, in.path, other_side(name), table);
        for (stltsa::Event event : found.all()) {
            event.cycle = cycle_at(in.found, event.frame);
            table.events.push_back({in.path, other_side(name), event});
        }
    }
}

void append(const Session& session, const Analyzed& from, const Analyzed& in, const Marks& marks,
            EventTable& table) {
    for (const auto& [name, frames] : marks) {
        const stltsa::Events found = from.phase.events(frames, in.phase, session.options());
        table.searches.push_back({in.path, name, std::ssize(found.all()), found.likeness()});
        for (const stltsa::Event& event : found.all())
            table.events.push_back({in.path, name, event});
        warn(found, in.path, name, table);
    }
}

/// Adds the labels of a file that can be searched for, as Python's events_like() chooses them:
/// labels in motions that repeat, with names whose labels are not spread over the whole cycle.
void add_useful(const Session& session, const Analyzed& from, const std::string& file,
                const Marks& labels, Marks& marks, EventTable& table) {
    const auto refusal = [&](const std::vector<double>& frames) -> std::string {
        try {
            from.phase.events(frames, from.phase, session.options());
            return "";
        } catch (const stltsa::Error& error) {
            if (error.status() != STLTSA_E_ARGUMENT)
                throw;
            return error.what();
        }
    };
    // Each refusal is a search of the whole clip, so lists are halved rather than tried one by one.
    const auto keep_useful = [&](const auto& self, const std::vector<double>& frames,
                                 std::vector<double>& useful) -> void {
        if (refusal(frames).empty()) {
            useful.insert(useful.end(), frames.begin(), frames.end());
        } else if (frames.size() > 1) {
            const auto middle = frames.begin() + std::ssize(frames) / 2;
            self(self, {frames.begin(), middle}, useful);
            self(self, {middle, frames.end()}, useful);
        }
    };
    for (const auto& [name, frames] : labels) {
        std::vector<double> useful;
        keep_useful(keep_useful, frames, useful);
        const std::string why =
            useful.empty() ? "none of its labels is in a motion that repeats" : refusal(useful);
        if (!why.empty()) {
            table.warnings.push_back(fmt::format("{}: {} is left out: {}", file, name, why));
            continue;
        }
        marks[name].insert(marks[name].end(), useful.begin(), useful.end());
        if (useful.size() < frames.size())
            table.warnings.push_back(
                fmt::format("{}: {}: {} of {} labels are left out: they are in no motion that "
                            "repeats",
                            file, name, frames.size() - useful.size(), frames.size()));
    }
}

std::string text_of(const std::string& path) {
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
        throw Failure(Exit::unreadable, fmt::format("{}: cannot read: a folder", path));
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file)
        throw Failure(Exit::unreadable,
                      fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
    return text;
}

/// The labels of a table, or the events of a C3D file: those of the clip itself, if it is read from
/// there.
Marks labels_of(const std::string& path, const Session& session) {
    const std::string& input = session.arguments().input;
    const double fps = session.clip().fps();
    if (!ends_in(path, ".c3d"))
        return labels_in(text_of(path), path, input, fps);
    if (path == file_of(input))
        return labels_in(session.clip().events(), path, path, fps);
    return labels_in(session.open_clip(path).events(), path, input, fps);
}

} // namespace

Exit run_events(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Clip& clip = session.open_input();
    std::vector<std::string> typed, files;
    for (const std::string& mark : arguments.marks)
        (is_label_file(mark) ? files : typed).push_back(mark);
    Marks marks = parse_marks(typed, clip.fps());
    std::vector<std::pair<std::string, Marks>> labels;
    for (const std::string& file : files)
        labels.emplace_back(file, labels_of(file, session));
    const Analyzed from = analyzed(session, arguments.input, clip);
    EventTable table;
    for (const auto& [file, of_file] : labels)
        add_useful(session, from, file, of_file, marks, table);
    const auto find_in = [&](const Analyzed& in, const stltsa::Clip& of) {
        append(session, from, in, marks, table);
        if (arguments.both_sides)
            append_other_side(session, from, in, of, marks, table);
    };
    find_in(from, clip);
    for (const std::string& path : arguments.pieces) {
        const stltsa::Clip other = session.open_clip(path);
        find_in(analyzed(session, path, other), other);
    }
    sort_events(table);
    session.finish({[&] { return events_json(table); }, [&] { return events_report(table); },
                    table.warnings, [&] { return events_csv(table); }});
    return Exit::done;
}

} // namespace tool
