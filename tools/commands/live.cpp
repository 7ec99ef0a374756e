// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/json.hpp"

namespace tool {
namespace {

std::vector<std::string> names_in(const std::vector<std::string>& marks, std::int64_t passed) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < marks.size(); ++i)
        if ((passed >> i & 1) != 0)
            names.push_back(marks[i]);
    return names;
}

std::string json_line(std::int64_t frame, double seconds, const stltsa::LiveFrame& found,
                      const std::vector<std::string>& names) {
    return Json(JsonObject("frame", frame, "seconds", seconds, "phase", found.phase, "rate_hz",
                           found.rate_hz, "cycles", found.cycles, "segment_kind",
                           stltsa::segment_name(found.kind), "distance", found.distance,
                           "confidence", found.confidence, "known", found.known != 0, "events",
                           names))
        .text();
}

std::string table_line(std::int64_t frame, double seconds, const stltsa::LiveFrame& found,
                       const std::vector<std::string>& names) {
    return fmt::format("{:7} {:9.3f} {:6.3f} {:7.3f} {:7.2f} {:8.2f}  {:7} {}", frame, seconds,
                       found.phase, found.rate_hz, found.cycles, found.distance,
                       stltsa::segment_name(found.kind), fmt::join(names, ", "));
}

/// One line for each frame.
std::string played(const stltsa::Model& model, const stltsa::Clip& clip, bool json) {
    stltsa::Live live(model);
    const std::vector<std::string> marks = live.marks();
    std::string text =
        json ? "" : "  frame   seconds  phase rate Hz  cycles distance  kind    events\n";
    for (std::int64_t frame = 0; frame < clip.frames(); ++frame) {
        const double seconds = static_cast<double>(frame) / clip.fps();
        const stltsa::LiveFrame found = live.push(seconds, clip, frame);
        const auto names = names_in(marks, found.passed);
        text += json ? json_line(frame, seconds, found, names)
                     : table_line(frame, seconds, found, names);
        text += '\n';
    }
    return text;
}

/// What the model says about its mean cycle.
std::vector<std::string> warnings_of(const stltsa::Model& model) {
    std::vector<std::string> texts;
    for (const stltsa::Warning& warning : model.warnings())
        if (warning.code == STLTSA_WARNING_LINEAR_PHASE)
            texts.emplace_back(warning.text);
    return texts;
}

} // namespace

Exit run_live(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Model model = session.open_model(arguments.model);
    if (!model.has_cycle())
        throw Failure(Exit::untrustworthy,
                      fmt::format("{}: the model keeps no mean cycle: fit it to a clip that has "
                                  "cycles",
                                  arguments.model));
    const stltsa::Clip& clip = session.open_input();
    if (!(clip.fps() > 0))
        throw Failure(Exit::usage, "the clip has no frame rate: set --fps");
    std::string lines = played(model, clip, arguments.json);
    lines.pop_back(); // finish() ends the last one
    session.finish({[&] { return lines; }, [&] { return lines + '\n'; }, warnings_of(model)});
    return Exit::done;
}

} // namespace tool
