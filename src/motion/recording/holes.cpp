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

void divide_at_holes(const std::vector<Rows>& holes, double rate, std::vector<Draft>& drafts) {
    for (const Rows& hole : holes) {
        const double border = static_cast<double>(hole.begin + hole.end) / 2;
        const auto at = std::ranges::find_if(
            drafts, [&](const Draft& draft) { return draft.begin < border && border < draft.end; });
        if (at == drafts.end())
            continue;
        const bool is_hole =
            at->kind == SegmentKind::rest && drafts.size() > 1 &&
            at->end - at->begin < static_cast<double>(hole.count()) + least_rest_s * rate;
        if (!is_hole) {
            const auto next = at + 1;
            Draft rest = take_end(*at, border);
            drafts.insert(next, std::move(rest));
            continue;
        }
        const bool first = at == drafts.begin(), last = at + 1 == drafts.end();
        if (!first)
            (at - 1)->end = last ? at->end : border;
        if (!last)
            (at + 1)->begin = first ? at->begin : border;
        drafts.erase(at);
    }
}

} // namespace stltsa::motion
