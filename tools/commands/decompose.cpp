// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/json.hpp"
#include "reports/report.hpp"
#include "reports/sides.hpp"
#include "reports/table.hpp"

namespace tool {
namespace {

/// Adds the curve and the loop, for plots; NaN becomes null.
std::string json_with_samples(const stltsa::Decomposition& found) {
    return with_member(found.json(), "curve",
                       JsonObject("frames", json_frames(found.info()), "values",
                                  found.curve().values, "loop", json_rows(found.coords())));
}

/// frame, seconds, segment, cycle, phase, residual of every frame; NaN outside cycles.
stltsa::Matrix phase_table(const stltsa::Clip& clip, const stltsa::Decomposition& found,
                           const stltsa::Phase& phase) {
    const std::vector<double> values = phase.values(), residuals = phase.residuals();
    const std::vector<std::int64_t> cycles = phase.cycles();
    stltsa::Matrix table(clip.frames(), 6);
    const std::vector<stltsa::Segment> segments = found.segments();
    for (std::size_t s = 0; s < segments.size(); ++s) {
        const stltsa::Segment& segment = segments[s];
        for (std::int64_t frame = segment.begin; frame < segment.end; ++frame) {
            const auto at = static_cast<std::size_t>(frame);
            const double cycle = cycles[at] < 0 ? std::numeric_limits<double>::quiet_NaN()
                                                : static_cast<double>(cycles[at]);
            const double row[] = {static_cast<double>(frame),
                                  static_cast<double>(frame) / clip.fps(),
                                  static_cast<double>(s),
                                  cycle,
                                  values[at],
                                  residuals[at]};
            std::ranges::copy(row, &table(frame, 0));
        }
    }
    return table;
}

/// The results that --phase adds to the decomposition.
struct PhaseAnswer {
    std::vector<std::string> warnings;
    std::vector<LabelSides> sides;
};

/// Compares left with right for each motion that has cycles.
std::vector<LabelSides> compare_sides(const Session& session, const stltsa::Clip& clip,
                                      const stltsa::Decomposition& found,
                                      const stltsa::Phase& phase) {
    std::vector<LabelSides> all;
    for (const stltsa::Summary& summary : found.summaries()) {
        if (found.statistics(STLTSA_INFO_CYCLE, summary.label, -1, STLTSA_QUANTITY_TIME).count == 0)
            continue;
        LabelSides& of = all.emplace_back();
        of.letters = summary.letters;
        try {
            of.comparison = phase.compare_left_right(clip, summary.label, session.options());
        } catch (const stltsa::Error& error) {
            if (error.status() != STLTSA_E_UNSUPPORTED &&
                error.status() != STLTSA_E_TOO_FEW_FRAMES &&
                error.status() != STLTSA_E_ARGUMENT) // cycles too short for a phase
                throw;
            of.reason = error.what();
        }
    }
    return all;
}

/// Writes the phase.
PhaseAnswer add_phase(Session& session, const stltsa::Decomposition& found) {
    const stltsa::Phase phase = stltsa::find_phase(found, session.options());
    session.add_columns(session.arguments().phase, phase_table(session.clip(), found, phase),
                        {"frame", "seconds", "segment", "cycle", "phase", "residual"});
    return {texts_of(phase.warnings()), compare_sides(session, session.clip(), found, phase)};
}

std::string json_with_phase(const std::string& text, const PhaseAnswer& answer) {
    return with_member(with_member(text, "phase_warnings", answer.warnings), "sides",
                       sides_json(answer.sides));
}

} // namespace

Exit run_decompose(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Decomposition found = stltsa::decompose(session.open_input(), session.options());
    const auto save = [&](const std::string& name) {
        found.save_report(session.clip(), name, arguments.line, session.options());
    };
    if (!arguments.plot.empty())
        session.add_saved(arguments.plot, ".svg", save);
    if (!arguments.report.empty())
        session.add_saved(arguments.report, ".html", save);
    std::vector<std::string> warnings = texts_of(found.warnings());
    PhaseAnswer of_phase;
    if (!arguments.phase.empty())
        of_phase = add_phase(session, found);
    std::ranges::copy(of_phase.warnings, std::back_inserter(warnings));
    const auto json = [&] {
        const std::string text = arguments.curve ? json_with_samples(found) : found.json();
        return arguments.phase.empty() ? text : json_with_phase(text, of_phase);
    };
    const auto table = [&] {
        return decomposition_report(found, session.title()) + sides_report(of_phase.sides);
    };
    session.finish({json, table, warnings, [&] { return decomposition_csv(found); }});
    return Exit::done;
}

} // namespace tool
