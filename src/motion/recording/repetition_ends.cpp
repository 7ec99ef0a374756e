// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/repetition_ends.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/behaviors/repetitions.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Lengths that are tried, in those of the other repetitions.
constexpr double shortest = 0.75;
constexpr double longest = 1.3;
/// Longer pauses end the repetitions.
constexpr double longest_pause_s = 4;
/// What remains of the other motion.
constexpr double least_left_s = 0.8;
/// Repetitions with which the piece is compared.
constexpr std::size_t most_compared = 5;

double mean_unlikeness(const Signal& signal, const std::vector<Rows>& motions, Rows piece) {
    const std::size_t count = std::min(motions.size(), most_compared);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += unlikeness(signal, motions[i], piece);
    return sum / static_cast<double>(count);
}

/// The rows of the other motion that are free: of its last or first motion, outside its cycles, and
/// leaving some of it.
Rows free_rows(const Signal& signal, const Draft& other, bool at_end) {
    const auto left = static_cast<std::int64_t>(least_left_s * signal.rate);
    Rows free = other.rows();
    if (!other.motions.empty())
        (at_end ? free.begin : free.end) =
            at_end ? other.motions.back().begin : other.motions.front().end;
    (at_end ? free.begin : free.end) += at_end ? left : -left;
    if (!other.stretches.empty()) {
        const auto row = [](double at) { return static_cast<std::int64_t>(std::lround(at)); };
        if (at_end)
            free.begin = std::max(free.begin, row(other.stretches.back().borders.back()));
        else
            free.end = std::min(free.end, row(other.stretches.front().borders.front()));
    }
    return free;
}

/// The piece of the other motion, at its end or its begin, that is most like the repetitions.
std::optional<Rows> find_piece(const Signal& signal, const std::vector<Rows>& motions,
                               const Draft& other, bool at_end) {
    const Rows free = free_rows(signal, other, at_end);
    std::vector<double> lengths;
    for (const Rows& motion : motions)
        lengths.push_back(static_cast<double>(motion.count()));
    const double usual = median(lengths);
    std::optional<Rows> best;
    double least = same_motion;
    for (auto length = static_cast<std::int64_t>(shortest * usual);
         length <= std::min(free.count(), static_cast<std::int64_t>(longest * usual)); ++length) {
        const Rows piece =
            at_end ? Rows{free.end - length, free.end} : Rows{free.begin, free.begin + length};
        if (const double unlike = mean_unlikeness(signal, motions, piece); unlike < least) {
            least = unlike;
            best = piece;
        }
    }
    return best;
}

bool repeats(const Draft& draft) {
    return draft.kind == SegmentKind::repetitions || draft.known_motion;
}

bool is_pause(const Signal& signal, const Draft& draft) {
    return draft.kind == SegmentKind::rest &&
           draft.end - draft.begin < longest_pause_s * signal.rate;
}

/// Whether the other motion may end in a repetition, rather than be one.
bool is_other(const Draft& repetitions, const Draft& other) {
    return other.kind != SegmentKind::rest && other.group != repetitions.group;
}

/// Makes the motions what is left of them.
void shorten(Draft& other, double begin, double end) {
    other.begin = begin;
    other.end = end;
    if (!other.motions.empty()) {
        other.motions.front().begin = std::max(other.motions.front().begin, other.rows().begin);
        other.motions.back().end = std::min(other.motions.back().end, other.rows().end);
    }
}

void add(Draft& to, Rows piece, bool first) {
    to.kind = SegmentKind::repetitions;
    to.motions.insert(first ? to.motions.begin() : to.motions.end(), piece);
    to.begin = static_cast<double>(to.motions.front().begin);
    to.end = static_cast<double>(to.motions.back().end);
    to.gain = first ? 1 : to.gain;
}

} // namespace

void find_end_repetitions(const Signal& signal, std::vector<Draft>& drafts) {
    for (std::size_t i = 0; i < drafts.size(); ++i) {
        if (!repeats(drafts[i]))
            continue;
        if (i >= 2 && is_pause(signal, drafts[i - 1]) && is_other(drafts[i], drafts[i - 2]))
            if (const auto piece = find_piece(signal, drafts[i].motions, drafts[i - 2], true)) {
                add(drafts[i], *piece, true);
                shorten(drafts[i - 2], drafts[i - 2].begin, drafts[i].begin);
                drafts.erase(drafts.begin() + static_cast<std::ptrdiff_t>(i - 1));
                --i;
            }
        if (i + 2 < drafts.size() && is_pause(signal, drafts[i + 1]) &&
            is_other(drafts[i], drafts[i + 2]))
            if (const auto piece = find_piece(signal, drafts[i].motions, drafts[i + 2], false)) {
                add(drafts[i], *piece, false);
                shorten(drafts[i + 2], drafts[i].end, drafts[i + 2].end);
                drafts[i + 2].gain = 1;
                drafts.erase(drafts.begin() + static_cast<std::ptrdiff_t>(i + 1));
            }
    }
}

} // namespace stltsa::motion
