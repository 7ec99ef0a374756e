// SPDX-License-Identifier: BSD-3-Clause
#include "motion/recording/merging.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "motion/behaviors/shapes.hpp"

namespace stltsa::motion {
namespace {

bool moves(const Draft& draft) {
    return draft.kind != SegmentKind::rest;
}

/// A part is understood if one cyclic draft, or one of repetitions, fills this share of it.
constexpr double mostly = 0.7;

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

/// Merges the drafts from `first` to `last`.
void merge(std::vector<Draft>& drafts, std::size_t first, std::size_t last) {
    drafts[first] = merged(drafts[first], std::move(drafts[last]));
    drafts.erase(drafts.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 drafts.begin() + static_cast<std::ptrdiff_t>(last) + 1);
}

} // namespace

void merge_shapes(const KernelFeatures& features, const std::vector<Part>& parts,
                  std::vector<Draft>& drafts) {
    if (!features.of_shapes())
        return;
    const auto period = static_cast<double>(moments_of_period * features.step());
    const auto part_of = [&](const Draft& draft) {
        const double middle = (draft.begin + draft.end) / 2;
        return std::ranges::upper_bound(parts, middle, {}, [](const Part& part) {
            return static_cast<double>(part.rows.begin);
        });
    };
    std::vector<double> repeated(parts.size() + 1); // share of each part
    for (const Draft& draft : drafts)
        if (draft.kind == SegmentKind::cyclic || draft.kind == SegmentKind::repetitions) {
            const auto part = part_of(draft);
            double& share = repeated[static_cast<std::size_t>(part - parts.begin())];
            share = std::max(share, (draft.end - draft.begin) /
                                        static_cast<double>((part - 1)->rows.count()));
        }
    for (std::size_t i = 0; i < drafts.size();) {
        const std::size_t next = next_moving(drafts, i);
        if (repeated[static_cast<std::size_t>(part_of(drafts[i]) - parts.begin())] < mostly &&
            moves(drafts[i]) && next < drafts.size() &&
            drafts[next].begin - drafts[i].end < period &&
            part_of(drafts[i]) == part_of(drafts[next]))
            merge(drafts, i, next);
        else
            ++i;
    }
}

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
        merge(drafts, best, next_moving(drafts, best));
    }
}

} // namespace stltsa::motion
