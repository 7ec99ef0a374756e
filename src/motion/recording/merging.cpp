// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/merging.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace stltsa::motion {
namespace {

bool moves(const Draft& draft) {
    return draft.kind != SegmentKind::rest;
}

/// The draft that moves after the one at `i`, or the number of drafts.
std::size_t next_moving(const std::vector<Draft>& drafts, std::size_t i) {
    do
        ++i;
    while (i < drafts.size() && !moves(drafts[i]));
    return i;
}

/// What both do, if it is of one kind. Otherwise the cycles of one, or a single action.
Draft merged(const Draft& a, Draft b) {
    const bool alike = a.kind == b.kind && a.group == b.group;
    Draft one = alike || a.kind == SegmentKind::cyclic ? a : b;
    if (alike) {
        std::ranges::move(b.stretches, std::back_inserter(one.stretches));
        std::ranges::move(b.motions, std::back_inserter(one.motions));
        if (one.kind == SegmentKind::action && one.group >= 0)
            one.kind = SegmentKind::repetitions;
    }
    one.begin = a.begin;
    one.end = b.end;
    one.gain = a.gain;
    if (one.kind == SegmentKind::cyclic || (alike && one.kind == SegmentKind::repetitions))
        return one;
    one.kind = SegmentKind::action;
    one.motions = {one.rows()};
    one.group = -1;
    one.known_motion = false;
    return one;
}

} // namespace

std::int64_t moving(const std::vector<Draft>& drafts) {
    return std::ranges::count_if(drafts, moves);
}

void merge_to(const KernelFeatures& features, std::int64_t count, std::vector<Draft>& drafts) {
    while (moving(drafts) > count) {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < drafts.size(); ++i) {
            const std::size_t next = next_moving(drafts, i);
            if (!moves(drafts[i]) || next == drafts.size())
                continue;
            const Rows a = features.moments(drafts[i].rows());
            const Rows b = features.moments(drafts[next].rows());
            if (const double gain = features.gain(a, b); gain < least) {
                least = gain;
                best = i;
            }
        }
        const std::size_t next = next_moving(drafts, best);
        drafts[best] = merged(drafts[best], std::move(drafts[next]));
        drafts.erase(drafts.begin() + static_cast<std::ptrdiff_t>(best) + 1,
                     drafts.begin() + static_cast<std::ptrdiff_t>(next) + 1);
    }
}

} // namespace stltsa::motion
