// SPDX-License-Identifier: BSD-3-Clause
#include "results/decomposed.hpp"

#include <cmath>

namespace stltsa::results {
namespace {

/// Maps positions among the working samples to the source file.
class SourceFrames {
  public:
    SourceFrames(const Source& source) : samples_(source.samples), clip_(source.clips.front()) {}

    stltsa_interval interval(double begin, double end, int32_t kind) const {
        const double first = frame(begin);
        const double last = frame(end);
        return {
            std::llround(first), std::llround(last), first / clip_.fps, last / clip_.fps, kind, 0};
    }

    /// Units extend to both ends of the file: dropped frames belong to the first unit, frames after
    /// the last sample to the last one. A unit that rounds to no frame is left out, and its two
    /// neighbors become one unit if they are of one kind.
    std::vector<stltsa_interval> units(const std::vector<motion::Unit>& found) const {
        std::vector<stltsa_interval> units;
        for (const motion::Unit& unit : found) {
            auto next = interval(unit.begin, unit.end, static_cast<int32_t>(unit.kind));
            next.begin = units.empty() ? 0 : units.back().end;
            next.begin_s = units.empty() ? 0 : units.back().end_s;
            if (next.end <= next.begin)
                continue;
            if (!units.empty() && units.back().kind == next.kind) {
                units.back().end = next.end;
                units.back().end_s = next.end_s;
            } else {
                units.push_back(next);
            }
        }
        if (!units.empty()) {
            units.back().end = clip_.frames;
            units.back().end_s = static_cast<double>(clip_.frames) / clip_.fps;
        }
        return units;
    }

  private:
    double frame(double sample) const {
        return static_cast<double>(samples_.first) + sample * static_cast<double>(samples_.step);
    }

    const SampleFacts& samples_;
    const ClipFacts& clip_;
};

void set_messages(const ClipSamples& prepared, motion::DecomposeOptions& options) {
    const double fps = prepared.source.clips.front().fps;
    options.first_s = static_cast<double>(prepared.source.samples.first) / fps;
    options.in_space = prepared.source.samples.features == clip::Features::raw;
    if (prepared.jump > 0) {
        options.jump_s = static_cast<double>(prepared.jump) / fps;
        options.jump = format_text("frame {} ({:.2f} s)", prepared.jump, options.jump_s);
    }
}

} // namespace

Decomposed decompose(const clip::Clip& clip, const clip::PrepareOptions& prepare,
                     motion::DecomposeOptions options, const Progress& progress) {
    const clip::Clip* single = &clip;
    ClipSamples prepared = prepare_clips({&single, 1}, prepare, progress);
    set_messages(prepared, options);
    const double fps = prepared.source.samples.fps;
    Decomposed made{motion::decompose(prepared.samples.view(), fps, options, progress),
                    std::move(prepared.source),
                    {},
                    {}};
    made.source.period = {made.result.period / fps, made.result.lag_quality,
                          options.shortest_period, options.longest_period};
    const SourceFrames frames(made.source);
    made.units = frames.units(made.result.units);
    for (const motion::Cycle& cycle : made.result.cycles)
        made.cycles.push_back(frames.interval(cycle.begin, cycle.end, STLTSA_UNIT_CYCLE));
    return made;
}

} // namespace stltsa::results
