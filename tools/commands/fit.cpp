// SPDX-License-Identifier: BSD-3-Clause
#include "commands/commands.hpp"
#include "commands/session.hpp"
#include "plot/from_results.hpp"
#include "reports/report.hpp"

namespace tool {

Exit run_fit(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Model model = stltsa::fit(session.open_input(), session.options());
    if (!arguments.coords.empty())
        session.add_table(arguments.coords, model.coords());
    if (!arguments.product.empty())
        session.add_model(arguments.product, model);
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, fit_figure(session, model));
    session.finish({[&] { return model.json(); },
                    [&] { return model_report(model, session.title()); }, model.warnings()});
    return model.info().integer(STLTSA_INFO_COMPONENTS) > 1 ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
