// SPDX-License-Identifier: BSD-3-Clause
// Neighbors among all frames: exact, by comparing every pair.
#include "ltsa/neighbors.hpp"

#include <algorithm>
#include <limits>

#include "base/parallel.hpp"
#include "linalg/simd.hpp"
#include "ltsa/best.hpp"

namespace stltsa::ltsa {
namespace {

constexpr std::int64_t query_block = 32;   // frames that share one pass over the others
constexpr std::int64_t stream_block = 256; // frames that stay in cache during a pass

/// Frames [begin, end) are not candidates.
struct Zone {
    std::int64_t begin, end;
};

/// Finds for each frame the `count` nearest frames outside its zone and hands them to `store`.
template <class ZoneOf, class Store>
void nearest_of_all(ConstMatrixView x, std::int64_t count, int threads, const Progress& progress,
                    const ZoneOf& zone_of, const Store& store) {
    const std::int64_t blocks = (x.rows + query_block - 1) / query_block;
    const auto search = [&](std::int64_t block) {
        const std::int64_t first = block * query_block;
        const std::int64_t last = std::min(first + query_block, x.rows);
        std::vector<Best<Candidate>> nearest(static_cast<std::size_t>(last - first),
                                             Best<Candidate>(static_cast<std::size_t>(count)));
        for (std::int64_t begin = 0; begin < x.rows; begin += stream_block)
            for (std::int64_t i = first; i < last; ++i) {
                const Zone zone = zone_of(i);
                for (std::int64_t j = begin; j < std::min(begin + stream_block, x.rows); ++j)
                    if (j < zone.begin || j >= zone.end)
                        nearest[static_cast<std::size_t>(i - first)].offer(
                            {squared_distance(x.row(i), x.row(j), x.cols),
                             static_cast<std::int32_t>(j)});
            }
        for (std::int64_t i = first; i < last; ++i)
            store(i, nearest[static_cast<std::size_t>(i - first)].sorted());
    };
    parallel_blocks(blocks, threads, search, [&](std::int64_t done) {
        progress.report(Stage::neighbors, static_cast<double>(done) / static_cast<double>(blocks));
    });
}

/// First frame and end of the clip of each frame.
std::vector<Zone> clip_of_frame(std::span<const std::int64_t> lengths) {
    std::vector<Zone> clips;
    std::int64_t first = 0;
    for (const std::int64_t length : lengths) {
        clips.insert(clips.end(), static_cast<std::size_t>(length), Zone{first, first + length});
        first += length;
    }
    return clips;
}

} // namespace

Neighborhoods spatial_neighbors(ConstMatrixView x, const Parameters& parameters,
                                const Progress& progress) {
    Neighborhoods neighborhoods{parameters.neighbors, {}};
    neighborhoods.index.resize(checked_size(x.rows, parameters.neighbors));
    nearest_of_all(
        x, parameters.neighbors, parameters.threads, progress,
        [&](std::int64_t i) {
            return parameters.include_self ? Zone{0, 0} : Zone{i, i + 1};
        },
        [&](std::int64_t i, std::vector<Candidate> found) {
            select_nearest(found, neighborhoods.of(i));
        });
    return neighborhoods;
}

Neighborhoods recurrent_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                  const Parameters& parameters, const Progress& progress) {
    const auto clips = clip_of_frame(lengths);
    const auto zone_of = [&](std::int64_t i) {
        const Zone clip = clips[static_cast<std::size_t>(i)];
        return Zone{std::max(clip.begin, i - parameters.exclusion),
                    std::min(clip.end, i + parameters.exclusion + 1)};
    };
    for (std::int64_t i = 0; i < x.rows; ++i)
        if (x.rows - (zone_of(i).end - zone_of(i).begin) < parameters.links)
            fail(Status::too_few_frames,
                 "recurrent neighbors: frame {} has fewer than {} frames outside its exclusion "
                 "zone of +-{} frames; use a smaller exclusion or fewer links",
                 i, parameters.links, parameters.exclusion);

    const Neighborhoods near = temporal_neighbors(x, lengths, parameters, progress);
    Neighborhoods neighborhoods{parameters.neighbors + parameters.links, {}};
    neighborhoods.index.resize(checked_size(x.rows, neighborhoods.size));
    nearest_of_all(x, parameters.links, parameters.threads, progress, zone_of,
                   [&](std::int64_t i, const std::vector<Candidate>& found) {
                       const auto out = neighborhoods.of(i);
                       const auto temporal = near.of(i);
                       std::copy(temporal.begin(), temporal.end(), out.begin());
                       std::transform(found.begin(), found.end(),
                                      out.begin() + static_cast<std::ptrdiff_t>(temporal.size()),
                                      [](const Candidate& c) { return c.frame; });
                       std::sort(out.begin(), out.end());
                   });
    return neighborhoods;
}

} // namespace stltsa::ltsa
