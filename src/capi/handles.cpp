// SPDX-License-Identifier: BSD-3-Clause
#include "capi/handles.hpp"

#include <algorithm>
#include <cstring>

#include "capi/boundary/guard.hpp"

namespace stltsa::capi {

void check_rate(double fps) {
    if (!(fps >= clip::lowest_fps && fps <= clip::highest_fps))
        fail(Status::argument, "fps is {}; it must be from {:g} to {:g}", fps, clip::lowest_fps,
             clip::highest_fps);
}

std::vector<const clip::Clip*> clips_of(const stltsa_clip* const* clips, std::int64_t count) {
    if (count < 1)
        fail(Status::argument, "count is {}: at least one clip is needed", count);
    const stltsa_clip* const* first = &required(clips, "clips");
    std::vector<const clip::Clip*> all;
    for (std::int64_t c = 0; c < count; ++c) {
        if (first[c] == nullptr)
            fail(Status::argument, "clips[{}] is NULL", c);
        all.push_back(&first[c]->clip);
    }
    return all;
}

const ltsa::Mapping* mapping_of(const stltsa_model& model) {
    if (model.kept.frames.rows() == 0)
        return nullptr;
    // Not std::call_once, which helgrind does not know as synchronization.
    const std::lock_guard lock(model.mapping_mutex);
    const Call unasked({}); // a progress callback that maps would wait for itself
    if (!model.mapping)
        model.mapping.emplace(model.kept.frames.view(), model.model,
                              results::rows_of_period(model.source.period, model.source.samples));
    return &*model.mapping;
}

} // namespace stltsa::capi
