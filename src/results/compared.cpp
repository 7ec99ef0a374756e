// SPDX-License-Identifier: BSD-3-Clause
#include "results/compared.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/progress.hpp"
#include "clip/body/skeleton.hpp"
#include "phase/lag.hpp"
#include "results/comparison_warnings.hpp"
#include "results/mirror_image.hpp"
#include "results/turning.hpp"

namespace stltsa::results {
namespace {

/// Samples of a lag that are only rounding: any other shift than 0 makes the last sample of a cycle
/// the first one, and a motion differ from itself.
constexpr double rounded_lag = 1e-9;
/// Share of intervals that do not contain the true value.
constexpr double chance = 0.05;

std::string name_of(const Phased& phased, const char* which) {
    return phased.clip.path.empty() ? format_text("the {} clip", which) : phased.clip.path;
}

/// The cyclic motions that may be compared.
std::vector<const PhasedMotion*> candidates(const Phased& phased, std::optional<std::int64_t> label,
                                            const char* which) {
    std::vector<const PhasedMotion*> found;
    for (const PhasedMotion& motion : phased.motions)
        if (motion.phases.cyclic && (!label || motion.label == *label))
            found.push_back(&motion);
    if (found.empty() && label)
        fail(Status::argument, "label {} of {} has no cycles",
             *label < 0 ? format_text("{}", *label) : letters_of(*label), name_of(phased, which));
    if (found.empty())
        fail(Status::no_such_part,
             "{} has no cycles, so it cannot be compared by phase: its decomposition says why",
             name_of(phased, which));
    return found;
}

/// For each cycle, whether it has all its samples.
std::vector<bool> complete(const phase::Resampled& cycles) {
    std::vector<bool> result;
    for (const Matrix& cycle : cycles.each)
        result.push_back(std::none_of(cycle.data(), cycle.data() + cycle.rows() * cycle.cols(),
                                      [](double value) { return std::isnan(value); }));
    return result;
}

phase::Resampled kept(const std::vector<bool>& wanted, phase::Resampled cycles,
                      const std::string& name) {
    if (std::ranges::find(wanted, false) == wanted.end())
        return cycles;
    std::vector<Matrix> each;
    Matrix rows = Matrix::unset(std::ranges::count(wanted, true), cycles.rows.cols());
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (wanted[k]) {
            std::copy_n(cycles.rows.row(static_cast<std::int64_t>(k)), rows.cols(),
                        rows.row(std::ssize(each)));
            each.push_back(std::move(cycles.each[k]));
        }
    if (each.empty())
        fail(Status::too_few_frames, "{} have no cycle without a missing value", name);
    return phase::spread_of(std::move(rows), std::move(each));
}

/// Signals and motion of one clip.
struct ComparedClip {
    const Phased& phased;
    const PhasedMotion& motion;
    Matrix signals; ///< common columns, by row
    const char* which;

