// SPDX-License-Identifier: BSD-3-Clause
#include "capi/json_parts.hpp"
#include "clip/features.hpp"
#include "clip/tpose.hpp"

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

ClipFacts clip_facts(const clip::Clip& clip) {
    return {clip.path, clip.format, clip.frames(), clip.fps, clip.notes, 0, 1};
}

clip::Features default_features(const clip::Clip& clip) {
    return clip.skeleton ? clip::Features::positions : clip::Features::raw;
}

clip::Axis default_up(const clip::Clip& clip) {
    return clip.skeleton ? clip::up_axis(clip, clip::Axis::automatic) : clip::Axis::automatic;
}

std::int64_t default_first_frame(const clip::Clip& clip) {
    if (!clip.skeleton)
        return 0;
    return clip::tpose_frames(
        clip::features(clip, clip::Features::automatic, default_up(clip)).view());
}

std::string clip_json(const clip::Clip& clip) {
    const ClipFacts facts = clip_facts(clip);
    JsonObject object = json_head("clip");
    object.set("clip", json_clip(&facts, default_features(clip), default_first_frame(clip)));
    object.set("channels", JsonObject("count", clip.values.cols(), "names", clip.channel_names));
    object.set("joints", joints(clip));
    object.set("up_axis", json_axis(default_up(clip)));
    object.set("feature_count", clip::feature_count(clip, clip::Features::automatic));
    return object.text();
}

} // namespace stltsa::capi
