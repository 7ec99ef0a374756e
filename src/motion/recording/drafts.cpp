// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/drafts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "base/checkpoint.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/recording/repetition_ends.hpp"

namespace stltsa::motion {
namespace {

/// Motion beside a cyclic stretch belongs to it if it is shorter than this, or than a period.
constexpr double least_motion_s = 1;
/// Claimed stretches are one segment if the motion between them is shorter than this.
constexpr double most_gap_periods = 2;
/// Least length of a piece that a change of behavior cuts off a motion.
constexpr double least_piece_s = 0.8;
/// Actions up to this long beside cycles belong to them.
constexpr double longest_absorbed_s = 1.5;
/// Motion in a pause between repetitions is shorter than this share of them.
constexpr double most_of_pause = 0.5;
/// A motion is several of a group if it is so many times as long, and their mean unlikeness to its
/// members is less; each ends where the body is slowest within this share of its length.
constexpr double least_times = 1.5;
constexpr double most_times = 6.5;
constexpr double most_unlike = 0.35;
constexpr double slowest_within = 0.25;
constexpr std::size_t members_compared = 5;
constexpr std::size_t groups_compared = 8;
/// A lag that matches less is not worth a message.
constexpr double least_match = 0.2;

bool rest_between(const std::vector<Rows>& rests, double begin, double end) {
    return std::ranges::any_of(rests, [&](const Rows& rest) {
        return static_cast<double>(rest.begin)<end&& static_cast<double>(rest.end)> begin;
    });
}

/// The row where the cyclic segment begins: at a rest, or where its stretch does, or at `limit` if
/// little is left before it.
double begin_of(const CyclicStretch& cut, const std::vector<Rows>& rests, double limit,
                double rate) {
    const double first = cut.borders.front();
    const double period = cut.period();
    double begin = limit;
    for (const Rows& rest : rests)
        if (static_cast<double>(rest.end) <= first && static_cast<double>(rest.end) > begin)
            begin = static_cast<double>(rest.end);
    const double reach =
        std::max(begin, std::min(static_cast<double>(cut.growth.run.begin), first - period));
    return reach - begin < std::max(least_motion_s * rate, period) ? begin : reach;
}

double end_of(const CyclicStretch& cut, const std::vector<Rows>& rests, double limit, double rate) {
    const double last = cut.borders.back();
    const double period = cut.period();
    double end = limit;
    for (const Rows& rest : rests)
        if (static_cast<double>(rest.begin) >= last && static_cast<double>(rest.begin) < end)
            end = static_cast<double>(rest.begin);
    const double reach =
        std::min(end, std::max(static_cast<double>(cut.growth.run.end()), last + period));
    return end - reach < std::max(least_motion_s * rate, period) ? end : reach;
}

/// The cyclic segments of a part.
void append_cyclic(const Signal& signal, const Part& part, const std::vector<Rows>& rests,
                   std::vector<Draft>& drafts) {
    std::vector<const CyclicStretch*> claimed;
    for (const CyclicStretch& cut : part.stretches)
        if (cut.claimed())
            claimed.push_back(&cut);
    auto limit = static_cast<double>(part.rows.begin);
    bool first = true;
    for (std::size_t i = 0; i < claimed.size(); ++i) {
        const CyclicStretch& cut = *claimed[i];
        const double next = i + 1 < claimed.size() ? claimed[i + 1]->borders.front()
                                                   : static_cast<double>(part.rows.end);
        if (!first) {
            Draft& before = drafts.back();
            const double gap = cut.borders.front() - before.stretches.back().borders.back();
            if (gap < most_gap_periods * cut.period() &&
                !rest_between(rests, before.stretches.back().borders.back(), cut.borders.front()) &&
                may_follow(before.stretches.back(), cut)) {
                before.stretches.push_back(cut);
                before.end = end_of(cut, rests, next, signal.rate);
                limit = before.end;
                continue;
            }
        }
        Draft draft;
        draft.kind = SegmentKind::cyclic;
        draft.begin = begin_of(cut, rests, limit, signal.rate);
        draft.end = end_of(cut, rests, next, signal.rate);
        draft.stretches = {cut};
        draft.candidate_period = cut.stretch.other_period;
        draft.gain = draft.begin <= static_cast<double>(part.rows.begin) ? part.gain : 0;
        limit = draft.end;
        first = false;
        drafts.push_back(std::move(draft));
    }
}

/// The rows outside the drafts, which are ascending.
std::vector<Rows> outside(const std::vector<Draft>& drafts, std::int64_t rows) {
    std::vector<Rows> ranges;
    std::int64_t at = 0;
    for (const Draft& draft : drafts) {
        const auto begin = static_cast<std::int64_t>(std::lround(draft.begin));
        if (begin > at)
            ranges.push_back({at, begin});
        at = std::max(at, static_cast<std::int64_t>(std::lround(draft.end)));
    }
    if (at < rows)
        ranges.push_back({at, rows});
    return ranges;
}

void set_reason(const Signal& signal, const std::vector<Part>& parts, Draft& draft) {
    for (const Part& part : parts) {
        if (static_cast<double>(part.rows.begin) >= draft.end ||
            static_cast<double>(part.rows.end) <= draft.begin)
            continue;
        draft.best_match = std::max(draft.best_match, part.best_match);
        for (const CyclicStretch& cut : part.stretches)
            if (!cut.claimed() && static_cast<double>(cut.stretch.rows.begin) < draft.end &&
                static_cast<double>(cut.stretch.rows.end) > draft.begin) {
                draft.reason = cut.doubt;
                draft.candidate_period = cut.stretch.period[cut.stretch.period.size() / 2];
                return;
            }
        if (part.best_match >= least_match) {
            draft.candidate_period = part.best_lag_s * signal.rate;
            draft.reason = format_text("the motion does not repeat back to back: it resembles "
                                       "itself most after {:.2f} s, with a "
                                       "quality of {:.2f} (1: it repeats)",
                                       part.best_lag_s, part.best_match);
        }
    }
    if (draft.reason.empty())
        draft.reason = format_text("the motion does not repeat at any lag within {:.2f} s",
                                   (draft.end - draft.begin) / signal.rate);
}

/// The motion, cut where the behavior changes within it.
std::vector<Rows> pieces_of(const Signal& signal, const std::vector<Part>& parts, Rows motion) {
    const auto least = static_cast<std::int64_t>(least_piece_s * signal.rate);
    std::vector<Rows> pieces;
    std::int64_t at = motion.begin;
    for (const Part& part : parts)
        if (part.rows.begin >= at + least && part.rows.begin <= motion.end - least) {
            pieces.push_back({at, part.rows.begin});
            at = part.rows.begin;
        }
    pieces.push_back({at, motion.end});
    return pieces;
}

struct Motions {
    std::vector<Rows> rows;
    std::vector<int> groups;
    std::vector<bool> whole; ///< between pauses; else a piece

