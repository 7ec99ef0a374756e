// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"
#include "make_figure.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {
namespace {

/// The curve and the loop for those who want to plot themselves; NaN becomes null.
Json samples_json(const stltsa::Decomposition& decomposition, const Json& samples) {
    const auto count = samples["count"].get<std::int64_t>();
    const auto first = samples["first_frame"].get<std::int64_t>();
    const auto step = samples["frame_step"].get<std::int64_t>();
    const stltsa::Matrix loop = decomposition.loop();
    Json frames = Json::array();
    Json points = Json::array();
    for (std::int64_t i = 0; i < count; ++i) {
        frames.push_back(first + i * step);
        points.push_back({loop(i, 0), loop(i, 1)});
    }
    return {{"frames", frames}, {"values", decomposition.curve().values}, {"loop", points}};
}

} // namespace

Exit run_decompose(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Decomposition decomposition =
        stltsa::decompose(session.open_input(), session.options());
    Json object = parsed_json(decomposition.json());
    if (!arguments.plot.empty())
        session.add_file(arguments.plot, decomposition_figure(session, object, decomposition));
    if (arguments.curve)
        object["curve"] = samples_json(decomposition, object["samples"]);
    session.finish(object, decomposition_report(object, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
