// SPDX-License-Identifier: BSD-3-Clause
// The fields of a model file, in order. One function names them for reading and for writing.
#pragma once

#include <concepts>
#include <type_traits>

#include "results/fitted.hpp"

namespace stltsa::results {

/// T; const if it is written.
template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

/// Threads are left out: they do not change the model.
template <class Archive, Is<ltsa::Parameters> T>
void parameter_fields(Archive& archive, T& p) {
    archive(p.neighbors, p.window, p.dimension, p.mode, p.include_self, p.links, p.exclusion);
}

template <class Archive, Is<ltsa::Model> T>
void embedding_fields(Archive& archive, T& model) {
    parameter_fields(archive, model.parameters);
    archive(model.features, model.lengths, model.coords, model.component_of);
    archive.list(model.components, [](auto& each, auto& c) {
        each(c.frames, c.eigenvalues, c.residual, c.error_estimate, c.gap, c.rank_deficient_windows,
             c.solves);
    });
    archive(model.repeated_frames, model.time_correlation);
    archive.list(model.warnings,
                 [](auto& each, auto& w) { each(w.code, w.text, w.begin_s, w.end_s); });
}

template <class Archive, Is<Source> T>
void source_fields(Archive& archive, T& source) {
    archive.list(source.clips, [](auto& each, auto& clip) {
        each(clip.path, clip.format, clip.frames, clip.fps, clip.notes, clip.first, clip.step);
    });
    auto& s = source.samples;
    archive(s.count, s.first, s.step, s.fps, s.features, s.feature_count, s.up, s.smoothing);
    auto& p = source.period;
    archive(p.period, p.lag_quality, p.shortest, p.longest);
}

template <class Archive, Is<clip::Quaternion> T>
void quaternion_fields(Archive& archive, T& q) {
    archive(q.w, q.x, q.y, q.z);
}

template <class Archive, Is<clip::Skeleton> T>
void skeleton_fields(Archive& archive, T& skeleton) {
    archive(skeleton.fixed_axes, skeleton.asf);
    archive.list(skeleton.joints, [](auto& each, auto& joint) {
        each(joint.name, joint.parent, joint.offset, joint.channels, joint.end_site, joint.adds);
        quaternion_fields(each, joint.axis);
    });
}

template <class Archive, Is<clip::PoseCode> T>
void code_fields(Archive& archive, T& code) {
    archive(code.format);
    skeleton_fields(archive, code.skeleton);
    archive(code.channel_names, code.up, code.frame_time, code.rest, code.root, code.moves);
    archive.list(code.means, [](auto& each, auto& mean) { quaternion_fields(each, mean); });
}

template <class Archive, Is<Kept> T>
void kept_fields(Archive& archive, T& kept) {
    archive(kept.frames, kept.drop_tpose, kept.has_poses);
    code_fields(archive, kept.code);
    archive(kept.poses);
}

template <class Archive, Is<clip::Body> T>
void body_fields(Archive& archive, T& body) {
    archive(body.kind, body.up, body.root, body.inverted, body.usual);
    skeleton_fields(archive, body.skeleton);
    auto& s = body.shape;
    archive(s.rule.width, s.rule.travels, s.rule.turns, s.rule.up);
    archive(s.used, s.mean, s.directions, s.variances, s.rest);
}

template <class Archive, Is<Live> T>
void live_fields(Archive& archive, T& live) {
    archive(live.has_cycle, live.label);
    body_fields(archive, live.body);
    auto& c = live.cycle;
    archive(c.rate, c.period, c.turns_per_second, c.variance, c.typical, c.usual_speed);
    archive(c.weights, c.mean, c.directions, c.places, c.rests, c.whitening);
    archive.list(live.marks, [](auto& each, auto& mark) { each(mark.name, mark.phase); });
}

template <class Archive, Is<Fitted> T>
void model_fields(Archive& archive, T& model) {
    embedding_fields(archive, model.model);
    source_fields(archive, model.source);
    kept_fields(archive, model.kept);
    archive(model.lengths);
    live_fields(archive, model.live);
}

/// Throws Status::format if the fields contradict each other. A checksum does not prove who wrote a
/// file.
void check_model_fields(const Fitted& model);

} // namespace stltsa::results
