// SPDX-License-Identifier: BSD-3-Clause
#include "results/sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/side_name.hpp"
#include "clip/arrays/mirror.hpp"
#include "clip/features/column_owners.hpp"
#include "clip/features/drift.hpp"
#include "clip/features/points.hpp"

namespace stltsa::results {
namespace {

struct Columns {
    std::size_t left = 0, right = 0;
};

/// Columns with the same name, such as the coordinates of a joint, are distinguished by their
/// order.
std::vector<Columns> pairs_of(std::span<const std::string> names) {
    std::map<std::string, std::vector<std::size_t>> places;
    std::vector<std::size_t> order;
    for (std::size_t c = 0; c < names.size(); ++c) {
        order.push_back(places[names[c]].size());
        places[names[c]].push_back(c);
    }
    std::vector<Columns> pairs;
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
                       std::span<const std::string> names, bool mirrored) {
    ComparedSides result;
    result.samples = left.mean.rows();
    result.reason = left.no_halves;
    const auto pairs = pairs_of(names);
    if (result.reason.empty() && pairs.empty())
        result.reason = "no two names differ only in the side, as LeftFoot and RightFoot, L_toe "
                        "and R_toe do";
    if (!result.reason.empty())
        return result;
    for (const Columns& pair : pairs) {
        const auto column = static_cast<std::int64_t>(pair.left);
        const auto of_right = mirrored ? column : static_cast<std::int64_t>(pair.right);
        const auto a = phase::curve_of(left.mean, left.deviation, column);
        const auto b =
            phase::half_a_cycle_later(phase::curve_of(right.mean, right.deviation, of_right));
        result.pairs.push_back(
            {column, static_cast<std::int64_t>(pair.right), names[pair.left], names[pair.right],
             closed(a.mean), closed(b.mean),
             phase::difference(a, b, static_cast<std::int64_t>(left.each.size()))});
    }
    drop_if_unknown(result);
    return result;
}

/// A row for each frame of the file, NaN for those that were dropped.
Matrix by_frame(const Matrix& rows, std::int64_t frames, std::int64_t first) {
    Matrix result(frames, rows.cols());
    std::fill_n(result.data(), first * rows.cols(), std::numeric_limits<double>::quiet_NaN());
    const std::int64_t count = std::min(rows.rows(), frames - first);
    std::copy_n(rows.data(), count * rows.cols(), result.row(first));
    return result;
}

/// Features of every frame of the mirror image.
struct Image {
    Matrix rows;
    bool turned = false; ///< see ClipSamples
};

Image image_of(const clip::Clip& clip, const Phased& phased, clip::PrepareOptions prepare,
               const Progress& progress) {
    if (phased.samples.up != clip::Axis::none)
        prepare.up = phased.samples.up;
    const clip::Clip image = clip::mirrored(clip, prepare.up);
    prepare.features = phased.samples.features;
    prepare.rate = 0;
    prepare.smoothing = 0;
    const clip::Clip* single = &image;
    ClipSamples prepared = prepare_clips({&single, 1}, prepare, progress);
    clip::remove_drift(prepared.samples, image.fps);
    const std::int64_t first = prepared.source.clips.front().first;
    return {by_frame(prepared.samples, phased.clip.frames, first), prepared.turned};
}

/// The columns of the points for the two horizontal axes, if the heading was removed.
struct Level {
    std::int64_t first = 0, second = 0, width = 0; ///< width 0: the heading was kept
};

Level level_of(const clip::Clip& clip, const Phased& phased, bool turned) {
    if (phased.samples.features != clip::Features::points || !turned)
        return {};
    const int width = clip::point_columns(clip);
    const auto up = static_cast<std::int64_t>(phased.samples.up);
    if (width == 2)
        return {0, 1, 2};
    return {up % 3, (up + 1) % 3, 3};
}

/// The mirror plane goes through the middle of the body, but the heading of points lies only
/// roughly in it. Therefore the mirror image is turned so that the sides differ least. Otherwise,
/// points of a symmetric walk seem 8 mm apart (headings that differ by 1 degree).
void turn_to(const phase::Resampled& own, const phase::Resampled& image, const Level& level,
             Matrix& signals) {
    double along = 0, across = 0;
    for (std::int64_t c = 0; c + level.width <= own.mean.cols(); c += level.width) {
        const auto a = phase::curve_of(own.mean, own.deviation, c + level.first).mean;
        const auto b = phase::curve_of(own.mean, own.deviation, c + level.second).mean;
        const auto later = [&](std::int64_t column) {
            return phase::half_a_cycle_later(phase::curve_of(image.mean, image.deviation, column))
                .mean;
        };
        const auto to_a = later(c + level.first), to_b = later(c + level.second);
        for (std::size_t s = 0; s < a.size(); ++s) {
            const double dot = a[s] * to_a[s] + b[s] * to_b[s];
            const double cross = b[s] * to_a[s] - a[s] * to_b[s];
            along += std::isnan(dot) ? 0 : dot;
            across += std::isnan(cross) ? 0 : cross;
        }
    }
    const double length = std::hypot(along, across);
    if (!(length > 0))
        return;
    for (std::int64_t i = 0; i < signals.rows(); ++i)
        for (std::int64_t c = 0; c + level.width <= signals.cols(); c += level.width) {
            double &first = signals(i, c + level.first), &second = signals(i, c + level.second);
            const double turned = (along * first - across * second) / length;
            second = (across * first + along * second) / length;
            first = turned;
        }
}

/// Whether the features of the clip are those of the phase, as far as their names tell.
bool has_columns_of(const clip::Clip& clip, const Phased& phased) {
    const clip::Features features = phased.samples.features;
    const bool any = features == clip::Features::raw;
    const bool points = features == clip::Features::points;
    return (any || points != clip.skeleton.has_value()) &&
           clip::column_owners(clip, features) == phased.owners;
}

} // namespace

ComparedSides compare_sides(const phase::Resampled& cycles, std::span<const std::string> names) {
    return compared(cycles, cycles, names, false);
}

ComparedSides compare_sides(const clip::Clip& clip, const Phased& phased, std::int32_t label,
                            std::int64_t samples, const clip::PrepareOptions& prepare,
                            const Progress& progress) {
    if (!has_columns_of(clip, phased))
        fail(Status::argument,
             "the phase belongs to another clip: one with other joints or points");
    const Matrix rows = by_frame(phased.rows, phased.clip.frames, phased.clip.first);
    const phase::Resampled own = resample(phased, label, rows.view(), samples);
    if (!own.no_halves.empty())
        return compared(own, own, phased.owners, true);
    try {
        auto [image, turned] = image_of(clip, phased, prepare, progress);
        if (const Level level = level_of(clip, phased, turned); level.width > 0)
            turn_to(own, resample(phased, label, image.view(), samples), level, image);
        return compared(own, resample(phased, label, image.view(), samples), phased.owners, true);
    } catch (const Error& error) {
        if (error.status() != Status::unsupported)
            throw;
        return {{}, samples, error.what()}; // the clip has no mirror image
    }
}

} // namespace stltsa::results
