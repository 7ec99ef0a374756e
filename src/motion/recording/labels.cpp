// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "motion/behaviors/grouping.hpp"
#include "motion/recording/drafts.hpp"

namespace stltsa::motion {
namespace {

/// Segments are one motion if the cosine of their kernel means is at least this, on the average.
constexpr double same_behavior = 0.8;
/// Distance of motions that are known to differ.
constexpr double different = 1;

double distance(const KernelFeatures& features, const Draft& a, const Draft& b) {
    if (a.group >= 0 && a.group == b.group)
        return 0;
    if (a.kind != b.kind &&
        (a.kind == SegmentKind::repetitions || b.kind == SegmentKind::repetitions ||
         a.known_motion || b.known_motion))
        return different;
    const double apart =
        1 - features.likeness(features.moments(a.rows()), features.moments(b.rows()));
    const CyclicStretch *first = a.longest(), *second = b.longest();
    if (apart <= 1 - same_behavior && first != nullptr && second != nullptr &&
        !may_be_one(*first, *second))
        return different;
    return apart;
}

} // namespace

void set_labels(const KernelFeatures& features, std::vector<Draft>& drafts,
                const std::function<void()>& poll) {
    std::vector<Draft*> moving;
    for (Draft& draft : drafts)
        if (draft.kind != SegmentKind::rest)
            moving.push_back(&draft);
    const std::vector<int> labels = group(
        static_cast<std::int64_t>(moving.size()), 1 - same_behavior,
        [&](std::int64_t i, std::int64_t k) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
            return distance(features, *moving[a], *moving[b]);
        },
        poll);
    for (std::size_t i = 0; i < moving.size(); ++i)
        moving[i]->label = labels[i];
}

void join_neighbors(std::vector<Draft>& drafts) {
    std::vector<Draft> joined;
    for (Draft& draft : drafts) {
        const bool touches =
            !joined.empty() && draft.label >= 0 && joined.back().label == draft.label &&
            joined.back().kind == draft.kind && draft.kind != SegmentKind::repetitions;
        if (!touches) {
            joined.push_back(std::move(draft));
            continue;
        }
        Draft& before = joined.back();
        before.end = draft.end;
        std::ranges::move(draft.stretches, std::back_inserter(before.stretches));
        before.motions.clear();
        before.best_match = std::max(before.best_match, draft.best_match);
    }
    drafts.swap(joined);
}

} // namespace stltsa::motion
