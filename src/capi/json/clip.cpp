// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json/parts.hpp"
#include "clip/features/features.hpp"

#include <utility>

namespace stltsa::capi {
namespace {

Json joints(const clip::Clip& clip) {
    std::vector<Json> list;
    if (!clip.skeleton)
        return list;
    for (const clip::Joint& joint : clip.skeleton->joints)
        list.push_back(JsonObject("name", joint.name, "parent",
                                  joint.parent < 0 ? Json(nullptr) : Json(joint.parent), "end_site",
                                  joint.end_site));
    return list;
}

std::vector<Json> events(const clip::Clip& clip) {
    std::vector<Json> list;
    for (const clip::Event& event : clip.events)
        list.push_back(JsonObject("frame", event.frame, "seconds",
                                  clip.fps > 0 ? Json(event.frame / clip.fps) : Json(nullptr),
                                  "label", event.label, "context", event.context));
    return list;
}

} // namespace

std::string clip_json(const clip::Clip& clip) {
    JsonObject object = json_head("clip");
    JsonObject of_clip =
        json_clip(clip_facts(clip), default_features(clip), default_first_frame(clip));
    of_clip.set("up_axis", json_axis(clip.up)); // as the file states it
    of_clip.set("unit", json_string_or_null(clip.unit));
    of_clip.set("events", events(clip));
    object.set("clip", std::move(of_clip));
    object.set("channels", JsonObject("count", clip.values.cols(), "names", clip.channel_names));
    object.set("joints", joints(clip));
    object.set("up_axis", json_axis(default_up(clip)));
    object.set("feature_count", clip::feature_count(clip, {}));
    return object.text();
}

} // namespace stltsa::capi