    /// `shift`: phase at which samples begin; cycles begin at their borders all the same.
    phase::Resampled cycles(std::int64_t samples, double shift = 0) const {
        auto made = phase::resample(signals.view(), turns_of(phased, motion, samples, shift));
        if (shift != 0)
            made.rows = turns_of(phased, motion, samples).rows;
        return made;
    }
};

/// Removes the horizontal mean of the common points from each frame: the features are relative to
/// the mean of all points of a clip, and the two clips have different points.
void center(const Phased& phased, Matrix& signals) {
    const std::int64_t up = static_cast<std::int64_t>(phased.samples.up) - 1;
    const double points = static_cast<double>(signals.cols()) / 3;
    for (std::int64_t i = 0; i < signals.rows(); ++i)
        for (std::int64_t axis = 0; axis < 3; ++axis) {
            if (axis == up)
                continue;
            double mean = 0;
            for (std::int64_t c = axis; c < signals.cols(); c += 3)
                mean += signals(i, c) / points;
            for (std::int64_t c = axis; c < signals.cols(); c += 3)
                signals(i, c) -= mean;
        }
}

/// Whether the headings of the two may come from different parts of the body.
bool headings_differ(const Phased& first, const Phased& second) {
    if (!in_space(first) || first.samples.up == clip::Axis::none ||
        second.samples.up == clip::Axis::none)
        return false;
    return first.samples.features == clip::Features::points ||
           !clip::same_hierarchy(first.of->body.skeleton, second.of->body.skeleton);
}

phase::Lag lag_of(const phase::Resampled& first, const phase::Resampled& second) {
    return phase::lag_between(phase::once_around(first.mean), phase::once_around(second.mean),
                              (first.mean.rows() - 1) / 2);
}

/// Turns the second body about `axis`, the up axis of the first, to face as the first does.
double turn_second(const phase::Resampled& first, clip::Axis axis, ComparedClip& second) {
    const phase::Resampled other = second.cycles(first.mean.rows());
    const auto up = static_cast<std::int64_t>(axis);
    const Level level{up % 3, (up + 1) % 3, 3};
    const ConstMatrixView to = phase::once_around(first.mean),
                          mean = phase::once_around(other.mean);
    // Lag and turn depend on each other.
    double best = 0, most = likeness_if_turned(to, mean, level);
    for (std::int64_t lag = 1; lag < mean.rows; ++lag) {
        const auto shift = static_cast<double>(lag);
        if (const double like = likeness_if_turned(to, phase::later(mean, shift).view(), level);
            like > most) {
            most = like;
            best = shift;
        }
    }
    return turn_to(to, phase::later(mean, best).view(), level, second.signals);
}

/// Half a cycle later: the second half, then the first.
Matrix half_later(const Matrix& cycle) {
    const ConstMatrixView once = phase::once_around(cycle);
    const Matrix later = phase::later(once, static_cast<double>(once.rows) / 2);
    Matrix result = Matrix::unset(cycle.rows(), cycle.cols());
    std::copy_n(later.data(), later.rows() * later.cols(), result.data());
    std::copy_n(later.data(), later.cols(), result.row(later.rows()));
    return result;
}

/// Root mean square distance of the parts from their center, over the mean cycle.
double size_of(const Matrix& mean) {
    double squares = 0;
    for (std::int64_t s = 0; s < mean.rows(); ++s)
        for (std::int64_t axis = 0; axis < 3; ++axis) {
            double middle = 0, count = 0;
            for (std::int64_t c = axis; c < mean.cols(); c += 3, ++count)
                middle += mean(s, c);
            for (std::int64_t c = axis; c < mean.cols(); c += 3)
                squares += (mean(s, c) - middle / count) * (mean(s, c) - middle / count);
        }
    const std::int64_t parts = mean.cols() / 3;
    return std::sqrt(squares / static_cast<double>(mean.rows() * parts));
}

phase::Quantity cycle_times(const phase::Resampled& cycles, double fps) {
    if (!(fps > 0))
        return {none, std::vector<double>(cycles.each.size(), none)};
    phase::Quantity times;
    const std::int64_t last = cycles.rows.cols() - 1;
    for (std::int64_t k = 0; k < cycles.rows.rows(); ++k) {
        times.deviations.push_back((cycles.rows(k, last) - cycles.rows(k, 0)) / fps);
        times.value += times.deviations.back() / static_cast<double>(cycles.rows.rows());
    }
    for (double& each : times.deviations)
        each -= times.value;
    return times;
}

void judge(const phase::Estimate& estimate, Comparison& result) {
    if (!(estimate.error > 0))
        return;
    result.judged += 1;
    result.significant += estimate.significant ? 1 : 0;
}

void set_motion(const ComparedClip& side, ComparedMotion& motion, Comparison& result) {
    motion.clip = side.phased.clip;
    motion.label = side.motion.label;
    const std::string name = name_of(side.phased, side.which);
    for (Warning warning : side.phased.warnings) {
        warning.text = format_text("{}: {}", name, warning.text);
        result.warnings.push_back(std::move(warning));
    }
    warn_of_few(name, motion.cycles, result);
}

Placement placement(const Phased& first, const CommonColumns& columns) {
    Placement placed{in_space(first), first.samples.features == clip::Features::positions,
                     first.samples.up, std::vector<std::int64_t>(columns.names.size(), -1)};
    if (!placed.skeleton)
        return placed;
    const auto& joints = first.of->body.skeleton.joints;
    std::vector<std::int64_t> part_of(joints.size(), -1);
    for (std::size_t c = 0; c < columns.first.size(); ++c) // each joint has three
        part_of[first.of->body.root + static_cast<std::size_t>(columns.first[c] / 3)] =
            columns.part[c];
    for (std::size_t j = first.of->body.root; j < joints.size(); ++j) {
        int parent = joints[j].parent;
        while (parent >= 0 && part_of[static_cast<std::size_t>(parent)] < 0)
            parent = joints[static_cast<std::size_t>(parent)].parent;
        if (part_of[j] >= 0 && parent >= 0)
            placed.parents[static_cast<std::size_t>(part_of[j])] =
                part_of[static_cast<std::size_t>(parent)];
    }
    return placed;
}

/// Compares cycles that are aligned. `fps`: of both.
Comparison compared(phase::Resampled one, phase::Resampled other, std::array<double, 2> fps,
                    CommonColumns columns, bool sides) {
    Comparison result;
    result.sides = sides;
    result.samples = one.mean.rows();
    result.differences = phase::compare(one, other, columns.part, sides);
    result.likeness = result.differences.likeness;
    result.runner_up = result.differences.runner_up;
    result.size_ratio = none;
    result.placement.parents.assign(columns.names.size(), -1);
    const phase::Quantity time = cycle_times(one, fps[0]), other_time = cycle_times(other, fps[1]);
    result.cycle_time =
        phase::estimate(time, other_time, phase::dependence_of(time, other_time, sides));
    for (std::size_t i = 0; i < 2; ++i) {
        phase::Resampled& cycles = i == 0 ? one : other;
        result.motions[i] = {
            {}, 0, std::ssize(cycles.each), std::move(cycles.mean), std::move(cycles.deviation)};
        result.motions[i].clip.fps = fps[i];
    }
    result.columns = std::move(columns);
    for (const phase::PartDifference& part : result.differences.parts) {
        judge(part.lag, result);
        judge(part.amplitude, result);
    }
    checkpoint(); // freeing the cycles of many columns takes long, too
    return result;
}

/// What is known of the clips besides their cycles.
void set_clips(const ComparedClip& first, const ComparedClip& second, Comparison& result) {
    result.features = first.phased.samples.features;
    if (in_space(first.phased) && result.columns.names.size() > 1)
        result.size_ratio = size_of(result.motions[1].mean) / size_of(result.motions[0].mean);
    result.placement = placement(first.phased, result.columns);
    set_motion(first, result.motions[0], result);
    if (result.sides) {
        result.motions[1].clip = result.motions[0].clip;
        result.motions[1].label = result.motions[0].label;
    } else
        set_motion(second, result.motions[1], result);
}

/// Left against right half a cycle later: the second half of each cycle, then its first. Both have
/// the same cycles, with a row for each column that is compared.
Comparison compared_sides(const phase::Resampled& left, const phase::Resampled& right, double fps,
                          CommonColumns columns, const std::string& name) {
    const auto of_all = [&](const phase::Resampled& cycles, const auto& make) {
        std::vector<Matrix> each;
        for (const Matrix& cycle : cycles.each)
            each.push_back(make(cycle));
        return phase::spread_of(copied(cycles.rows.view()), std::move(each));
    };
    auto one =
        of_all(left, [&](const Matrix& of) { return phase::chosen(of.view(), columns.first); });
    auto other = of_all(right, [&](const Matrix& of) {
        return half_later(phase::chosen(of.view(), columns.second));
    });
    std::vector<bool> both = complete(one);
    const std::vector<bool> of_right = complete(other);
    for (std::size_t k = 0; k < both.size(); ++k)
        both[k] = both[k] && of_right[k];
    Comparison result =
        compared(kept(both, std::move(one), name), kept(both, std::move(other), name), {fps, fps},
                 std::move(columns), true);
    result.shift = {none, none, none, none, 0.5, none, none, none, false};
    return result;
}

Comparison compared_with(const Phased& first, const PhasedMotion& motion, const Phased& second,
                         const PhasedMotion& other, std::int64_t samples) {
    CommonColumns columns = common_columns(first, second);
    ComparedClip one{first, motion, phase::chosen(first.rows.view(), columns.first), "first"};
    ComparedClip two{second, other, phase::chosen(second.rows.view(), columns.second), "second"};
    if (first.samples.features == clip::Features::points && in_space(first) &&
        columns.left_out.size() + columns.other_left_out.size() > 0) {
        center(first, one.signals);
        center(first, two.signals); // its axes are those of the first
    }
    phase::Resampled of_one = one.cycles(samples);
    const double turn =
        headings_differ(first, second) ? turn_second(of_one, first.samples.up, two) : 0;
    const phase::Lag lag = lag_of(of_one, two.cycles(samples));
    const double zero =
        std::abs(lag.samples) > rounded_lag ? lag.samples / static_cast<double>(samples - 1) : 0;
    Comparison result = compared(std::move(of_one), two.cycles(samples, zero),
                                 {first.clip.fps, second.clip.fps}, std::move(columns), false);
    set_clips(one, two, result);
    result.turn = turn;
    result.shift = result.differences.whole;
    const double shift = zero + result.differences.shift;
    const double rounded = shift - std::round(shift);
    result.shift.low += rounded - result.shift.difference;
    result.shift.high += rounded - result.shift.difference;
    result.shift.difference = rounded;
    return result;
}

} // namespace

double mean_cycle_time(const Comparison& of) {
    return (of.cycle_time.first + of.cycle_time.second) / 2;
}

double expected_by_chance(const Comparison& of) {
    return chance * static_cast<double>(of.judged);
}

Comparison compare(const Phased& first, std::optional<std::int64_t> label, const Phased& second,
                   std::optional<std::int64_t> other_label, std::int64_t samples) {
    report_progress(Stage::units, 0);
    candidates(first, label, "first"); // throws if there are none
    const PhasedMotion& motion = *longest_in_cycles(first, label);
    std::optional<Comparison> best;
    for (const PhasedMotion* other : candidates(second, other_label, "second")) {
        Comparison found = compared_with(first, motion, second, *other, samples);
        if (!best || found.likeness > best->likeness)
            best = std::move(found);
    }
    warn_of_likeness(*best);
    return std::move(*best);
}

Comparison compare_left_right(const clip::Clip& clip, const Phased& phased,
                              std::optional<std::int64_t> label, std::int64_t samples,
                              const clip::PrepareOptions& prepare) {
    candidates(phased, label, "first"); // throws if there are none
    const PhasedMotion& motion = *longest_in_cycles(phased, label);
    check_same_clip(clip, *phased.of);
    if (const std::string reason = no_halves(motion); !reason.empty())
        fail(Status::unsupported, "{}", reason);
    CommonColumns columns = side_columns_of(phased);
    const auto cycles = [&](const Matrix& rows) {
        return resample(phased, motion.label, rows.view(), samples);
    };
    const Matrix image = mirror_image(clip, phased, motion.label, samples, prepare);
    Comparison result =
        compared_sides(cycles(rows_by_frame(phased)), cycles(image), phased.clip.fps,
                       std::move(columns), name_of(phased, "first"));
    const ComparedClip side{phased, motion, {}, "first"};
    set_clips(side, side, result);
    return result;
}

Comparison compare_left_right(const phase::Resampled& cycles, std::span<const std::string> names,
                              double fps) {
    if (!cycles.no_halves.empty())
        fail(Status::unsupported, "{}", cycles.no_halves);
    const std::string name = "the signals";
    Comparison result = compared_sides(cycles, cycles, fps, side_columns_of(names), name);
    warn_of_few(name, result.motions[0].cycles, result);
    return result;
}

} // namespace stltsa::results
