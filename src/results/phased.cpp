// SPDX-License-Identifier: BSD-3-Clause
#include "results/phased.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.hpp"
#include "base/progress.hpp"

namespace stltsa::results {
namespace {

/// Cycles that end and begin closer together, in rows, are back to back.
constexpr double touching = 0.5;
/// Shorter cycles, in rows, have no velocity to speak of.
constexpr double shortest_cycle = 6;

/// Sequences of cycles back to back of each label, in rows.
std::map<std::int64_t, std::vector<phase::Borders>> sequences_of(const Decomposed& decomposed,
                                                                 const ClipFacts& clip) {
    std::map<std::int64_t, std::vector<phase::Borders>> sequences;
    const stltsa_part* before = nullptr;
    for (const stltsa_part& cycle : decomposed.cycles) {
        const double begin = cycle.begin_s * clip.fps - static_cast<double>(clip.first);
        const double end = cycle.end_s * clip.fps - static_cast<double>(clip.first);
        const auto label = cycle.label;
        if (end - begin < shortest_cycle) {
            before = nullptr;
            continue;
        }
        auto& of_label = sequences[label];
        const bool goes_on = before != nullptr && before->segment == cycle.segment &&
                             std::abs(begin - of_label.back().back()) < touching;
        if (!goes_on)
            of_label.push_back({begin});
        of_label.back().push_back(end);
        before = &cycle;
    }
    return sequences;
}

/// Whether a side leads in each cycle of the label, so that its halves are the same motion.
bool has_like_halves(const Decomposed& decomposed, std::int64_t label) {
    return std::ranges::all_of(decomposed.cycles, [&](const stltsa_part& cycle) {
        return cycle.side >= 0 || cycle.label != label;
    });
}

/// The repetitions of each label.
std::map<std::int64_t, std::vector<phase::Borders>> repetitions_of(const Decomposed& decomposed,
                                                                   const ClipFacts& clip) {
    std::map<std::int64_t, std::vector<phase::Borders>> repetitions;
    for (const stltsa_part& part : decomposed.repetitions) {
        const double begin = part.begin_s * clip.fps - static_cast<double>(clip.first);
        const double end = part.end_s * clip.fps - static_cast<double>(clip.first);
        const auto label = part.label;
        if (end - begin >= shortest_cycle)
            repetitions[label].push_back({begin, end});
    }
    return repetitions;
}

/// Rows of segments in motion one after another, which no hole interrupts.
std::vector<motion::Range> moving_rows(const Decomposed& decomposed, const Phased& phased) {
    std::vector<motion::Range> ranges;
    const auto row = [&](std::int64_t frame) {
        return std::clamp<std::int64_t>(frame - phased.clip.first, 0, phased.rows.rows());
    };
    for (const stltsa_segment& segment : decomposed.segments) {
        if (segment.kind == STLTSA_SEGMENT_REST)
            continue;
        if (!ranges.empty() && ranges.back().end == row(segment.begin))
            ranges.back().end = row(segment.end);
        else
            ranges.push_back({row(segment.begin), row(segment.end)});
    }
    for (const clip::Frames& hole : phased.of->holes)
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            motion::Range& range = ranges[i];
            if (hole.begin > range.begin && hole.begin < range.end) {
                const motion::Range rest{hole.end, range.end};
                range.end = hole.begin;
                ranges.insert(ranges.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
            }
        }
    return ranges;
}

void set_frames(const Decomposed& decomposed, Phased& phased) {
    const auto frames = static_cast<std::size_t>(phased.clip.frames);
    phased.phase.assign(frames, none);
    phased.residual.assign(frames, none);
    phased.cycle.assign(frames, -1);
    for (const PhasedMotion& motion : phased.motions) {
        if (!motion.phases.cyclic)
            continue;
        for (std::size_t r = 0; r < motion.phases.runs.size(); ++r) {
            const motion::Run& run = motion.phases.runs[r];
            const std::vector<double>& distances = motion.phases.distances[r];
            for (std::int64_t i = 0; i < run.rows(); ++i) {
                const auto frame = static_cast<std::size_t>(phased.clip.first + run.begin + i);
                const double phase = run.phase[static_cast<std::size_t>(i)];
                const double part = phase - std::floor(phase);
                phased.phase[frame] = part < 1 ? part : 0;
                phased.residual[frame] = distances[static_cast<std::size_t>(i)];
            }
        }
    }
    for (std::size_t c = 0; c < decomposed.cycles.size(); ++c)
        for (std::int64_t frame = decomposed.cycles[c].begin; frame < decomposed.cycles[c].end;
             ++frame)
            if (!std::isnan(phased.phase[static_cast<std::size_t>(frame)]))
                phased.cycle[static_cast<std::size_t>(frame)] = static_cast<std::int64_t>(c);
}

void warn_if_linear(const PhasedMotion& motion, Phased& phased) {
    if (motion.phases.linear)
        phased.warnings.push_back(
            {WarningCode::linear_phase,
             format_text("the phase of motion {} is linear in time, because its mean cycle leaves "
                         "{:.2f} of the variance of the frames, above {}",
                         letters_of(motion.label), motion.phases.residual, phase::most_residual)});
}

std::shared_ptr<const Phased> find_phase(const Decomposed& decomposed) {
    const auto found = std::make_shared<Phased>(decomposed.rows);
    Phased& phased = *found;
    report_progress(Stage::features, 1);
    for (auto& [label, sequences] : sequences_of(decomposed, phased.clip)) {
        PhasedMotion& motion = phased.motions.emplace_back();
        motion.label = label;
        motion.like_halves = has_like_halves(decomposed, label);
        motion.phases =
            phase::find_phases(phased.rows.view(), phased.clip.fps, sequences, phased.of->side);
        motion.borders = std::move(sequences);
        warn_if_linear(motion, phased);
    }
    for (auto& [label, repetitions] : repetitions_of(decomposed, phased.clip)) {
        PhasedMotion& motion = phased.motions.emplace_back();
        motion.label = label;
        motion.phases =
            phase::find_phases_of_repetitions(phased.rows.view(), phased.clip.fps, repetitions);
        motion.borders = std::move(repetitions);
        warn_if_linear(motion, phased);
    }
    phased.moving = moving_rows(decomposed, phased);
    set_frames(decomposed, phased);
    return found;
}

} // namespace

motion::Range unbroken(const Phased& phased, const motion::Run& run) {
    motion::Range range{0, phased.rows.rows()};
    for (const clip::Frames& hole : phased.of->holes) {
        if (hole.end <= run.begin)
            range.begin = std::max(range.begin, hole.end);
        else if (hole.begin >= run.end())
            range.end = std::min(range.end, hole.begin);
    }
    return range;
}

const PhasedMotion& motion_of(const Phased& phased, std::int64_t label) {
    // Motions in cycles come first.
    const auto motion = std::ranges::find(phased.motions, label, &PhasedMotion::label);
    if (motion == phased.motions.end())
        fail(Status::argument, "label {} has neither cycles nor repetitions",
             label < 0 ? format_text("{}", label) : letters_of(label));
    return *motion;
}

const PhasedMotion* longest_in_cycles(const Phased& phased, std::optional<std::int64_t> label) {
    const auto frames_of = [](const PhasedMotion& motion) {
        std::int64_t count = 0;
        for (const motion::Run& run : motion.phases.runs)
            count += run.rows();
        return count;
    };
    const PhasedMotion* chosen = nullptr;
    for (const PhasedMotion& motion : phased.motions)
        if (motion.phases.cyclic && (!label || motion.label == *label) &&
            (chosen == nullptr || frames_of(motion) > frames_of(*chosen)))
            chosen = &motion;
    return chosen;
}

std::string no_halves(const PhasedMotion& motion) {
    if (!motion.phases.cyclic)
        return format_text("motion {} has repetitions but no cycles", letters_of(motion.label));
    if (motion.like_halves)
        return "";
    return format_text(
        "the second half of a cycle of motion {} may not mirror the first: only the legs of a "
        "skeleton, or leg points whose names state a side, can show that it does",
        letters_of(motion.label));
}

phase::Turns turns_of(const Phased& phased, const PhasedMotion& motion, std::int64_t samples,
                      double shift) {
    std::int64_t count = 0;
    for (const phase::Borders& borders : motion.borders)
        count += std::ssize(borders) - 1;
    phase::Turns turns{Matrix::unset(count, samples), {}};
    double* to = turns.rows.data();
    const std::int64_t rows = phased.rows.rows();
    for (std::size_t r = 0; r < motion.borders.size(); ++r) {
        const phase::Borders& borders = motion.borders[r];
        const Matrix of_run = phase::times_of(motion.phases.runs[r], borders, samples, shift);
        to = std::copy_n(of_run.data(), of_run.rows() * samples, to);
        for (std::size_t k = 0; k + 1 < borders.size(); ++k)
            turns.repeated.push_back(
                motion.phases.cyclic && borders[k + 1] > static_cast<double>(rows - 1)
                    ? motion::Range{static_cast<std::int64_t>(borders[k]), rows}
                    : motion::Range{});
    }
    return turns;
}

phase::Resampled resample(const Phased& phased, std::int64_t label, ConstMatrixView signals,
                          std::int64_t samples) {
    const PhasedMotion& motion = motion_of(phased, label);
    if (signals.rows != phased.clip.frames)
        fail(Status::shape, "signals has {} rows; the clip has {} frames", signals.rows,
             phased.clip.frames);
    phase::Turns turns = turns_of(phased, motion, samples);
    for (std::int64_t i = 0; i < turns.rows.rows() * turns.rows.cols(); ++i)
        turns.rows.data()[i] += static_cast<double>(phased.clip.first);
    for (motion::Range& rows : turns.repeated)
        rows = {rows.begin + phased.clip.first, rows.end + phased.clip.first};
    phase::Resampled made = phase::resample(signals, std::move(turns));
    made.no_halves = no_halves(motion);
    return made;
}
std::shared_ptr<const Phased> phase_of(const Decomposed& decomposed) {
    PhaseOnce& once = *decomposed.phase;
    {
        const std::lock_guard lock(once.mutex);
        if (once.found)
            return once.found;
    }
    // Not under the lock, because callbacks of the progress may call again.
    auto found = find_phase(decomposed);
    const std::lock_guard lock(once.mutex);
    if (!once.found)
        once.found = std::move(found);
    return once.found;
}

} // namespace stltsa::results
