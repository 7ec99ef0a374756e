// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/analyze.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/progress.hpp"
#include "linalg/simd.hpp"
#include "ltsa/frames.hpp"
#include "motion/behaviors/change_points.hpp"
#include "motion/behaviors/repetitions.hpp"
#include "motion/cycles/sides.hpp"
#include "motion/recording/answer.hpp"
#include "motion/recording/holes.hpp"
#include "motion/recording/merging.hpp"

namespace stltsa::motion {
namespace {

constexpr std::int64_t min_samples = 4;
/// Shorter recordings are not searched for changes of behavior.
constexpr double shortest_divided_s = 6;
/// If more segments are wanted, borders are added so many times, more each time: many only divide
/// what is put together again, such as a rest or the change from one motion to the next.
constexpr int most_rounds = 8;

/// As many segments in motion as wanted. `drafts`: with the borders that are found; `joined`: the
/// same, with neighbors of one behavior joined.
std::vector<Draft> fit_number(const KernelFeatures& features, std::int64_t wanted,
                              const std::function<std::vector<Draft>(std::int64_t more)>& drafts_at,
                              std::vector<Draft> joined, std::vector<Draft> drafts) {
    if (moving(joined) >= wanted)
        drafts.swap(joined);
    std::int64_t more = 0, most = moving(drafts);
    for (int round = 0; most < wanted && round < most_rounds; ++round) {
        more += more + wanted - most;
        std::vector<Draft> finer = drafts_at(more);
        if (const std::int64_t found = moving(finer); found > most) {
            most = found;
            drafts.swap(finer);
        }
    }
    if (most < wanted)
        fail(Status::argument,
             "option segments is {}, but only {} segments in motion could be told apart: ask for "
             "at most {}",
             wanted, most, most);
    merge_to(features, wanted, drafts);
    return drafts;
}

/// The holes in rows of the signal.
std::vector<Hole> in_rows(std::vector<Hole> holes, const Signal& signal) {
    for (Hole& hole : holes) {
        hole.begin /= static_cast<double>(signal.step);
        hole.end = std::min(hole.end / static_cast<double>(signal.step),
                            static_cast<double>(signal.rows()));
    }
    std::erase_if(holes, [](const Hole& hole) { return hole.begin > hole.end; });
    return holes;
}

/// The ranges of rows that holes touch, in ascending order and disjoint.
std::vector<Rows> rows_of(const std::vector<Hole>& holes, const Signal& signal) {
    std::vector<Rows> result;
    for (const Hole& hole : holes) {
        const auto begin = static_cast<std::int64_t>(std::floor(hole.begin));
        const auto end = static_cast<std::int64_t>(std::ceil(hole.end));
        if (begin >= signal.rows())
            continue;
        const Rows rows{begin, std::min(signal.rows(), std::max(begin + 1, end))};
        if (!result.empty() && rows.begin <= result.back().end)
            result.back().end = std::max(result.back().end, rows.end);
        else
            result.push_back(rows);
    }
    return result;
}

/// Lets cycles begin at strikes, which are in samples.
void begin_all_at_strikes(const Signal& signal, std::vector<Strikes> strikes,
                          const StillRows& still, std::vector<Draft>& drafts) {
    for (Strikes& of_motion : strikes) {
        for (std::vector<double>* places : {&of_motion.begins, &of_motion.middles})
            for (double& place : *places)
                place /= static_cast<double>(signal.step);
        for (Draft& draft : drafts) {
            if (draft.label != of_motion.label)
                continue;
            Interval within{draft.begin, draft.end};
            for (std::size_t i = 0; i < draft.stretches.size(); ++i) {
                within.end = i + 1 < draft.stretches.size() ? draft.stretches[i + 1].borders.front()
                                                            : draft.end;
                begin_at_strikes(signal, of_motion, within, still, draft.stretches[i]);
                within.begin = draft.stretches[i].borders.back();
            }
        }
    }
}

} // namespace

Recording analyze(ConstMatrixView samples, double fps, const Options& options) {
    ltsa::check_frames(samples, {&samples.rows, 1});
    if (samples.rows < min_samples)
        fail(Status::too_few_frames, "{} samples are too few to decompose; at least {} are needed",
             samples.rows, min_samples);
    if (const int power = ltsa::power_if_tiny(samples); power != 0) {
        Options of_scaled = options;
        of_scaled.size = std::scalbn(options.size, power);
        return analyze(ltsa::scaled(samples, power).view(), fps, of_scaled);
    }
    const double seconds = static_cast<double>(samples.rows) / fps;
    Signal signal = make_signal(samples, fps, options.smoothed_s, options.size);
    if (!options.side.empty()) {
        const double length =
            std::sqrt(dot(options.side.data(), options.side.data(), samples.cols));
        signal.side = side_motion(signal, samples, options.side, length);
        signal.one_side = side_motion(signal, samples, options.one_side, length);
        signal.other_side = side_motion(signal, samples, options.other_side, length);
        signal.forward = options.forward;
        signal.begin_with_side = options.begin_with_side;
    }
    const std::vector<Hole> exact_holes = in_rows(options.holes, signal);
    const std::vector<Rows> holes = rows_of(exact_holes, signal);
    std::vector<Rows> rests = find_rests(signal);
    Pauses pauses = find_pauses(signal, rests);
    add_holes(holes, rests, pauses);
    const StillRows still{rests, pauses.rests, holes};
    report_progress(Stage::units, 0);
    const KernelFeatures features(signal, options.rotations);
    const auto drafts_at = [&](std::int64_t more) {
        const std::vector<Part> parts =
            divide(signal, {seconds > shortest_divided_s ? &features : nullptr, more}, still,
                   options.periods);
        report_progress(Stage::units, 1);
        std::vector<Draft> drafts = make_drafts(signal, parts, pauses, features.of_shapes());
        merge_shapes(features, parts, drafts);
        return drafts;
    };
    std::vector<Draft> found = drafts_at(0), drafts = found;
    set_labels(features, drafts);
    join_neighbors(drafts);
    if (options.segments) {
        drafts =
            fit_number(features, *options.segments, drafts_at, std::move(drafts), std::move(found));
        set_labels(features, drafts);
    }
    divide_at_holes(exact_holes, signal.rate, drafts);
    const Context context{signal, features, pauses};
    if (options.strikes) {
        const Recording first = answer_of(context, drafts, samples, options);
        begin_all_at_strikes(signal, options.strikes(first), still, drafts);
    }
    return answer_of(context, std::move(drafts), samples, options);
}

} // namespace stltsa::motion
