// SPDX-License-Identifier: BSD-3-Clause
#include "results/phased.hpp"

#include <cmath>
#include <limits>
#include <map>

#include "clip/features/column_owners.hpp"
#include "clip/features/drift.hpp"

namespace stltsa::results {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Cycles that end and begin closer together, in rows, are back to back.
constexpr double touching = 0.5;
/// Shorter cycles, in rows, have no velocity to speak of.
constexpr double shortest_cycle = 6;

/// Sequences of cycles back to back of each label, in rows.
std::map<std::int32_t, std::vector<phase::Borders>> sequences_of(const Decomposed& decomposed,
                                                                 const ClipFacts& clip) {
    std::map<std::int32_t, std::vector<phase::Borders>> sequences;
    const stltsa_part* before = nullptr;
    for (const stltsa_part& cycle : decomposed.cycle_parts) {
        const double begin = cycle.begin_s * clip.fps - static_cast<double>(clip.first);
        const double end = cycle.end_s * clip.fps - static_cast<double>(clip.first);
        const auto label = decomposed.segments[static_cast<std::size_t>(cycle.segment)].label;
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

void set_frames(const Decomposed& decomposed, Phased& phased) {
    const auto frames = static_cast<std::size_t>(phased.clip.frames);
    phased.phase.assign(frames, none);
    phased.residual.assign(frames, none);
    phased.cycle.assign(frames, -1);
    for (const PhasedMotion& motion : phased.motions) {
        const Matrix both = phase::pose_and_velocity(phased.rows.view(), phased.clip.fps,
                                                     motion.phases.mean.period);
        for (const phase::Run& run : motion.phases.runs) {
            const auto distances = phase::residuals(both.view(), motion.phases.mean, run);
            for (std::int64_t i = 0; i < run.rows(); ++i) {
                const auto frame = static_cast<std::size_t>(phased.clip.first + run.begin + i);
                const double phase = run.phase[static_cast<std::size_t>(i)];
                const double part = phase - std::floor(phase);
                phased.phase[frame] = part < 1 ? part : 0;
                phased.residual[frame] = distances[static_cast<std::size_t>(i)];
            }
        }
    }
    for (std::size_t c = 0; c < decomposed.cycle_parts.size(); ++c)
        for (std::int64_t frame = decomposed.cycle_parts[c].begin;
             frame < decomposed.cycle_parts[c].end; ++frame)
            if (!std::isnan(phased.phase[static_cast<std::size_t>(frame)]))
                phased.cycle[static_cast<std::size_t>(frame)] = static_cast<std::int64_t>(c);
}

} // namespace

Phased find_phase(const clip::Clip& clip, const Decomposed& decomposed,
                  clip::PrepareOptions prepare, const Progress& progress) {
    const SampleFacts& found = decomposed.source.samples;
    if (decomposed.source.clips.size() != 1 ||
        decomposed.source.clips.front().frames != clip.frames() ||
        decomposed.source.clips.front().fps != clip.fps)
        fail(Status::argument,
             "the decomposition is not of this clip: it has {} frames, the clip "
             "{}",
             decomposed.source.clips.front().frames, clip.frames());
    prepare.features = found.features;
    if (found.up != clip::Axis::none)
        prepare.up = found.up;
    prepare.rate = 0;
    prepare.smoothing = 0;
    const clip::Clip* single = &clip;
    ClipSamples prepared = prepare_clips({&single, 1}, prepare, progress);
    clip::remove_drift(prepared.samples, clip.fps);
    Phased phased;
    phased.clip = prepared.source.clips.front();
    phased.samples = prepared.source.samples;
    phased.side = clip::side_weights(clip, found.features, found.up, prepared.samples.view());
    phased.rows = std::move(prepared.samples);
    for (auto& [label, sequences] : sequences_of(decomposed, phased.clip)) {
        phased.motions.push_back(
            {label, phase::find_phases(phased.rows.view(), clip.fps, sequences, phased.side)});
        const phase::Phases& phases = phased.motions.back().phases;
        if (phases.linear)
            phased.warnings.push_back(format_text(
                "the phase of motion {} is linear in time: its frames lie {:.2f} of their variance "
                "from the mean cycle, above 0.4",
                static_cast<char>('A' + label % 26), phases.residual));
    }
    set_frames(decomposed, phased);
    return phased;
}

} // namespace stltsa::results
