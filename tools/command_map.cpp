// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "commands.hpp"
#include "mapped.hpp"
#include "report.hpp"
#include "session.hpp"

namespace tool {
namespace {

/// What keeps the frames of the clip from being comparable with those of the model.
Json warnings_of(const stltsa_model* model, const stltsa_clip* clip) {
    Json warnings = Json::array();
    const Json samples = json_of(stltsa_model_json, model)["samples"];
    const auto smoothing = samples["smoothing_s"].get<double>();
    if (smoothing > 0 && !samples["fps"].is_null() && !(stltsa_clip_fps(clip) > 0))
        warnings.push_back(fmt::format("the clip has no frame rate, so that it is not smoothed as "
                                       "the model's frames were, over {:.3g} s: set --fps",
                                       smoothing));
    return warnings;
}

} // namespace

Exit run_map(const Arguments& arguments) {
    Session session(arguments);
    const Model model = session.open_model(arguments.model);
    const stltsa_clip* clip = session.open_input();
    Mapped mapped(stltsa_clip_frames(clip), whole_of(model.get(), STLTSA_MODEL_DIMENSION));
    const stltsa_out coords = mapped.values_out();
    const stltsa_out distance = mapped.distance_out();
    check(stltsa_map_clip(model.get(), clip, session.options(), &coords, &distance,
                          mapped.nearest.data()));
    if (!arguments.product.empty())
        session.add_table(arguments.product, mapped.values);
    Json object = mapping_json("map", arguments, model.get(), mapped, stltsa_clip_fps(clip));
    object["warnings"] = warnings_of(model.get(), clip);
    if (arguments.curve)
        object["curve"] = mapped_json(mapped);
    session.finish(object, mapping_report(object, session.title(), session.colors()));
    return Exit::done;
}

} // namespace tool
