// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "make_figure.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {

Exit run_fit(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Model model = stltsa::fit(session.open_input(), session.options());
    const Json object = parsed_json(model.json());
    if (!arguments.coords.empty())
        session.add_table(arguments.coords, model.coords());
    if (!arguments.product.empty())
        session.add_model(arguments.product, model);
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, fit_figure(session, object, model));
    session.finish(object, model_report(object, session.title(), session.colors()));
    return object["components"].size() > 1 ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
