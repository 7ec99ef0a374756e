// SPDX-License-Identifier: BSD-3-Clause
#include "motion/decompose.hpp"

#include <cmath>

#include "ltsa/frames.hpp"
#include "motion/coordinate.hpp"
#include "motion/curve/smoothing.hpp"
#include "motion/cycles.hpp"
#include "motion/embedding.hpp"
#include "motion/evidence.hpp"
#include "motion/margins.hpp"
#include "motion/period.hpp"
#include "motion/remarks.hpp"
#include "motion/units.hpp"

namespace stltsa::motion {
namespace {

constexpr std::int64_t least_samples = 4;
/// Sigma of the curve's smoothing as a share of a cycle: removes details below a sixteenth of one.
constexpr double curve_smoothing = 0.06;
/// Assumed length of a cycle if no period is known.
constexpr double usual_cycle_s = 1.2;

void check(ConstMatrixView samples, double fps) {
    ltsa::check_frames(samples, {&samples.rows, 1});
    if (!(fps > 0))
        fail(Status::argument, "the frame rate is {}; it must be positive", fps);
    if (samples.rows < least_samples)
        fail(Status::too_few_frames, "{} samples are too few to decompose; at least {} are needed",
             samples.rows, least_samples);
}

/// The result without an embedding.
Decomposition blank(const Embedding& embedding, const Period& period, std::int64_t samples) {
    Decomposition result;
    result.parameters = embedding.parameters;
    result.lag_quality = period.quality;
    result.intrinsic = embedding.intrinsic;
    result.coords = Matrix(samples, embedding.parameters.dimension);
    result.loop = Matrix(samples, 2);
    result.curve.assign(static_cast<std::size_t>(samples), 0.0);
    return result;
}

/// Sets the coordinates, the curve and the loop for all samples. `break_s`: see break_time.
void show_embedding(const Embedding& embedding, const Coordinate& chosen,
                    const std::optional<Loop>& loop, double cycle, double break_s,
                    Decomposition& result) {
    const std::int64_t samples = result.loop.rows();
    const ltsa::Model& model = embedding.models[chosen.model];
    result.parameters = model.parameters;
    result.coordinate = static_cast<int>(chosen.column) + 1;
    result.coords = extended(model.coords, embedding.span, samples);
    result.curve = smooth(column_of(result.coords.view(), chosen.column), curve_smoothing * cycle);
    result.eigenvalues = model.components.front().eigenvalues;
    result.residual = std::ranges::max(model.components, {}, &ltsa::Component::residual).residual;
    result.error_estimate =
        std::ranges::max(model.components, {}, &ltsa::Component::error_estimate).error_estimate;
    if (!std::isnan(break_s))
        result.warnings.push_back(parts_warning(model, break_s));
    result.warnings.insert(result.warnings.end(), model.warnings.begin(), model.warnings.end());
    if (!loop)
        return;
    const Matrix coords = extended(embedding.models[loop->model].coords, embedding.span, samples);
    for (std::int64_t i = 0; i < samples; ++i) {
        result.loop(i, 0) = coords(i, loop->first);
        result.loop(i, 1) = coords(i, loop->second);
    }
}

void set_cycles(const std::vector<double>& margins, ConstMatrixView samples, double period,
                double fps, const Progress& progress, Decomposition& result) {
    const auto poll = [&] { progress.report(Stage::units, 0); };
    result.period = period;
    result.units =
        cyclic_units(margins, pose_speed(samples, border_smoothing(period, fps), poll), period);
    result.margins = margins;
    result.cycles = cycles_between(margins);
    result.representative = 0;
    result.best = most_typical(result.cycles, samples, progress);
}

/// Decomposes a clip with a period by its most cyclic coordinate (paper, section 3.1). If the
/// evidence for cycles is too weak, result.reason says why.
void decompose_cyclic(const Embedding& embedding, ConstMatrixView samples, const Activity& activity,
                      const Period& period, double fps, const DecomposeOptions& options,
                      const Progress& progress, Decomposition& result) {
    const auto level = activity.levels(embedding.span.first, embedding.span.count);
    const Coordinate chosen =
        choose_coordinate(embedding.models, options.dimension, level, period.samples);
    const auto& model = embedding.models[chosen.model];
    const double break_s = break_time(embedding, model, fps, options.first_s);
    show_embedding(embedding, chosen, choose_loop(embedding.models, level, period.samples),
                   period.samples, break_s, result);
    const auto margins = longest_sequence(find_margins(result.curve, activity), period.samples);
    const Evidence evidence =
        weigh(margins, samples, activity, column_of(result.coords.view(), chosen.column),
              chosen.cyclicity, period, fps, progress.within(Stage::units, 0));
    result.cyclicity = evidence.cyclicity;
    result.lag_quality = evidence.period.quality;
    result.reason =
        model.components.size() > 1 ? disconnected(model, break_s) : doubt(evidence, fps);
    if (result.reason.empty())
        set_cycles(margins, samples, evidence.period.samples, fps, progress, result);
}

/// For a clip without a period: the first coordinate, and the first two for the loop (Fig. 1).
void show_first_coordinate(const Embedding& embedding, double cycle, double fps,
                           const DecomposeOptions& options, Decomposition& result) {
    const std::size_t last = embedding.models.size() - 1;
    const bool loop = embedding.models[last].coords.cols() > 1;
    show_embedding(embedding, {}, loop ? std::optional(Loop{last, 0, 1}) : std::nullopt, cycle,
                   break_time(embedding, embedding.models.front(), fps, options.first_s), result);
}

} // namespace

Decomposition decompose(ConstMatrixView samples, double fps, const DecomposeOptions& options,
                        const Progress& progress) {
    check(samples, fps);
    const Activity activity =
        measure_activity(samples, fps, [&] { progress.report(Stage::features, 1); });
    const Period period = find_period(samples, activity, fps, options.shortest_period,
                                      options.longest_period, progress);
    const double cycle = period.samples > 0 ? period.samples : usual_cycle_s * fps;
    const Embedding embedding =
        embed(samples, fps, moving_span(activity, std::lround(cycle)), period, options, progress);
    progress.report(Stage::units, 0);
    Decomposition result = blank(embedding, period, samples.rows);
    if (!(activity.typical > 0)) {
        result.reason = "no period: nothing moves";
    } else if (embedding.models.empty()) {
        result.reason = embedding.problem;
    } else if (period.samples > 0) {
        decompose_cyclic(embedding, samples, activity, period, fps, options, progress, result);
    } else {
        show_first_coordinate(embedding, cycle, fps, options, result);
        result.reason = no_period(activity, fps, options);
    }
    if (activity.typical > 0)
        report_obstacles(samples, options, result);
    if (!result.reason.empty())
        result.units = action_units(activity, fps);
    warn_about_motions(fps, options.first_s, result);
    progress.report(Stage::units, 1);
    return result;
}

} // namespace stltsa::motion
