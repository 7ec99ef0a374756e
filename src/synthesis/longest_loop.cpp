// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/longest_loop.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/progress.hpp"
#include "synthesis/material.hpp"
#include "synthesis/measures.hpp"
#include "synthesis/seams.hpp"

namespace stltsa::synthesis {
namespace {

constexpr double good_step = 1.2;
/// Ranges of one length that are tried, those with the nearest ends first.
constexpr std::size_t most_of_length = 8;
/// Of these, at most so many are made to see whether they are good.
constexpr std::size_t most_made = 3;
/// Of very many cycles, not every length is tried: each is shorter than the one before by a cycle
/// or by this share.
constexpr double next_length = 0.03;

struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
    double distance = 0; ///< of the two ends, squared
};

struct Tried {
    Range range;
    double step = 0;    ///< over the 95th percentile
    double badness = 0; ///< good up to 1
};

/// Consecutive cycles from each one on.
std::vector<std::size_t> followed(std::span<const CycleFrames> cycles) {
    std::vector<std::size_t> count(cycles.size(), 1);
    for (std::size_t i = cycles.size() - 1; i > 0; --i)
        if (cycles[i - 1].end == cycles[i].begin)
            count[i - 1] = count[i] + 1;
    return count;
}

class Search {
  public:
    Search(const clip::Clip& clip, std::span<const CycleFrames> cycles, const Options& options)
        : clip_(clip), cycles_(cycles), options_(options),
          material_(prepare_material(std::vector{Piece{&clip, 0, clip.frames()}}, options.up)),
          usual_(usual_roughness(track(), std::min(track().first, track().frames() - 1),
                                 track().frames())),
          followed_(followed(cycles)) {
        options_.loop = options_.in_place = true;
    }

    /// The longest range with a good seam, or the one with the smallest seam.
    Tried longest() {
        std::optional<Tried> best;
        for (std::size_t count = *std::ranges::max_element(followed_); count > 0;
             count -= shorter_by(count)) {
            const Tried found = best_of(count);
            if (found.badness <= 1)
                return found;
            if (!best || found.badness < best->badness)
                best = found;
        }
        return *best;
    }

  private:
    const Track& track() const { return material_.tracks[0]; }
    Part part(const Range& range) const {
        return {0, cycles_[range.first].begin, cycles_[range.first + range.count - 1].end, 1,
                static_cast<std::int64_t>(range.count)};
    }

    static std::size_t shorter_by(std::size_t count) {
        return std::max<std::size_t>(
            1, static_cast<std::size_t>(next_length * static_cast<double>(count)));
    }

    /// What the root's height adds to the squared distance of the two ends, since all joints have
    /// it.
    double squared_climb(const Part& frames) const {
        const auto up = static_cast<std::size_t>(material_.body.up());
        const std::int64_t joints = track().postures.cols() / 3;
        const double climb =
            track().root(frames.end - 1).position[up] - track().root(frames.begin).position[up];
        return static_cast<double>(joints) * climb * climb;
    }

    /// The ranges of one length that are tried.
    std::vector<Range> nearest_of(std::size_t count) const {
        std::vector<Range> ranges;
        for (std::size_t first = 0; first + count <= cycles_.size(); ++first) {
            if (followed_[first] < count)
                continue;
            Range range{first, count, 0};
            const Part frames = part(range);
            range.distance = squared_distance(track(), frames.end, track(), frames.begin, 0) +
                             squared_climb(frames);
            ranges.push_back(range);
        }
        std::ranges::sort(ranges, {},
                          [](const Range& r) { return std::pair(r.distance, r.first); });
        ranges.resize(std::min(ranges.size(), most_of_length));
        return ranges;
    }

    /// The good range of one length with the nearest ends, otherwise the one with the smallest
    /// seam.
    Tried best_of(std::size_t count) {
        std::optional<Tried> best;
        std::size_t made = 0;
        for (const Range& range : nearest_of(count)) {
            Tried tried = try_range(range);
            if (tried.badness <= 1 && ++made > most_made)
                continue;
            if (tried.badness <= 1)
                tried.badness = std::max(tried.badness, in_world(range) / good_step);
            if (tried.badness <= 1)
                return tried;
            if (!best || tried.badness < best->badness)
                best = tried;
        }
        return *best;
    }

    Tried try_range(const Range& range) const {
        report_progress(Stage::synthesis, 0);
        const ChosenCut chosen = repetition_cut(track(), part(range), options_);
        const Roughness near = roughness_across(track(), chosen.cut);
        const double step = near.step / usual_.step;
        return {range, step,
                std::max({step / good_step, chosen.posture / visible_posture(options_),
                          near.acceleration / usual_.acceleration / visible_acceleration})};
    }

    /// Postures do not show what the root does: how high it is, and how it moves.
    double in_world(const Range& range) {
        material_.parts = {part(range)};
        const Synthesis made = synthesize(material_, clip_, options_);
        return wrap_step(made.clip, made.seams.back().crossfade);
    }

    const clip::Clip& clip_;
    std::span<const CycleFrames> cycles_;
    Options options_;
    Material material_;
    Roughness usual_;
    std::vector<std::size_t> followed_;
};

std::string range_text(const Range& range, std::size_t all) {
    return range.count == 1 ? format_text("cycle {} of {}", range.first + 1, all)
                            : format_text("cycles {} to {} of {}", range.first + 1,
                                          range.first + range.count, all);
}

std::string note_of(const Tried& found, std::size_t all) {
    const std::string what = range_text(found.range, all);
    if (found.badness <= 1)
        return format_text(
            "the loop is {}: the longest range whose ends meet, with steps of at "
            "most {:.2f} times the 95th percentile of the clip's (joints relative to "
            "the root; limit {})",
            what, found.step, good_step);
    return format_text("the ends of no range of cycles meet well: the loop is {}, which has the "
                       "smallest seam",
                       what);
}

} // namespace

LongestLoop longest_loop(const clip::Clip& clip, std::span<const CycleFrames> cycles,
                         const Options& options) {
    if (cycles.empty())
        return {{&clip, 0, clip.frames()}, "no cycle was found: the loop is the whole clip"};
    for (const CycleFrames& cycle : cycles)
        if (cycle.begin < 0 || cycle.begin >= cycle.end || cycle.end > clip.frames())
            fail(Status::argument,
                 "the decomposition has a cycle of frames [{}, {}), and the clip {} frames: it is "
                 "of another clip",
                 cycle.begin, cycle.end, clip.frames());
    const Tried found = Search(clip, cycles, options).longest();
    const auto count = static_cast<std::int64_t>(found.range.count);
    const Piece piece{&clip, cycles[found.range.first].begin,
                      cycles[found.range.first + found.range.count - 1].end, 1, count};
    return {piece, note_of(found, cycles.size())};
}

} // namespace stltsa::synthesis
