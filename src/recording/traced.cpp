// SPDX-License-Identifier: BSD-3-Clause
#include "recording/traced.hpp"

#include <algorithm>
#include <cmath>

namespace stltsa::recording {
namespace {

/// The cyclic segment that lasts longest; null: there is none.
const Draft* longest_cyclic(const std::vector<Draft>& drafts) {
    const Draft* longest = nullptr;
    for (const Draft& draft : drafts)
        if (draft.kind == SegmentKind::cyclic &&
            (longest == nullptr || draft.end - draft.begin > longest->end - longest->begin))
            longest = &draft;
    return longest;
}

/// Writes curve and partner of a stretch at the samples between its first and last place.
void trace(const Signal& signal, const PhaseCurve& phase, motion::Decomposition& shown) {
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
        shown.curve[static_cast<std::size_t>(i)] = shown.coords(i, 0) = shown.loop(i, 0) =
            between(phase.curve);
        shown.coords(i, 1) = shown.loop(i, 1) = between(phase.partner);
    }
}

std::string reason_of(const std::vector<Draft>& drafts) {
    const Draft* best = nullptr;
    bool moves = false;
    for (const Draft& draft : drafts) {
        moves = moves || draft.kind != SegmentKind::rest;
        if (draft.kind == SegmentKind::action &&
            (best == nullptr || draft.best_match > best->best_match))
            best = &draft;
    }
    if (!moves)
        return "no period: nothing moves";
    return best == nullptr ? std::string()
                           : "no segment repeats: the most regular one " + best->reason;
}

} // namespace

motion::Decomposition shown_of(const Signal& signal, const std::vector<Draft>& drafts,
                               motion::Decomposition single, std::int64_t samples) {
    const Draft* longest = longest_cyclic(drafts);
    const bool repeats = std::ranges::any_of(
        drafts, [](const Draft& draft) { return draft.kind == SegmentKind::repetitions; });
    if (longest == nullptr && single.coords.rows() > 0) {
        if (repeats)
            single.reason.clear();
        else if (single.reason.empty()) // cycles of one motion that the segments do not bear out
            single.reason = reason_of(drafts);
        single.period = 0;
        std::erase_if(single.warnings, [](const Warning& warning) { // the segments say it
            return warning.code == WarningCode::separate_motion;
        });
        return single;
    }
    motion::Decomposition shown;
    shown.intrinsic = std::move(single.intrinsic);
    shown.parameters.dimension = 2;
    shown.coords = Matrix(samples, 2);
    shown.loop = Matrix(samples, 2);
    shown.curve.assign(static_cast<std::size_t>(samples), 0);
    if (longest == nullptr) {
        if (!repeats)
            shown.reason = reason_of(drafts);
        return shown;
    }
    for (const Draft& draft : drafts)
        for (const CyclicStretch& cut : draft.stretches)
            if (cut.phase.places.size() > 1)
                trace(signal, cut.phase, shown);
    const CyclicStretch& cut = longest->stretches.front();
    shown.coordinate = 1;
    shown.cyclicity = cut.cyclicity;
    shown.lag_quality = cut.stretch.quality;
    shown.period = cut.period() * static_cast<double>(signal.step);
    shown.parameters.neighbors = shown.parameters.window =
        std::lround(shown.period * 29 / static_cast<double>(samples_per_period));
    return shown;
}

} // namespace stltsa::recording
