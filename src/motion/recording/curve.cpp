// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/curve.hpp"

#include <algorithm>
#include <cmath>

#include "motion/curve/drift.hpp"

namespace stltsa::motion {
namespace {

/// The share of drift is near 0 for poses without their path through space, which return to where
/// they were, and near 1 for a body that walks through space.
constexpr double much_drift = 0.5;

/// Writes curve and partner of a stretch at the samples between its first and last place.
void trace(const Signal& signal, const PhaseCurve& phase, Curve& shown) {
    const auto step = static_cast<double>(signal.step);
    const std::int64_t samples = shown.coords.rows();
    auto i = static_cast<std::int64_t>(std::ceil(phase.places.front() * step));
    std::size_t k = 0;
    for (; i < samples && static_cast<double>(i) <= phase.places.back() * step; ++i) {
        const double row = static_cast<double>(i) / step;
        while (k + 2 < phase.places.size() && phase.places[k + 1] < row)
            ++k;
        const double part = (row - phase.places[k]) / (phase.places[k + 1] - phase.places[k]);
        const auto between = [&](const std::vector<double>& values) {
            return (1 - part) * values[k] + part * values[k + 1];
        };
        shown.curve[static_cast<std::size_t>(i)] = shown.coords(i, 0) = between(phase.curve);
        shown.coords(i, 1) = between(phase.partner);
    }
}

const Draft* longest_cyclic(const std::vector<Draft>& drafts) {
    const Draft* longest = nullptr;
    for (const Draft& draft : drafts)
        if (draft.kind == SegmentKind::cyclic &&
            (longest == nullptr || draft.end - draft.begin > longest->end - longest->begin))
            longest = &draft;
    return longest;
}

} // namespace

Curve curve_of(const Signal& signal, const std::vector<Draft>& drafts, std::int64_t samples) {
    Curve shown;
    shown.parameters.neighbors = shown.parameters.window = shown.parameters.dimension = 0; // no fit
    shown.coords = Matrix(samples, 2);
    shown.curve.assign(static_cast<std::size_t>(samples), 0);
    for (const Draft& draft : drafts)
        for (const CyclicStretch& cut : draft.stretches)
            if (cut.phase.places.size() > 1)
                trace(signal, cut.phase, shown);
    const Draft* longest = longest_cyclic(drafts);
    if (longest == nullptr)
        return shown;
    const CyclicStretch& cut = longest->stretches.front();
    const ltsa::Model& fit = cut.phase.fit;
    if (cut.phase.coordinate > 0)
        shown.parameters = fit.parameters;
    shown.coordinate = cut.phase.coordinate;
    shown.cyclicity = cut.phase.typical_cyclicity();
    if (!fit.components.empty()) {
        shown.eigenvalues = fit.components.front().eigenvalues;
        shown.residual = fit.components.front().residual;
        shown.error_estimate = fit.components.front().error_estimate;
    }
    shown.lag_quality = cut.stretch.quality;
    shown.period = cut.period() * static_cast<double>(signal.step);
    return shown;
}

std::string reason_of(const std::vector<Draft>& drafts, ConstMatrixView samples,
                      const Options& options) {
    const Draft* best = nullptr;
    for (const Draft& draft : drafts) {
        if (draft.kind == SegmentKind::cyclic || draft.kind == SegmentKind::repetitions)
            return {};
        if (draft.kind == SegmentKind::action &&
            (best == nullptr || draft.best_match > best->best_match))
            best = &draft;
    }
    if (best == nullptr)
        return "no period: nothing moves";
    std::string reason = drafts.size() == 1
                             ? "no period: " + best->reason
                             : "no segment repeats; of the most regular one: " + best->reason;
    if (!options.jump.empty())
        reason += format_text("; the pose jumps at {}: split the clip there, or repair the frame",
                              options.jump);
    else if (const double share = drift_share(samples); options.in_space && share > much_drift)
        reason += format_text(
            "; {:.0f} % of the variance is a linear drift, which hides any repetition: subtract "
            "the body's position, or set option features to points (markers, three columns each) "
            "or, if the clip has a skeleton, to positions",
            100 * share);
    return reason;
}

} // namespace stltsa::motion
