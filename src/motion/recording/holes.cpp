// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/holes.hpp"

#include <algorithm>

namespace stltsa::motion {
namespace {

/// A rest that is longer than its hole by this is a rest of the body as well.
constexpr double least_rest_s = 0.5;

/// The union of overlapping ranges, ascending.
void join_overlapping(std::vector<Rows>& ranges) {
    std::ranges::sort(ranges, {}, &Rows::begin);
    std::vector<Rows> joined;
    for (const Rows& range : ranges) {
        if (!joined.empty() && range.begin <= joined.back().end)
            joined.back().end = std::max(joined.back().end, range.end);
        else
            joined.push_back(range);
    }
    ranges = std::move(joined);
}

/// The part of the draft from `border` on, which is taken from it.
Draft take_end(Draft& draft, double border) {
    Draft rest = draft;
    draft.end = rest.begin = border;
    rest.gain = 0;
    const auto is_before = [border](double begin, double end) { return begin + end < 2 * border; };
    std::erase_if(draft.stretches, [&](const CyclicStretch& cut) {
        return !is_before(cut.borders.front(), cut.borders.back());
    });
    std::erase_if(rest.stretches, [&](const CyclicStretch& cut) {
        return is_before(cut.borders.front(), cut.borders.back());
    });
    const auto motion_is_before = [&](const Rows& rows) {
        return is_before(static_cast<double>(rows.begin), static_cast<double>(rows.end));
    };
    std::erase_if(draft.motions, [&](const Rows& rows) { return !motion_is_before(rows); });
    std::erase_if(rest.motions, motion_is_before);
    for (Draft* part : {&draft, &rest}) {
        const bool lost = part->kind == SegmentKind::cyclic && part->stretches.empty();
        if (lost || (part->kind == SegmentKind::repetitions && part->motions.size() < 2))
            part->kind = SegmentKind::action;
        if (part->kind == SegmentKind::action && part->motions.size() != 1)
            part->motions = {part->rows()};
    }
    return rest;
}

/// Makes the hole a draft between those before the index `after` and the others. Returns its index.
std::size_t insert_hole(std::vector<Draft>& drafts, std::size_t after, const Hole& hole) {
    const auto place = [&] { return drafts.begin() + static_cast<std::ptrdiff_t>(after); };
    for (; after > 0 && drafts[after - 1].begin >= hole.begin; --after)
        drafts.erase(place() - 1);
    while (after < drafts.size() && drafts[after].end <= hole.end)
        drafts.erase(place());
    Draft made;
    made.kind = SegmentKind::rest;
    made.is_hole = true;
    made.reason = nothing_recorded;
    made.begin = hole.begin;
    made.end = hole.end;
    if (after > 0) {
        Draft& before = drafts[after - 1];
        if (!before.stretches.empty()) // cycles may end between two rows
            made.begin = std::max(made.begin, before.stretches.back().borders.back());
        before.end = made.begin;
    }
    if (after < drafts.size())
        drafts[after].begin = made.end;
    drafts.insert(place(), std::move(made));
    return after;
}

/// Gives what is left of a rest beside a hole to the draft beyond it.
void give_away(std::vector<Draft>& drafts, std::size_t rest, bool to_next) {
    const std::size_t to = to_next ? rest + 1 : rest - 1; // wraps below 0
    if (rest >= drafts.size() || to >= drafts.size() || drafts[rest].is_hole ||
        drafts[rest].kind != SegmentKind::rest || drafts[to].is_hole)
        return;
    (to_next ? drafts[to].begin : drafts[to].end) = to_next ? drafts[rest].begin : drafts[rest].end;
    drafts.erase(drafts.begin() + static_cast<std::ptrdiff_t>(rest));
}

} // namespace

void add_holes(const std::vector<Rows>& holes, std::vector<Rows>& rests, Pauses& pauses) {
    if (holes.empty())
        return;
    rests.insert(rests.end(), holes.begin(), holes.end());
    join_overlapping(rests);
    const Pauses before = std::move(pauses);
    pauses = {before.rests, {}};
    pauses.rests.insert(pauses.rests.end(), holes.begin(), holes.end());
    join_overlapping(pauses.rests);
    for (const Rows& pause : pauses.rests) {
        // No motion goes on over a hole, as it does over a pause away from home.
        const auto same = std::ranges::find(before.rests, pause);
        pauses.home.push_back(same == before.rests.end() ||
                              before.home[static_cast<std::size_t>(same - before.rests.begin())]);
    }
}

void divide_at_holes(const std::vector<Hole>& holes, double rate, std::vector<Draft>& drafts) {
    for (const Hole& hole : holes) {
        const double border = (hole.begin + hole.end) / 2;
        const auto at = std::ranges::upper_bound(drafts, border, {}, &Draft::end);
        if (at == drafts.end())
            continue;
        auto after = static_cast<std::size_t>(at - drafts.begin());
        bool is_brief = false; // a rest only because of the hole
        if (at->begin < border) {
            is_brief = at->kind == SegmentKind::rest &&
                       at->end - at->begin < hole.end - hole.begin + least_rest_s * rate;
            Draft rest = take_end(*at, border);
            drafts.insert(at + 1, std::move(rest));
            ++after;
        }
        std::size_t before = after - 1;
        if (hole.begin < hole.end) {
            before = insert_hole(drafts, after, hole);
            after = before + 1;
            --before;
        }
        if (is_brief) {
            give_away(drafts, after, true);
            give_away(drafts, before, false);
        }
    }
}

} // namespace stltsa::motion
