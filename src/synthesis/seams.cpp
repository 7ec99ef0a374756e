// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/seams.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/likeness.hpp"

namespace stltsa::synthesis {
namespace {

/// As a share of the repeated cycle; in seconds if clips join.
constexpr double crossfade_share = 0.1;
constexpr double search_share = 0.1;
constexpr double crossfade_s = 0.15;
constexpr double search_s = 0.5;
/// If clips join, as a share of the shorter cycle: every phase is then within reach, even if each
/// cut can move one way only (at the end of one clip and the beginning of the other).
constexpr double search_of_cycle = 0.5;
/// A difference in velocity counts as the distance that it causes in this share of a cycle.
constexpr double velocity_share = 0.1;
/// Assumed length of a cycle if nothing repeats: about a cycle of gait.
constexpr double usual_cycle_s = 1;

/// The option or the value chosen in its place, in frames.
std::int64_t frames_of(std::optional<double> option, double chosen, double fps) {
    return std::llround(option.value_or(chosen) * fps);
}

/// Whether two tracks have the same motion, such as a clip that was read twice.
bool same_motion(const Track& a, const Track& b) {
    return &a == &b || (a.values.rows() == b.values.rows() &&
                        std::equal(a.values.row(0), a.values.row(a.frames()), b.values.row(0)));
}

/// The shorter of two periods, either of which may be missing.
double shorter(double a, double b) {
    return a > 0 && b > 0 ? std::min(a, b) : std::max(a, b);
}

/// Length of a cycle, given that a repeated piece contains a whole number of them.
double cycle_of(double seconds, double period) {
    return seconds / std::max(1.0, std::round(seconds / period));
}

class Chooser {
  public:
    Chooser(std::span<const Track> tracks, std::span<const Part> parts, const Options& options)
        : tracks_(tracks), parts_(parts), options_(options) {}

    ChosenCut between(const Run& earlier, const Run& later) const {
        if (&earlier == &later)
            return repetition(earlier.first_piece == earlier.last_piece
                                  ? part(earlier.first_piece)
                                  : Part{earlier.track, earlier.begin, earlier.end});
        const bool repeats = earlier.last_piece == later.first_piece;
        return repeats ? repetition(part(earlier.last_piece)) : meeting(earlier, later);
    }

    ChosenCut repetition(const Part& part) const {
        const Track& track = tracks_[part.track];
        const std::int64_t length = part.end - part.begin;
        const double seconds = static_cast<double>(length) / track.fps;
        const double period = part.cycles > 0 ? seconds / static_cast<double>(part.cycles)
                                              : period_near(track, part.begin, part.end);
        const double cycle = cycle_of(seconds, period > 0 ? period : usual_cycle_s);
        const double velocity_s = velocity_share * cycle;
        const Join join{
            &track, &track, part.end, part.begin, length, length, lengths_repeated(length)};
        ChosenCut chosen = choose(join, crossfade_share * cycle, search_share * cycle, velocity_s);
        set_posture(chosen, repetition_distance(track, part.begin, part.end, period, velocity_s));
        return chosen;
    }

  private:
    const Part& part(std::int64_t piece) const { return parts_[static_cast<std::size_t>(piece)]; }

    ChosenCut meeting(const Run& a, const Run& b) const {
        const Track& earlier = tracks_[a.track];
        const Track& later = tracks_[b.track];
        const double period_a = period_near(earlier, a.begin, a.end);
        const double period_b = period_near(later, b.begin, b.end);
        const double cycle = shorter(period_a, period_b);
        const double assumed = cycle > 0 ? cycle : usual_cycle_s;
        const double velocity_s = velocity_share * assumed;
        Join join{&earlier, &later, a.end, b.begin, a.end - a.begin, b.end - b.begin, {}};
        if (same_motion(earlier, later))
            join.lengths = lengths_left_out(a.end - b.begin, assumed * earlier.fps);
        const double search = std::max(search_s, search_of_cycle * cycle);
        ChosenCut chosen = choose(join, crossfade_s, search, velocity_s);
        set_posture(chosen, (repetition_distance(earlier, a.begin, a.end, period_a, velocity_s) +
                             repetition_distance(later, b.begin, b.end, period_b, velocity_s)) /
                                2);
        return chosen;
    }

    ChosenCut choose(const Join& join, double crossfade, double search, double velocity_s) const {
        const double fps = join.earlier->fps;
        const CutOptions options{frames_of(options_.search, search, fps),
                                 frames_of(options_.crossfade, crossfade, fps), velocity_s};
        return {find_cut(join, options), options.crossfade, 0};
    }

    static void set_posture(ChosenCut& chosen, double common) {
        chosen.posture = chosen.cut.distance > 0 ? chosen.cut.distance / common : 0;
    }

    std::span<const Track> tracks_;
    std::span<const Part> parts_;
    const Options& options_;
};

} // namespace

std::vector<ChosenCut> choose_cuts(std::span<const Track> tracks, std::span<const Part> parts,
                                   std::span<const Run> runs, const Options& options) {
    const Chooser chooser(tracks, parts, options);
    std::vector<ChosenCut> cuts;
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
        const bool same_as_before = i > 0 && runs[i - 1].last_piece == runs[i].first_piece &&
                                    runs[i].last_piece == runs[i + 1].first_piece &&
                                    runs[i].first_piece == runs[i].last_piece;
        cuts.push_back(same_as_before ? cuts.back() : chooser.between(runs[i], runs[i + 1]));
    }
    if (options.loop)
        cuts.push_back(parts.size() == 1 && !cuts.empty()
                           ? cuts.back()
                           : chooser.between(runs.back(), runs.front()));
    return cuts;
}

ChosenCut repetition_cut(const Track& track, const Part& part, const Options& options) {
    return Chooser({&track, 1}, {&part, 1}, options).repetition(part);
}

} // namespace stltsa::synthesis
