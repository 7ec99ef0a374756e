// SPDX-License-Identifier: BSD-3-Clause
#include "results/keep_cycle.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa::results {
namespace {

std::vector<clip::Frames> frames_in(const PhasedMotion& motion) {
    std::vector<clip::Frames> frames;
    for (const motion::Run& run : motion.phases.runs)
        frames.push_back({run.begin, run.end()});
    return frames;
}

/// The features that a stream of the same frames has. Those of points are the clip's, moved and
/// turned: what a stream removes is found without the frames around. Frames of which a stream knows
/// too little keep the features of the clip, which are filled from the frames around.
Matrix streamed(const clip::Body& body, const Matrix& rows) {
    if (!body.skeleton.joints.empty())
        return copied(rows.view());
    clip::FrameFeatures features(body);
    Matrix result = Matrix::unset(rows.rows(), rows.cols());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        if (!features.next(rows.row(i), result.row(i)))
            std::copy_n(rows.row(i), rows.cols(), result.row(i));
    return result;
}

/// In place of what was said of an earlier cycle.
void warn_if_linear(const phase::Phases& phases, Warnings& warnings) {
    std::erase_if(warnings,
                  [](const Warning& each) { return each.code == WarningCode::linear_phase; });
    if (phases.linear)
        warnings.push_back(
            {WarningCode::linear_phase,
             format_text("the phase is linear in time, because the mean cycle leaves {:.2f} of the "
                         "variance of the frames, above {}: streams are followed less surely",
                         phases.residual, phase::most_residual)});
}

} // namespace

void keep_cycle(Fitted& model, const Phased& phased) {
    const PhasedMotion* motion = longest_in_cycles(phased);
    if (motion == nullptr)
        fail(Status::argument, "the clip has no cycles, so a stream has nothing to be compared "
                               "with");
    if (phased.rows.cols() != model.model.features ||
        phased.samples.features != model.source.samples.features)
        fail(Status::shape,
             "the clip has {} features, the model {}: decompose with the same "
             "option features",
             phased.rows.cols(), model.model.features);
    clip::Body body = phased.of->body;
    clip::learn(body, phased.rows.view(), frames_in(*motion), phased.of->drifting);
    const Matrix rows = streamed(body, phased.rows);
    model.live.cycle =
        phase::learn_live(rows.view(), phased.clip.fps, motion->phases, phased.of->drifting);
    model.live.body = std::move(body);
    warn_if_linear(motion->phases, model.model.warnings);
    model.live.label = static_cast<std::int32_t>(motion->label);
    model.live.marks.clear();
    model.live.has_cycle = true;
}

void keep_mark(Fitted& model, const Phased& phased, double frame, const std::string& name) {
    if (!model.live.has_cycle)
        fail(Status::argument, "the model has no mean cycle: keep it first");
    if (name.empty())
        fail(Status::argument, "the mark at frame {} has no name", frame);
    if (model.live.marks.size() == phase::most_marks)
        fail(Status::argument, "a model has at most {} marks", phase::most_marks);
    const double row = frame - static_cast<double>(phased.clip.first);
    for (const PhasedMotion& motion : phased.motions) {
        if (motion.label != model.live.label || !motion.phases.cyclic)
            continue;
        for (const motion::Run& run : motion.phases.runs) {
            if (!(row >= static_cast<double>(run.begin) &&
                  row <= static_cast<double>(run.end() - 1)))
                continue;
            const double phase = run.phase_at(row);
            model.live.marks.push_back({name, phase - std::floor(phase)});
            return;
        }
    }
    fail(Status::argument, "the mark at frame {} lies in no cycle of the motion that was kept",
         frame);
}

} // namespace stltsa::results
