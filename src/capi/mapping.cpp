// SPDX-License-Identifier: BSD-3-Clause
#include "capi/mapping.hpp"

#include <algorithm>

namespace stltsa::capi {

const ltsa::Mapping* mapping_of(const stltsa_model& model) {
    if (model.kept.frames.rows() == 0)
        return nullptr;
    std::call_once(model.mapping_asked, [&model] {
        model.mapping.emplace(model.kept.frames.view(), model.model,
                              model.source.period.period * model.source.samples.fps);
    });
    return &*model.mapping;
}

void keep_poses(stltsa_model& model, const clip::Clip& clip) {
    if (!clip.skeleton)
        return;
    const SampleFacts& samples = model.source.samples;
    clip::CodedPoses coded = clip::encode_poses(clip, samples.up);
    Matrix poses(samples.count, coded.code.size());
    for (std::int64_t row = 0; row < samples.count; ++row)
        std::copy_n(coded.vectors.row(samples.first + row * samples.step), poses.cols(),
                    poses.row(row));
    model.kept.code = std::move(coded.code);
    model.kept.poses = std::move(poses);
    model.kept.has_poses = true;
}

Matrix features_of_pose(const stltsa_model& model, ConstMatrixView vector) {
    const SampleFacts& samples = model.source.samples;
    const clip::Clip pose = clip::decode_poses(model.kept.code, vector, samples.fps);
    return clip::pose_features(model.kept.code, pose, samples.features);
}

} // namespace stltsa::capi
