// SPDX-License-Identifier: BSD-3-Clause
#include "results/fitted.hpp"

#include <algorithm>

#include "ltsa/fit.hpp"
#include "ltsa/frames.hpp"
#include "ltsa/warnings.hpp"

namespace stltsa::results {
namespace {

constexpr int standard_dimension = 2;

/// Each clip is a component of its own; more components than clips mean that a clip is cut.
void warn_of_parts(const Source& source, ltsa::Model& model) {
    if (model.components.size() <= model.lengths.size())
        return;
    std::int64_t row = ltsa::first_cut(model);
    std::string cut;
    double cut_s = no_time;
    if (row >= 0 && source.clips.empty())
        cut = format_text("frame {}", row);
    for (std::size_t c = 0; row >= 0 && c < source.clips.size(); row -= model.lengths[c++])
        if (row < model.lengths[c]) {
            const ClipFacts& clip = source.clips[c];
            const std::int64_t frame = clip.first + row * clip.step;
            const std::string of = source.clips.size() > 1 ? format_text(" of clips[{}]", c) : "";
            cut = format_text("frame {}{}", frame, of);
            if (clip.fps > 0)
                cut_s = static_cast<double>(frame) / clip.fps;
        }
    model.warnings.insert(model.warnings.begin(), ltsa::parts_warning(model, cut, cut_s));
}

/// The clips, one after another, as one clip with the skeleton of the first.
clip::Clip joined(Clips clips) {
    const clip::Clip& first = *clips.front();
    std::int64_t frames = 0;
    for (const clip::Clip* clip : clips)
        frames += clip->frames();
    Matrix values(frames, first.values.cols());
    double* to = values.data();
    for (const clip::Clip* clip : clips) {
        const Matrix& from = clip->values;
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

/// Keeps the poses of the clips that the model was fitted to.
void keep_poses(Fitted& fitted, Clips clips) {
    const clip::Axis up = fitted.source.samples.up;
    clip::CodedPoses coded = clips.size() == 1 ? clip::encode_poses(*clips.front(), up)
                                               : clip::encode_poses(joined(clips), up);
    Matrix poses(fitted.source.samples.count, coded.code.size());
    std::int64_t row = 0;
    std::int64_t begin = 0;
    for (std::size_t c = 0; c < clips.size(); ++c) {
        const ClipFacts& facts = fitted.source.clips[c];
        for (std::int64_t i = 0; i < fitted.model.lengths[c]; ++i, ++row)
            std::copy_n(coded.vectors.row(begin + facts.first + i * facts.step), poses.cols(),
                        poses.row(row));
        begin += facts.frames;
    }
    fitted.kept.code = std::move(coded.code);
    fitted.kept.poses = std::move(poses);
    fitted.kept.has_poses = true;
}

} // namespace

Fitted fit(ConstMatrixView samples, const std::vector<std::int64_t>& lengths,
           const FitOptions& options, Source source, const Progress& progress) {
    ltsa::check_frames(samples, lengths, "frames", options.threads);
    const auto parameters =
        choose_parameters(samples, lengths, options, standard_dimension, source, progress);
    Fitted fitted{ltsa::fit(samples, lengths, parameters, progress), std::move(source), {}, {}};
    warn_of_parts(fitted.source, fitted.model);
    return fitted;
}

void keep_clips(Fitted& fitted, Clips clips, Matrix samples) {
    if (clips.front()->skeleton)
        keep_poses(fitted, clips);
    fitted.kept.frames = std::move(samples);
}

Matrix features_of_pose(const Fitted& fitted, ConstMatrixView vector) {
    const SampleFacts& samples = fitted.source.samples;
    const clip::Clip pose = clip::decode_poses(fitted.kept.code, vector, samples.fps);
    return clip::pose_features(fitted.kept.code, pose, samples.features);
}

std::vector<std::int64_t> unbroken_lengths(const ltsa::Model& model) {
    std::vector<std::int64_t> lengths;
    std::size_t row = 0;
    for (const std::int64_t length : model.lengths)
        for (std::int64_t i = 0; i < length; ++i, ++row) {
            if (i == 0 || model.component_of[row] != model.component_of[row - 1])
                lengths.push_back(0);
            ++lengths.back();
        }
    return lengths;
}

EstimatedDimension estimate_dimension(ConstMatrixView samples,
                                      const std::vector<std::int64_t>& lengths,
                                      const FitOptions& options,
                                      const ltsa::DimensionOptions& limits, Source source,
                                      const Progress& progress) {
    ltsa::check_frames(samples, lengths, "frames", options.threads);
    const auto parameters =
        choose_parameters(samples, lengths, options, ltsa::eigengap_tangents, source, progress);
    return {ltsa::intrinsic_dimension(samples, lengths, parameters, limits, progress),
            std::move(source)};
}

} // namespace stltsa::results