    /// Whether another motion of its group is whole: pieces of other behaviors are alike as well,
    /// such as arms that fall after each wave.
    bool known(std::size_t i) const {
        for (std::size_t k = 0; k < groups.size(); ++k)
            if (k != i && groups[k] == groups[i] && whole[k])
                return true;
        return false;
    }
};

bool between_pauses(const Signal& signal, const Pauses& pauses, Rows motion) {
    const auto begins = [&](std::int64_t row) {
        return std::ranges::find(pauses.rests, row, &Rows::begin) != pauses.rests.end();
    };
    const auto ends = [&](std::int64_t row) {
        return std::ranges::find(pauses.rests, row, &Rows::end) != pauses.rests.end();
    };
    return (motion.begin == 0 || ends(motion.begin)) &&
           (motion.end == signal.rows() || begins(motion.end));
}

/// The motion as `count` repetitions with pauses so short that no rest was seen: cut where the body
/// is slowest near equal parts. Empty if one is unlike the members of the group.
std::vector<Rows> as_repetitions(const Signal& signal, Rows motion, std::int64_t count,
                                 const std::vector<Rows>& members) {
    std::vector<Rows> parts;
    const double length = static_cast<double>(motion.count()) / static_cast<double>(count);
    std::int64_t at = motion.begin;
    for (std::int64_t k = 1; k <= count; ++k) {
        std::int64_t end = motion.end;
        if (k < count) {
            const double place =
                static_cast<double>(motion.begin) + static_cast<double>(k) * length;
            const auto from = static_cast<std::ptrdiff_t>(place - slowest_within * length);
            const auto to = static_cast<std::ptrdiff_t>(place + slowest_within * length);
            end = std::min_element(signal.speed.begin() + from, signal.speed.begin() + to) -
                  signal.speed.begin();
        }
        parts.push_back({at, end});
        at = end;
    }
    const bool alike = std::ranges::all_of(parts, [&](const Rows& part) {
        double sum = 0;
        for (const Rows& member : members)
            sum += unlikeness(signal, member, part);
        return sum < most_unlike * static_cast<double>(members.size());
    });
    return alike ? parts : std::vector<Rows>();
}

struct Group {
    int id = 0;
    std::size_t count = 0;
    double length = 0;         ///< median, rows
    std::vector<Rows> members; ///< the first ones
};

/// The largest groups of several motions.
std::vector<Group> largest_groups(const Motions& motions) {
    std::vector<std::vector<Rows>> all;
    for (std::size_t i = 0; i < motions.rows.size(); ++i) {
        const auto id = static_cast<std::size_t>(motions.groups[i]);
        all.resize(std::max(all.size(), id + 1));
        all[id].push_back(motions.rows[i]);
    }
    std::vector<Group> groups;
    for (std::size_t id = 0; id < all.size(); ++id) {
        if (all[id].size() < 2)
            continue;
        std::vector<double> lengths;
        for (const Rows& rows : all[id])
            lengths.push_back(static_cast<double>(rows.count()));
        const std::size_t size = all[id].size();
        all[id].resize(std::min(size, members_compared));
        groups.push_back({static_cast<int>(id), size, median(lengths), all[id]});
    }
    std::ranges::stable_sort(groups, std::greater<>(), &Group::count);
    groups.resize(std::min(groups.size(), groups_compared));
    return groups;
}

/// The motion as several of a larger group, or nothing.
std::vector<Rows> split_by_group(const Signal& signal, Rows motion, int own, std::size_t like,
                                 const std::vector<Group>& groups) {
    for (const Group& group : groups) {
        const double times = static_cast<double>(motion.count()) / group.length;
        if (group.id == own || group.count <= like || times < least_times || times > most_times)
            continue;
        for (const double count : {std::floor(times), std::ceil(times)})
            if (count >= 2)
                if (auto parts = as_repetitions(signal, motion, static_cast<std::int64_t>(count),
                                                group.members);
                    !parts.empty())
                    return parts;
    }
    return {};
}

/// Motions between pauses. One that is like no other may be several of a group; otherwise it is cut
/// where the behavior changes: no pause may lie between the last repetition of one action and the
/// first of the next.
Motions grouped_motions(const Signal& signal, const std::vector<Part>& parts, const Pauses& pauses,
                        const std::vector<Rows>& ranges) {
    Motions whole{find_motions(signal, pauses, ranges), {}, {}};
    whole.groups = group_motions(signal, whole.rows);
    const std::vector<Group> groups = largest_groups(whole);
    std::vector<std::size_t> counts;
    for (const int group : whole.groups) {
        counts.resize(std::max(counts.size(), static_cast<std::size_t>(group) + 1));
        ++counts[static_cast<std::size_t>(group)];
    }
    Motions cut;
    for (std::size_t i = 0; i < whole.rows.size(); ++i) {
        checkpoint();
        const std::size_t like = counts[static_cast<std::size_t>(whole.groups[i])];
        std::vector<Rows> pieces =
            split_by_group(signal, whole.rows[i], whole.groups[i], like, groups);
        if (pieces.empty())
            pieces = like > 1 ? std::vector<Rows>{whole.rows[i]}
                              : pieces_of(signal, parts, whole.rows[i]);
        std::ranges::copy(pieces, std::back_inserter(cut.rows));
        cut.whole.resize(cut.rows.size(),
                         pieces.size() == 1 && between_pauses(signal, pauses, whole.rows[i]));
    }
    cut.groups =
        cut.rows.size() == whole.rows.size() ? whole.groups : group_motions(signal, cut.rows);
    return cut;
}

/// The price of the border at the row; 0: there is none.
double gain_at(const std::vector<Part>& parts, std::int64_t row) {
    const auto part = std::ranges::find(parts, row, [](const Part& p) { return p.rows.begin; });
    return part == parts.end() ? 0 : part->gain;
}

/// Actions and repetitions outside the cyclic segments.
void append_motions(const Signal& signal, const std::vector<Part>& parts, const Pauses& pauses,
                    const std::vector<Rows>& ranges, std::vector<Draft>& drafts) {
    const Motions motions = grouped_motions(signal, parts, pauses, ranges);
    const auto one_range = [&](const Rows& a, const Rows& b) {
        return std::ranges::any_of(ranges, [&](const Rows& range) {
            return range.begin <= a.begin && b.end <= range.end;
        });
    };
    for (std::size_t i = 0; i < motions.rows.size();) {
        // What is much shorter than the motion that is repeated, such as a step back, is part of
        // the pause.
        const Rows first = motions.rows[i];
        Draft draft;
        draft.motions = {first};
        std::size_t end = i + 1;
        for (std::size_t next = end;
             next < motions.rows.size() && one_range(first, motions.rows[next]); ++next) {
            if (motions.groups[next] == motions.groups[i]) {
                draft.motions.push_back(motions.rows[next]);
                end = next + 1;
            } else if (static_cast<double>(motions.rows[next].count()) >
                       most_of_pause * static_cast<double>(first.count())) {
                break;
            }
        }
        draft.kind = draft.motions.size() > 1 ? SegmentKind::repetitions : SegmentKind::action;
        draft.begin = static_cast<double>(first.begin);
        draft.end = static_cast<double>(motions.rows[end - 1].end);
        draft.gain = gain_at(parts, first.begin);
        draft.group = motions.groups[i];
        draft.known_motion = motions.known(i);
        drafts.push_back(std::move(draft));
        i = end;
    }
}

/// Adds short actions that no rest separates from cycles to them: arms that rise before a wave.
/// Between two cyclic segments, the border is where the body moves least.
void absorb_short(const Signal& signal, std::vector<Draft>& drafts) {
    const double most = longest_absorbed_s * signal.rate;
    const auto cyclic = [&](std::size_t i) {
        return i < drafts.size() && drafts[i].kind == SegmentKind::cyclic;
    };
    for (std::size_t i = 0; i < drafts.size();) {
        const Draft action = drafts[i];
        const bool after = i > 0 && cyclic(i - 1) && drafts[i - 1].end >= action.begin - 0.5;
        const bool before = cyclic(i + 1) && drafts[i + 1].begin <= action.end + 0.5;
        if (action.kind != SegmentKind::action || action.end - action.begin > most ||
            action.known_motion || (!after && !before)) {
            ++i;
            continue;
        }
        double border = after ? action.end : action.begin;
        if (after && before) {
            const Rows rows = action.rows();
            const auto least = std::min_element(signal.speed.begin() + rows.begin,
                                                signal.speed.begin() + rows.end);
            border = static_cast<double>(least - signal.speed.begin());
            drafts[i + 1].gain = std::max(drafts[i + 1].gain, action.gain);
        }
        if (after)
            drafts[i - 1].end = border;
        if (before) {
            drafts[i + 1].begin = border;
            if (!after)
                drafts[i + 1].gain = action.gain;
        }
        drafts.erase(drafts.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Fills what lies between the drafts: with a rest, or, if the body moves, with the drafts beside.
std::vector<Draft> with_rests(std::vector<Draft> drafts, const std::vector<Rows>& rests,
                              double rows) {
    std::vector<Draft> all;
    double at = 0;
    const auto fill = [&](double end) {
        Draft rest;
        rest.kind = SegmentKind::rest;
        rest.begin = at;
        rest.end = end;
        if (end > at && (all.empty() || rest_between(rests, at, end)))
            all.push_back(rest);
        else if (end > at)
            all.back().end = end;
    };
    for (Draft& draft : drafts) {
        if (draft.begin > at && all.empty() && !rest_between(rests, at, draft.begin))
            draft.begin = at;
        fill(draft.begin);
        at = draft.end;
        all.push_back(std::move(draft));
    }
    fill(rows);
    return all;
}

/// Makes neighbors meet at one place: rows that were rounded, or the exact begin of a cyclic one.
void close_gaps(std::vector<Draft>& drafts) {
    for (std::size_t i = 1; i < drafts.size(); ++i) {
        const bool exact =
            drafts[i].kind == SegmentKind::cyclic && drafts[i - 1].kind != SegmentKind::cyclic;
        (exact ? drafts[i - 1].end : drafts[i].begin) = exact ? drafts[i].begin : drafts[i - 1].end;
    }
}

/// The ranges, cut where parts begin. Both are ascending; the parts cover all rows.
std::vector<Rows> within_parts(const std::vector<Rows>& ranges, const std::vector<Part>& parts) {
    std::vector<Rows> cut;
    auto part = parts.begin();
    for (Rows range : ranges)
        while (range.count() > 0) {
            while (part->rows.end <= range.begin)
                ++part;
            cut.push_back({range.begin, std::min(range.end, part->rows.end)});
            range.begin = cut.back().end;
        }
    return cut;
}

} // namespace

Rows Draft::rows() const {
    const auto first = static_cast<std::int64_t>(std::lround(begin));
    return {first, std::max(first + 1, static_cast<std::int64_t>(std::lround(end)))};
}

std::vector<Interval> Draft::cycles() const {
    std::vector<Interval> all;
    for (const CyclicStretch& cut : stretches)
        std::ranges::copy(cut.cycles(), std::back_inserter(all));
    return all;
}

std::vector<Draft> make_drafts(const Signal& signal, const std::vector<Part>& parts,
                               const Pauses& pauses, bool of_shapes) {
    std::vector<Draft> drafts;
    for (const Part& part : parts)
        append_cyclic(signal, part, pauses.rests, drafts);
    const std::size_t cyclic = drafts.size();
    std::vector<Rows> ranges = outside(drafts, signal.rows());
    if (of_shapes)
        ranges = within_parts(ranges, parts);
    append_motions(signal, parts, pauses, ranges, drafts);
    for (std::size_t i = cyclic; i < drafts.size(); ++i)
        set_reason(signal, parts, drafts[i]);
    std::ranges::stable_sort(drafts, {}, &Draft::begin);
    drafts = with_rests(std::move(drafts), pauses.rests, static_cast<double>(signal.rows()));
    absorb_short(signal, drafts);
    find_end_repetitions(signal, drafts);
    close_gaps(drafts);
    return drafts;
}

} // namespace stltsa::motion
