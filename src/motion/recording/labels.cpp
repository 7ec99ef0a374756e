// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "motion/behaviors/grouping.hpp"
#include "motion/behaviors/likeness.hpp"
#include "motion/recording/drafts.hpp"

namespace stltsa::motion {
namespace {

/// Distance of motions that are known to differ.
constexpr double different = 1;

/// Whether both may share a label: repetitions only with repetitions, because pauses tell them from
/// other motions.
bool may_be_same(const Draft& a, const Draft& b) {
    const auto repeats = [](const Draft& draft) {
        return draft.kind == SegmentKind::repetitions || draft.known_motion;
    };
    return a.kind == b.kind || (!repeats(a) && !repeats(b));
}

} // namespace

void set_labels(const KernelFeatures& features, std::vector<Draft>& drafts) {
    const Describer describe(features);
    std::vector<Draft*> moving;
    std::vector<Description> done;
    for (Draft& draft : drafts)
        if (draft.kind != SegmentKind::rest) {
            moving.push_back(&draft);
            done.push_back(describe(features.moments(draft.rows())));
        }
    const std::vector<int> labels = group(
        static_cast<std::int64_t>(moving.size()), 1 - same_behavior,
        [&](std::int64_t i, std::int64_t k) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(k);
            if (moving[a]->group >= 0 && moving[a]->group == moving[b]->group)
                return 0.0;
            return may_be_same(*moving[a], *moving[b]) ? 1 - likeness(done[a], done[b]) : different;
        });
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
