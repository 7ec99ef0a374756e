// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "commands.hpp"
#include "mapped.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {
namespace {

/// What keeps the frames of the clip from being comparable with those of the model.
Json warnings_of(const stltsa::Model& model, const stltsa::Clip& clip) {
    Json warnings = Json::array();
    const Json samples = parsed_json(model.json())["samples"];
    const auto smoothing = samples["smoothing_s"].get<double>();
    if (smoothing > 0 && !samples["fps"].is_null() && !(clip.fps() > 0))
        warnings.push_back(fmt::format("the clip has no frame rate, so that it is not smoothed as "
                                       "the model's frames were, over {:.3g} s: set --fps",
                                       smoothing));
    return warnings;
}

} // namespace

Exit run_map(const Arguments& arguments) {
    Session session(arguments);
    const stltsa::Model model = session.open_model(arguments.model);
    const stltsa::Clip& clip = session.open_input();
    const stltsa::Mapped mapped = model.map(clip, session.options());
    if (!arguments.product.empty())
        session.add_table(arguments.product, mapped.values);
    Json object = mapping_json("map", arguments, model, mapped, clip.fps());
    object["warnings"] = warnings_of(model, clip);
    if (arguments.curve)
        object["curve"] = mapped_json(mapped);
    session.finish(object, mapping_report(object, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
