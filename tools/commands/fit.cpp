// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "arguments/marks.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "plot/from_results.hpp"
#include "reports/report.hpp"

namespace tool {
namespace {

/// How the clip is read, without what concerns the fit.
stltsa::Options reading_options(const stltsa::Options& fit) {
    stltsa::Options options;
    for (const std::int32_t key :
         {STLTSA_OPT_FEATURES, STLTSA_OPT_UP_AXIS, STLTSA_OPT_KEEP_START, STLTSA_OPT_GAPS})
        if (fit.is_set(key))
            options.set(key, fit.integer(key));
    return options;
}

/// Keeps the mean cycle and the marks in the model; a clip without cycles has none.
void keep_cycle(const Arguments& arguments, const Session& session, stltsa::Model& model) {
    const stltsa::Clip& clip = session.clip();
    const Marks marks = parse_marks(arguments.marks, clip.fps());
    if (!(clip.fps() > 0))
        return;
    const stltsa::Options options = reading_options(session.options());
    const stltsa::Decomposition found = stltsa::decompose(clip, options);
    if (found.cycle_count() == 0) {
        if (!marks.empty())
            throw Failure(Exit::untrustworthy,
                          fmt::format("--mark {}: the clip has no cycles: {}",
                                      arguments.marks.front(), found.reason()));
        return;
    }
    const stltsa::Phase phase = stltsa::find_phase(clip, found, options);
    stltsa::keep_cycle(model, phase);
    for (const auto& [name, frames] : marks)
        for (const double frame : frames)
            stltsa::keep_mark(model, phase, frame, name);
}

} // namespace

Exit run_fit(const Arguments& arguments) {
    Session session(arguments);
    stltsa::Model model = stltsa::fit(session.open_input(), session.options());
    if (!arguments.coords.empty())
        session.add_table(arguments.coords, model.coords());
    if (!arguments.product.empty()) {
        keep_cycle(arguments, session, model);
        session.add_model(arguments.product, model);
    }
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, fit_figure(session, model));
    session.finish({[&] { return model.json(); },
                    [&] { return model_report(model, session.title()); }, model.warnings()});
    return model.info().integer(STLTSA_INFO_COMPONENTS) > 1 ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
