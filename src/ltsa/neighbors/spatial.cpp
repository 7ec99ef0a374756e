// SPDX-License-Identifier: BSD-3-Clause
// Neighbors among all frames (Table 1, step 1).
#include "ltsa/neighbors/neighbors.hpp"

#include <algorithm>

#include "ltsa/frames.hpp"
#include "ltsa/search/all_nearest.hpp"

namespace stltsa::ltsa {
namespace {

/// The clip of each frame, as its first frame and its end.
std::vector<RowRange> clip_of_frame(std::span<const std::int64_t> lengths) {
    std::vector<RowRange> clips;
    std::int64_t first = 0;
    for (const std::int64_t length : lengths) {
        clips.insert(clips.end(), static_cast<std::size_t>(length),
                     RowRange{first, first + length});
        first += length;
    }
    return clips;
}

/// Writes the frames found for frame i to the last `count` places of its neighborhood and sorts the
/// neighborhood by time.
void complete(Neighborhoods& neighborhoods, std::int64_t i, std::int64_t count,
              const std::vector<Candidate>& found) {
    if (static_cast<std::int64_t>(found.size()) < count) // nothing is near to a NaN
        fail_changed(i);
    const auto neighborhood = neighborhoods.of(i);
    std::transform(found.begin(), found.end(),
                   neighborhood.end() - static_cast<std::ptrdiff_t>(count),
                   [](const Candidate& candidate) { return candidate.frame; });
    std::sort(neighborhood.begin(), neighborhood.end());
}

} // namespace

Neighborhoods spatial_neighbors(ConstMatrixView x, const Parameters& parameters) {
    Neighborhoods neighborhoods{parameters.neighbors, {}};
    neighborhoods.index.resize(checked_size(x.rows, parameters.neighbors));
    const auto zone_of = [&](std::int64_t i) {
        return parameters.include_self ? RowRange{0, 0} : RowRange{i, i + 1};
    };
    const auto store = [&](std::int64_t i, const std::vector<Candidate>& found) {
        complete(neighborhoods, i, parameters.neighbors, found);
    };
    find_nearest_of_all(
        x, {parameters.neighbors, zone_of, store, parameters.threads, parameters.simd});
    return neighborhoods;
}

Neighborhoods recurrent_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                  const Parameters& parameters) {
    const auto clips = clip_of_frame(lengths);
    const auto zone_of = [&](std::int64_t i) {
        const RowRange clip = clips[static_cast<std::size_t>(i)];
        return RowRange{std::max(clip.begin, i - parameters.exclusion),
                        std::min(clip.end, i + parameters.exclusion + 1)};
    };
    for (std::int64_t i = 0; i < x.rows; ++i)
        if (x.rows - (zone_of(i).end - zone_of(i).begin) < parameters.links)
            fail(Status::too_few_frames,
                 "recurrent neighbors: frame {} has fewer than {} frames outside its exclusion "
                 "zone of +-{} frames; use a smaller exclusion or fewer links",
                 i, parameters.links, parameters.exclusion);

    const Neighborhoods near = temporal_neighbors(x, lengths, parameters);
    Neighborhoods neighborhoods{parameters.neighbors + parameters.links, {}};
    neighborhoods.index.resize(checked_size(x.rows, neighborhoods.size));
    const auto store = [&](std::int64_t i, const std::vector<Candidate>& found) {
        const auto temporal = near.of(i);
        std::copy(temporal.begin(), temporal.end(), neighborhoods.of(i).begin());
        complete(neighborhoods, i, parameters.links, found);
    };
    find_nearest_of_all(x, {parameters.links, zone_of, store, parameters.threads, parameters.simd});
    return neighborhoods;
}

} // namespace stltsa::ltsa
