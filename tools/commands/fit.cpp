// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "arguments/marks.hpp"
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"

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

/// Keeps the mean cycle in the model. Returns why a stream could not be compared with it; then the
/// model is of use for all else.
std::optional<std::string> unfit_cycle(stltsa::Model& model, const stltsa::Phase& phase) {
    try {
        stltsa::keep_cycle(model, phase);
        return {};
    } catch (const stltsa::Error& error) {
        if (error.status() != STLTSA_E_DEGENERATE)
            throw;
        return error.what();
    }
}

/// Keeps the mean cycle and the marks in the model; a clip without cycles has none. Returns
/// warnings.
std::vector<std::string> keep_cycle(const Arguments& arguments, const Session& session,
                                    stltsa::Model& model) {
    const stltsa::Clip& clip = session.clip();
    const Marks marks = parse_marks(arguments.marks, clip.fps());
    if (!(clip.fps() > 0))
        return {};
    const stltsa::Options options = reading_options(session.options());
    const stltsa::Decomposition found = stltsa::decompose(clip, options);
    if (found.cycles().empty()) {
        if (!marks.empty())
            throw Failure(Exit::untrustworthy,
                          fmt::format("--mark {}: the clip has no cycles: {}",
                                      arguments.marks.front(), found.reason()));
        return {};
    }
    const stltsa::Phase phase = stltsa::find_phase(found, options);
    if (const auto reason = unfit_cycle(model, phase)) {
        if (!marks.empty())
            throw Failure(Exit::untrustworthy,
                          fmt::format("--mark {}: {}", arguments.marks.front(), *reason));
        return {"the model keeps no mean cycle for stltsa live: " + *reason};
    }
    for (const auto& [name, frames] : marks)
        for (const double frame : frames)
            stltsa::keep_mark(model, phase, frame, name);
    return {};
}

} // namespace

Exit run_fit(const Arguments& arguments) {
    Session session(arguments);
    stltsa::Model model = stltsa::fit(session.open_input(), session.options());
    if (!arguments.coords.empty())
        session.add_table(arguments.coords, model.coords());
    std::vector<std::string> of_cycle;
    if (!arguments.product.empty()) {
        of_cycle = keep_cycle(arguments, session, model);
        session.add_model(arguments.product, model);
    }
    const auto table = [&] {
        return model_report(model, session.title()) + listed("warning:", of_cycle);
    };
    std::vector<std::string> warnings = texts_of(model.warnings());
    std::ranges::copy(of_cycle, std::back_inserter(warnings));
    session.finish({[&] { return model.json(); }, table, warnings});
    return model.info().count(STLTSA_INFO_COMPONENT) > 1 ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
