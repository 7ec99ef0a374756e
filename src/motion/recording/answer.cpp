// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/answer.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/checkpoint.hpp"
#include "linalg/simd.hpp"
#include "motion/behaviors/likeness.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/cycles/evidence.hpp"
#include "motion/cycles/sides.hpp"
#include "motion/recording/curve.hpp"

namespace stltsa::motion {
namespace {

/// A recording that begins or ends faster than this share of the usual speed does so in motion.
constexpr double moving = 0.4;
/// Others of a label with which a segment or a repetition is compared.
constexpr std::size_t most_compared = 24;

/// Shared while the answer is assembled.
struct Work {
    const Signal& signal;
    const KernelFeatures& features;
    ConstMatrixView samples;
    Recording result;

    double sample(double row) const {
        return std::min(row * static_cast<double>(signal.step), static_cast<double>(samples.rows));
    }
};

/// The squared motion of each column of the samples.
std::vector<double> energy_of(const Work& work, const Draft& draft) {
    std::vector<double> energy(static_cast<std::size_t>(work.samples.cols));
    const Rows rows = draft.rows();
    const std::int64_t step = work.signal.step;
    for (std::int64_t i = rows.begin; i + 1 < rows.end && (i + 1) * step < work.samples.rows; ++i)
        for (std::int64_t c = 0; c < work.samples.cols; ++c) {
            const double moved = work.samples((i + 1) * step, c) - work.samples(i * step, c);
            energy[static_cast<std::size_t>(c)] += moved * moved;
        }
    return energy;
}

/// How all cycles divide into steps: at the strikes of the other foot, if it is known which foot
/// that is.
Halves halves_of_draft(const Signal& signal, const Draft& draft) {
    const std::vector<Interval> cycles = draft.cycles();
    std::vector<double> middles;
    for (const CyclicStretch& cut : draft.stretches)
        std::ranges::copy(cut.middles, std::back_inserter(middles));
    const int side = draft.stretches.front().side;
    if (side >= 0 && middles.size() == cycles.size())
        return halves_at(middles, cycles);
    return halves_of(signal, cycles, side);
}

void append_cyclic(Work& work, const Draft& draft, Segment& segment) {
    const auto index = static_cast<std::int64_t>(work.result.segments.size());
    const std::vector<double>& motion = work.signal.side;
    std::vector<double> confidences, lengths;
    segment.halves = halves_of_draft(work.signal, draft);
    const bool steps = segment.halves.reason.empty();
    for (const CyclicStretch& cut : draft.stretches) {
        const std::vector<Interval> cycles = cut.cycles();
        const int side = !steps           ? -1
                         : cut.at_strikes ? cut.side
                                          : leading_side(motion, cut.borders);
        const int first = cut.at_strikes ? 1 - side : side; // a strike ends a step of its own foot
        for (std::size_t i = 0; i < cycles.size(); ++i) {
            const Interval& cycle = cycles[i];
            const double begin = work.sample(cycle.begin), end = work.sample(cycle.end);
            if (steps) {
                const double middle = work.sample(
                    cut.middles.empty() ? cycle.begin + segment.halves.first * cycle.length()
                                        : cut.middles[i]);
                const auto number = static_cast<std::int64_t>(work.result.cycles.size());
                work.result.steps.push_back({index, number, begin, middle, first});
                work.result.steps.push_back({index, number, middle, end, 1 - first});
            }
            work.result.cycles.push_back({index, begin, end, side, likeness_of(cut, cycle),
                                          cut.confidences[i], cut.at_strikes});
            lengths.push_back(cycle.length());
        }
        std::ranges::copy(cut.confidences, std::back_inserter(confidences));
    }
    segment.count = static_cast<std::int64_t>(lengths.size());
    segment.period = median(lengths) * static_cast<double>(work.signal.step);
    segment.confidence = mean_of(confidences);
}

void append_repetitions(Work& work, const Draft& draft, Segment& segment) {
    const auto index = static_cast<std::int64_t>(work.result.segments.size());
    const std::size_t count = draft.motions.size();
    const std::size_t stride = (count + most_compared - 1) / most_compared;
    std::vector<double> confidences;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> unlike;
        for (std::size_t k = 0; k < count; k += stride)
            if (k != i)
                unlike.push_back(unlikeness(work.signal, draft.motions[i], draft.motions[k]));
        const double mean = mean_of(unlike);
        confidences.push_back(repetition_confidence(mean));
        work.result.repetitions.push_back({index,
                                           work.sample(static_cast<double>(draft.motions[i].begin)),
                                           work.sample(static_cast<double>(draft.motions[i].end)),
                                           std::clamp(1 - mean, 0.0, 1.0), confidences.back()});
    }
    segment.count = static_cast<std::int64_t>(count);
    segment.confidence = mean_of(confidences);
}

bool moves_at(const Signal& signal, std::int64_t row) {
    const auto at = static_cast<std::size_t>(row);
    return signal.usual[at] > 0 && signal.speed[at] > moving * signal.usual[at];
}

/// Of the first border of draft i.
double border_confidence_of(const std::vector<Draft>& drafts, std::size_t i) {
    const bool rests = drafts[i].kind == SegmentKind::rest;
    const bool after_rest = drafts[i - 1].kind == SegmentKind::rest;
    const auto acts = [&](std::size_t k) {
        return k < drafts.size() && drafts[k].kind == SegmentKind::action ? 1 : 0;
    };
    if (rests)
        return rest_border_confidence(acts(i - 1) + acts(i + 1));
    if (after_rest)
        return rest_border_confidence((i >= 2 ? acts(i - 2) : 0) + acts(i));
    return drafts[i].gain > 0 ? border_confidence(drafts[i].gain, acts(i - 1) + acts(i))
                              : rest_border_confidence(acts(i - 1) + acts(i));
}

void append_segment(Work& work, std::vector<Draft>& drafts, std::size_t i) {
    Draft& draft = drafts[i];
    Segment segment;
    segment.kind = draft.kind;
    segment.begin = work.sample(draft.begin);
    segment.end = work.sample(draft.end);
    segment.label = draft.label;
    segment.reason = draft.reason;
    segment.candidate_period = draft.candidate_period * static_cast<double>(work.signal.step);
    const bool after_hole = i > 0 && drafts[i - 1].is_hole;
    const bool before_hole = i + 1 < drafts.size() && drafts[i + 1].is_hole;
    segment.begin_confidence = i == 0                        ? none
                               : draft.is_hole || after_hole ? 1
                                                             : border_confidence_of(drafts, i);
    const double seconds = (draft.end - draft.begin) / work.signal.rate;
    switch (draft.kind) {
    case SegmentKind::cyclic:
        append_cyclic(work, draft, segment);
        break;
    case SegmentKind::repetitions:
        append_repetitions(work, draft, segment);
        break;
    case SegmentKind::action:
        segment.count = 1;
        segment.confidence = action_confidence(seconds);
        break;
    case SegmentKind::rest:
        segment.confidence = draft.is_hole ? 1 : rest_confidence(seconds);
        break;
    }
    if (draft.kind != SegmentKind::rest) {
        segment.energy = energy_of(work, draft);
        const Rows rows = draft.rows();
        segment.open_begin = (rows.begin <= 0 || after_hole) && moves_at(work.signal, rows.begin);
        segment.open_end =
            (rows.end >= work.signal.rows() || before_hole) && moves_at(work.signal, rows.end - 1);
    }
    work.result.segments.push_back(std::move(segment));
}

void append_unit(Work& work, UnitKind kind, double begin, double end) {
    if (end > begin)
        work.result.units.push_back({kind,
                                     static_cast<std::int64_t>(work.result.segments.size()) - 1,
                                     work.sample(begin), work.sample(end)});
}

/// What a rest is called: before a motion, after the last, or in another posture than home.
using RestKind = std::function<UnitKind(double begin, double end)>;

void append_units(Work& work, const Draft& draft, const RestKind& rest_kind) {
    using enum UnitKind;
    if (draft.kind == SegmentKind::rest) {
        append_unit(work, rest_kind(draft.begin, draft.end), draft.begin, draft.end);
    } else if (draft.kind == SegmentKind::cyclic) {
        const double first = draft.stretches.front().borders.front();
        const double last = draft.stretches.back().borders.back();
        append_unit(work, initial, draft.begin, first);
        append_unit(work, cyclic, first, last);
        append_unit(work, final, last, draft.end);
    } else if (draft.kind == SegmentKind::repetitions) {
        double at = draft.begin;
        for (const Rows& motion : draft.motions) {
            const auto begin = static_cast<double>(motion.begin);
            append_unit(work, rest_kind(at, begin), at, begin);
            at = std::min(draft.end, static_cast<double>(motion.end));
            append_unit(work, action, begin, at);
        }
        append_unit(work, action, at, draft.end);
    } else {
        append_unit(work, action, draft.begin, draft.end);
    }
}

/// The mean likeness of each segment to the others of its label, and of labels to each other.
void set_likeness(Work& work, const std::vector<Draft>& drafts) {
    const Describer describe(work.features);
    std::vector<std::vector<std::size_t>> of_label;
    std::vector<Description> done(drafts.size());
    for (std::size_t i = 0; i < drafts.size(); ++i)
        if (drafts[i].label >= 0) {
            of_label.resize(
                std::max(of_label.size(), static_cast<std::size_t>(drafts[i].label) + 1));
            of_label[static_cast<std::size_t>(drafts[i].label)].push_back(i);
            done[i] = describe(work.features.moments(drafts[i].rows()));
        }
    const auto mean_likeness = [&](std::size_t of, const std::vector<std::size_t>& members) {
        const std::size_t stride = (members.size() + most_compared - 1) / most_compared;
        std::vector<double> like;
        for (std::size_t k = 0; k < members.size(); k += stride)
            if (members[k] != of)
                like.push_back(likeness(done[of], done[members[k]]));
        return like.empty() ? none : mean_of(like);
    };
    const auto labels = static_cast<std::int64_t>(of_label.size());
    work.result.label_likeness = Matrix(labels, labels);
    for (std::int64_t a = 0; a < labels; ++a) {
        checkpoint();
        for (std::int64_t b = 0; b <= a; ++b) {
            const auto& members = of_label[static_cast<std::size_t>(a)];
            const std::size_t stride = (members.size() + most_compared - 1) / most_compared;
            std::vector<double> like;
            for (std::size_t k = 0; k < members.size(); k += stride)
                like.push_back(mean_likeness(members[k], of_label[static_cast<std::size_t>(b)]));
            work.result.label_likeness(a, b) = work.result.label_likeness(b, a) = mean_of(like);
        }
    }
    for (std::size_t i = 0; i < drafts.size(); ++i)
        if (drafts[i].label >= 0)
            work.result.segments[i].likeness =
                mean_likeness(i, of_label[static_cast<std::size_t>(drafts[i].label)]);
}

void append_all(Work& work, std::vector<Draft>& drafts, const RestKind& rest_kind) {
    for (std::size_t i = 0; i < drafts.size(); ++i) {
        append_segment(work, drafts, i);
        append_units(work, drafts[i], rest_kind);
    }
    const auto end = static_cast<double>(work.samples.rows);
    work.result.segments.back().end = end;
    work.result.units.back().end = end;
    set_likeness(work, drafts);
}

/// Of the cyclic segment that lasts longest: the first cycle, and the one most like their mean.
void set_typical(Work& work) {
    const Segment* longest = nullptr;
    for (const Segment& segment : work.result.segments)
        if (segment.kind == SegmentKind::cyclic &&
            (longest == nullptr || segment.end - segment.begin > longest->end - longest->begin))
            longest = &segment;
    const auto& cycles = work.result.cycles;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        if (&work.result.segments[static_cast<std::size_t>(cycles[i].segment)] != longest)
            continue;
        const auto index = static_cast<std::int64_t>(i);
        if (work.result.representative < 0)
            work.result.representative = work.result.best = index;
        else if (cycles[i].likeness > cycles[static_cast<std::size_t>(work.result.best)].likeness)
            work.result.best = index;
    }
}

} // namespace

