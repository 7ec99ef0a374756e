// SPDX-License-Identifier: BSD-3-Clause
#include "results/sides.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "base/side_name.hpp"
#include "results/mirror_image.hpp"

namespace stltsa::results {
namespace {

/// The curve with its first sample repeated at the end.
std::vector<double> closed(std::vector<double> curve) {
    curve.push_back(curve.front());
    return curve;
}

/// If a clip begins and ends with the cycles, part of every cycle may be missing.
void drop_if_unknown(ComparedSides& result) {
    const bool unknown = std::ranges::all_of(
        result.pairs, [](const SidePair& pair) { return std::isnan(pair.difference.rms); });
    if (!unknown)
        return;
    result.pairs.clear();
    result.reason = "part of the mean cycle is missing, because no cycle has values there";
}

/// `right`: signals that hold the right side in the columns with the left names.
ComparedSides compared(const phase::Resampled& left, const phase::Resampled& right,
                       std::span<const std::string> names, bool mirrored,
                       const std::function<void()>& poll) {
    ComparedSides result;
    result.samples = left.mean.rows();
    result.reason = left.no_halves;
    const auto pairs = side_columns(names);
    if (result.reason.empty() && pairs.empty())
        result.reason = "no two names differ only in the side, as LeftFoot and RightFoot, L_toe "
                        "and R_toe do";
    if (!result.reason.empty())
        return result;
    PacedPoll polls(poll);
    for (const SideColumns& pair : pairs) {
        const auto column = static_cast<std::int64_t>(pair.left);
        const auto of_right = mirrored ? column : static_cast<std::int64_t>(pair.right);
        const auto a = phase::curve_of(left.mean, left.deviation, column);
        const auto b =
            phase::half_a_cycle_later(phase::curve_of(right.mean, right.deviation, of_right));
        result.pairs.push_back(
            {column, static_cast<std::int64_t>(pair.right), names[pair.left], names[pair.right],
             closed(a.mean), closed(b.mean),
             phase::difference(a, b, static_cast<std::int64_t>(left.each.size()), polls)});
        polls.did(8 * result.samples);
    }
    drop_if_unknown(result);
    return result;
}

} // namespace

std::vector<SideColumns> side_columns(std::span<const std::string> names) {
    std::map<std::string, std::vector<std::size_t>> places;
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < names.size(); ++c) {
        order.push_back(places[names[c]].size());
        places[names[c]].push_back(c);
    }
    std::vector<SideColumns> pairs;
    for (std::size_t c = 0; c < names.size(); ++c)
        for (const OtherSide& other : other_sides(names[c], true)) {
            const auto found = places.find(other.name);
            if (other.side != Side::left || found == places.end() ||
                order[c] >= found->second.size())
                continue;
            pairs.push_back({c, found->second[order[c]]});
            break;
        }
    return pairs;
}

ComparedSides compare_sides(const phase::Resampled& cycles, std::span<const std::string> names) {
    return compared(cycles, cycles, names, false, {});
}

ComparedSides compare_sides(const clip::Clip& clip, const Phased& phased, std::int32_t label,
                            std::int64_t samples, const clip::PrepareOptions& prepare,
                            const Progress& progress) {
    check_same_clip(clip, phased);
    const Matrix rows = rows_by_frame(phased);
    const auto start = [progress] { progress.report(Stage::features, 0); };
    const phase::Resampled own = resample(phased, label, rows.view(), samples, start);
    if (!own.no_halves.empty())
        return compared(own, own, phased.owners, true, start);
    try {
        const Matrix image = mirror_image(clip, phased, label, samples, prepare, progress);
        const auto end = [progress] { progress.report(Stage::features, 1); };
        return compared(own, resample(phased, label, image.view(), samples, end), phased.owners,
                        true, end);
    } catch (const Error& error) {
        if (error.status() != Status::unsupported)
            throw;
        return {{}, samples, error.what()}; // the clip has no mirror image
    }
}

} // namespace stltsa::results
