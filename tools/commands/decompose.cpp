// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "plot/from_results.hpp"
#include "reports/json.hpp"
#include "reports/report.hpp"

namespace tool {
namespace {

/// Adds the curve and the loop, for plots; NaN becomes null.
std::string json_with_samples(const stltsa::Decomposition& found) {
    return with_member(found.json(), "curve",
                       JsonObject("frames", json_frames(found.info()), "values",
                                  found.curve().values, "loop", json_rows(found.loop())));
}

} // namespace

Exit run_decompose(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Decomposition found = stltsa::decompose(session.open_input(), session.options());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, decomposition_figure(session, found));
    session.finish({[&] { return arguments.curve ? json_with_samples(found) : found.json(); },
                    [&] { return decomposition_report(found, session.title()); }, found.warnings(),
                    [&] { return decomposition_csv(found); }});
    return Exit::done;
}

} // namespace tool
