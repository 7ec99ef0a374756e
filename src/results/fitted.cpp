// SPDX-License-Identifier: BSD-3-Clause
#include "results/fitted.hpp"

#include <algorithm>

#include "ltsa/fit.hpp"
#include "ltsa/frames.hpp"
#include "ltsa/warnings.hpp"
#include "motion/period/choose_neighbors.hpp"

namespace stltsa::results {
namespace {

constexpr int standard_dimension = 2;

/// A row as the user knows it.
struct Place {
    std::string text; ///< "frame 120 of clips[1]"
    double seconds = no_time;
};

Place place_of(std::int64_t row, const Source& source, const std::vector<std::int64_t>& lengths) {
    if (source.clips.empty())
        return {format_text("frame {}", row)};
    std::size_t c = 0;
    for (; row >= lengths[c]; ++c)
        row -= lengths[c];
    const ClipFacts& clip = source.clips[c];
    const std::int64_t frame = clip.first + row * clip.step;
    const std::string of = source.clips.size() > 1 ? format_text(" of clips[{}]", c) : "";
    return {format_text("frame {}{}", frame, of),
            clip.fps > 0 ? static_cast<double>(frame) / clip.fps : no_time};
}

/// Each run is a component of its own; more components than runs mean that a run is cut.
void warn_of_parts(const Source& source, const std::vector<std::int64_t>& lengths,
                   ltsa::Model& model) {
    if (model.components.size() <= model.lengths.size())
        return;
    const std::int64_t row = ltsa::first_cut(model);
    const Place cut = row < 0 ? Place() : place_of(row, source, lengths);
    model.warnings.insert(model.warnings.begin(),
                          ltsa::parts_warning(model, cut.text, cut.seconds));
}

/// Names the frames of a run that is too short; ltsa::fit() knows no clips.
void check_runs(ConstMatrixView samples, const Lengths& lengths, const ltsa::Parameters& p,
                const Source& source) {
    if (p.mode == ltsa::Mode::spatial || lengths.runs.size() == lengths.clips.size())
        return;
    std::int64_t begin = 0;
    for (const std::int64_t length : lengths.runs) {
        const std::int64_t distinct = motion::distinct_frames(samples.block(begin, length));
        if (distinct <= p.neighbors)
            fail(Status::too_few_frames,
                 "between two breaks or ends of the clip, from {} to {}, there are {} distinct "
                 "samples, too few for {} neighbors: use fewer neighbors, or leave this stretch of "
                 "the clip out",
                 place_of(begin, source, lengths.clips).text,
                 place_of(begin + length - 1, source, lengths.clips).text, distinct, p.neighbors);
        begin += length;
    }
}

/// Says where neighborhoods end.
void note_breaks(const Lengths& lengths, ltsa::Mode mode, Source& source) {
    if (mode == ltsa::Mode::spatial || source.clips.empty())
        return;
    std::int64_t row = 0, clip_end = 0;
    std::size_t clip = 0;
    for (const std::int64_t length : lengths.runs) {
        if (row == clip_end)
            clip_end += lengths.clips[clip++];
        else
            source.clips[clip - 1].notes.push_back(
                format_text("the clip does not continue at {}: no neighbors in time go beyond",
                            place_of(row, source, lengths.clips).text));
        row += length;
    }
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
        for (std::int64_t i = 0; i < fitted.lengths[c]; ++i, ++row)
            std::copy_n(coded.vectors.row(begin + facts.first + i * facts.step), poses.cols(),
                        poses.row(row));
        begin += facts.frames;
    }
    fitted.kept.code = std::move(coded.code);
    fitted.kept.poses = std::move(poses);
    fitted.kept.has_poses = true;
}

} // namespace

Fitted fit(ConstMatrixView samples, const Lengths& lengths, const FitOptions& options,
           const std::optional<ltsa::DimensionOptions>& intrinsic, Source source) {
    ltsa::check_frames(samples, lengths.clips, "frames", options.threads);
    const auto parameters =
        choose_parameters(samples, lengths.runs, options, standard_dimension, source);
    check_runs(samples, lengths, parameters, source);
    note_breaks(lengths, parameters.mode, source);
    Fitted fitted{
        ltsa::fit(samples, lengths.runs, parameters), std::move(source), {}, lengths.clips, {}};
    warn_of_parts(fitted.source, fitted.lengths, fitted.model);
    if (intrinsic)
        fitted.dimension = ltsa::intrinsic_dimension(samples, lengths.runs, parameters, *intrinsic);
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

} // namespace stltsa::results
