// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json/parts.hpp"
#include "clip/features/features.hpp"

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

} // namespace

std::string clip_json(const clip::Clip& clip) {
    JsonObject object = json_head("clip");
    object.set("clip",
               json_clip(clip_facts(clip), default_features(clip), default_first_frame(clip)));
    object.set("channels", JsonObject("count", clip.values.cols(), "names", clip.channel_names));
    object.set("joints", joints(clip));
    object.set("up_axis", json_axis(default_up(clip)));
    object.set("feature_count", clip::feature_count(clip, {}));
    return object.text();
}

} // namespace stltsa::capi
