// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report.hpp"
#include "style.hpp"
#include "table.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string fixed(const Json& value, int digits) {
    return fmt::format("{:.{}f}", value.get<double>(), digits);
}

std::string seams_table(const Json& synthesis, const std::vector<std::string>& pieces,
                        bool colors) {
    using enum Align;
    const Json& seams = synthesis["seams"];
    if (seams.empty())
        return "";
    Table table({right, right, left, left, right, right, right, right, right, right});
    table.add({"frame", "seconds", "from", "to", "until", "on at", "crossfade", "posture", "step",
               "acceleration"});
    for (const Json& seam : seams)
        table.add({seam["frame"].dump(), fixed(seam["time_s"], 3),
                   piece_name(pieces[seam["piece"].get<std::size_t>()]),
                   piece_name(pieces[seam["next"].get<std::size_t>()]), seam["cut_end"].dump(),
                   seam["cut_begin"].dump(), fixed(seam["crossfade_s"], 3),
                   fixed(seam["posture"], 2), fixed(seam["step"], 2),
                   fixed(seam["acceleration"], 2)});
    return '\n' + table.text(true, colors);
}

constexpr const char* legend =
    "  until, on at: frames at which the pieces are cut; posture: how unlike they are\n"
    "  there, 1 being as unlike as a motion is to its own repetition; step, acceleration:\n"
    "  largest step and change of step near the seam over the pieces' own, 1 and below is\n"
    "  not seen\n";

} // namespace

std::string piece_name(const std::string& piece) {
    return piece.substr(piece.find_last_of('/') + 1);
}

std::string synthesis_summary(const Json& synthesis) {
    const Json& clip = synthesis["clip"];
    return fmt::format("{}, {} s, from {} with {}",
                       counted(clip["frames"].get<std::size_t>(), "frame"),
                       fixed(clip["duration_s"], 2), counted(synthesis["pieces"].size(), "piece"),
                       counted(synthesis["seams"].size(), "seam"));
}

std::string synthesis_report(const Json& synthesis, const std::vector<std::string>& pieces,
                             bool colors) {
    return bold(synthesis_summary(synthesis), colors) + '\n' +
           seams_table(synthesis, pieces, colors) +
           (synthesis["seams"].empty() ? "" : dim(legend, colors)) +
           listed("warning:", synthesis["warnings"]);
}

} // namespace tool