Recording answer_of(const Context& context, std::vector<Draft> drafts, ConstMatrixView samples,
                    const Options& options) {
    Work work{context.signal, context.features, samples, {}};
    double last = 0;
    for (const Draft& draft : drafts)
        if (draft.kind != SegmentKind::rest)
            last = draft.end;
    const Pauses& pauses = context.pauses;
    const auto kind_of = [&](double begin, double end) {
        for (std::size_t i = 0; i < pauses.rests.size(); ++i)
            if (static_cast<double>(pauses.rests[i].begin) < end &&
                static_cast<double>(pauses.rests[i].end) > begin && !pauses.home[i])
                return UnitKind::hold;
        return begin >= last && last > 0 ? UnitKind::wind_up : UnitKind::preparing;
    };
    append_all(work, drafts, kind_of);
    work.result.curve = curve_of(context.signal, drafts, samples.rows);
    work.result.reason = reason_of(drafts, samples, options);
    if (!options.jump.empty() && work.result.reason.empty())
        work.result.warnings.push_back(
            {WarningCode::jump,
             format_text("the pose jumps at {}: split the clip there, or repair the frame",
                         options.jump),
             options.jump_s, options.jump_s});
    set_typical(work);
    return std::move(work.result);
}

} // namespace stltsa::motion
