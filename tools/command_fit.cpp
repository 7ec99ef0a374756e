// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "make_figure.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {

Exit run_fit(const Arguments& arguments) {
    Session session(arguments);
    session.open_input();
    const auto model = made_by<Model>([&](stltsa_model** made) {
        return stltsa_fit_clip(session.clip(), session.options(), made);
    });
    const Json object = json_of(stltsa_model_json, model.get());
    if (!arguments.coords.empty())
        session.add_table(arguments.coords, coordinates_of(model.get()));
    if (!arguments.product.empty())
        session.add_model(arguments.product, model.get());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot,
                         fit_figure(session, object, model.get(), coordinates_of(model.get())));
    session.finish(object, model_report(object, session.title(), session.colors()));
    return object["components"].size() > 1 ? Exit::untrustworthy : Exit::done;
}

} // namespace tool
