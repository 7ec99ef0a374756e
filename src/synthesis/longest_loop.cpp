// SPDX-License-Identifier: BSD-3-Clause
#include "synthesis/longest_loop.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "synthesis/material.hpp"
#include "synthesis/measures.hpp"
#include "synthesis/seams.hpp"

namespace stltsa::synthesis {
namespace {

constexpr double good_step = 1.2;
/// Ranges of one length that are tried, those with the nearest postures first.
constexpr std::size_t most_of_length = 8;
/// Of very many cycles, not every length is tried: each is shorter than the one before by a cycle
/// or by this share.
constexpr double next_length = 0.03;

struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
    double distance = 0; ///< of the postures at the two ends, squared
};

struct Tried {
    Range range;
    double step = 0;    ///< over the 95th percentile
    double badness = 0; ///< good up to 1
};

class Search {
  public:
    Search(const Track& track, std::span<const CycleFrames> cycles, const Options& options,
           const Progress& progress)
        : track_(track), cycles_(cycles), options_(options), progress_(progress),
          usual_(usual_roughness(track, std::min(track.first, track.frames() - 1), track.frames())),
          follow_(cycles.size(), 1) {
        for (std::size_t i = cycles.size() - 1; i > 0; --i)
            if (cycles[i - 1].end == cycles[i].begin)
                follow_[i - 1] = follow_[i] + 1;
    }

    /// The longest range with a good seam, or the one with the smallest seam.
    Tried longest() const {
        std::optional<Tried> best;
        for (std::size_t count = *std::ranges::max_element(follow_); count > 0;
             count -= shorter_by(count)) {
            for (const Range& range : nearest_of(count)) {
                const Tried found = try_range(range);
                if (!best || found.badness < best->badness)
                    best = found;
            }
            if (best->badness <= 1)
                break;
        }
        return *best;
    }

  private:
    std::int64_t begin(const Range& range) const { return cycles_[range.first].begin; }
    std::int64_t end(const Range& range) const {
        return cycles_[range.first + range.count - 1].end;
    }

    static std::size_t shorter_by(std::size_t count) {
        return std::max<std::size_t>(
            1, static_cast<std::size_t>(next_length * static_cast<double>(count)));
    }

    std::vector<Range> nearest_of(std::size_t count) const {
        std::vector<Range> ranges;
        for (std::size_t first = 0; first + count <= cycles_.size(); ++first) {
            if (follow_[first] < count)
                continue;
            Range range{first, count, 0};
            range.distance = squared_distance(track_, end(range), track_, begin(range), 0);
            ranges.push_back(range);
        }
        std::ranges::sort(ranges, {},
                          [](const Range& r) { return std::pair(r.distance, r.first); });
        ranges.resize(std::min(ranges.size(), most_of_length));
        return ranges;
    }

    Tried try_range(const Range& range) const {
        progress_.report(Stage::synthesis, 0);
        const Part part{0, begin(range), end(range), 1, static_cast<std::int64_t>(range.count)};
        const ChosenCut chosen = repetition_cut(track_, part, options_, progress_);
        const Roughness near = roughness_across(track_, chosen.cut);
        const double step = near.step / usual_.step;
        return {range, step,
                std::max({step / good_step, chosen.posture / visible_posture(options_),
                          near.acceleration / usual_.acceleration / visible_acceleration})};
    }

    const Track& track_;
    std::span<const CycleFrames> cycles_;
    const Options& options_;
    const Progress& progress_;
    Roughness usual_;
    std::vector<std::size_t> follow_; ///< consecutive cycles from each one on
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
                       "smallest seam, with steps of up to {:.2f} times the 95th percentile of the "
                       "clip's (joints relative to the root; limit {})",
                       what, found.step, good_step);
}

} // namespace

LongestLoop longest_loop(const clip::Clip& clip, std::span<const CycleFrames> cycles,
                         const Options& options, const Progress& progress) {
    const Piece whole{&clip, 0, clip.frames(), 1};
    if (cycles.empty())
        return {whole, "no cycle was found: the loop is the whole clip"};
    for (const CycleFrames& cycle : cycles)
        if (cycle.begin < 0 || cycle.begin >= cycle.end || cycle.end > clip.frames())
            fail(Status::argument,
                 "the decomposition has a cycle of frames [{}, {}), and the clip {} frames: it is "
                 "of another clip",
                 cycle.begin, cycle.end, clip.frames());
    const Material material = prepare_material({&whole, 1}, options.up, progress);
    const Tried found = Search(material.tracks[0], cycles, options, progress).longest();
    const auto count = static_cast<std::int64_t>(found.range.count);
    const Piece piece{&clip, cycles[found.range.first].begin,
                      cycles[found.range.first + found.range.count - 1].end, 1, count};
    return {piece, note_of(found, cycles.size())};
}

} // namespace stltsa::synthesis
