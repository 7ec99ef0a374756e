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

namespace {

/// The clips one after the other, as a clip like the first one.
clip::Clip joined(std::span<const stltsa_clip* const> clips) {
    const clip::Clip& first = clips.front()->clip;
    std::int64_t frames = 0;
    for (const stltsa_clip* clip : clips)
        frames += clip->clip.frames();
    Matrix values(frames, first.values.cols());
    double* to = values.data();
    for (const stltsa_clip* clip : clips) {
        const Matrix& from = clip->clip.values;
        to = std::copy_n(from.data(), from.rows() * from.cols(), to);
    }
    clip::Clip all;
    all.format = first.format;
    all.fps = first.fps;
    all.frame_time = first.frame_time;
    all.skeleton = first.skeleton;
    all.channel_names = first.channel_names;
    all.values = std::move(values);
    return all;
}

} // namespace

void keep_poses(stltsa_model& model, std::span<const stltsa_clip* const> clips) {
    if (!clips.front()->clip.skeleton)
        return;
    const clip::Axis up = model.source.samples.up;
    clip::CodedPoses coded = clips.size() == 1 ? clip::encode_poses(clips.front()->clip, up)
                                               : clip::encode_poses(joined(clips), up);
    Matrix poses(model.source.samples.count, coded.code.size());
    std::int64_t row = 0;
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < clips.size(); ++c) {
        const ClipFacts& facts = model.source.clips[c];
        for (std::int64_t i = 0; i < model.model.lengths[c]; ++i, ++row)
            std::copy_n(coded.vectors.row(begin + facts.first + i * facts.step), poses.cols(),
                        poses.row(row));
        begin += facts.frames;
    }
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
