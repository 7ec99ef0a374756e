// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/neighbors.hpp"

#include <algorithm>
#include <limits>

#include "base/parallel.hpp"
#include "ltsa/band_distances.hpp"

namespace stltsa::ltsa {

Neighborhoods find_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                             const Parameters& parameters, const Progress& progress) {
    switch (parameters.mode) {
    case Mode::spatial:
        return spatial_neighbors(x, parameters, progress);
    case Mode::recurrent:
        return recurrent_neighbors(x, lengths, parameters, progress);
    case Mode::temporal:
        break;
    }
    return temporal_neighbors(x, lengths, parameters, progress);
}

namespace {

/// One block of frames of one clip.
struct Block {
    std::int64_t clip_begin, clip_end; ///< frames of the clip
    std::int64_t begin, end;           ///< frames of the block
};

std::vector<Block> clip_blocks(std::span<const std::int64_t> lengths, std::int64_t block) {
    std::vector<Block> blocks;
    std::int64_t first = 0;
    for (const std::int64_t length : lengths) {
        for (std::int64_t begin = first; begin < first + length; begin += block)
            blocks.push_back(
                {first, first + length, begin, std::min(begin + block, first + length)});
        first += length;
    }
    return blocks;
}

/// The nearest of the frames first, first + 1, ... at these distances, ties going to the earlier
/// one: ascending, without sorting frames.
void select_in_order(std::span<const double> distances, std::int64_t first,
                     std::vector<double>& scratch, std::span<std::int32_t> out) {
    scratch.assign(distances.begin(), distances.end());
    const auto farthest = scratch.begin() + static_cast<std::ptrdiff_t>(out.size()) - 1;
    std::nth_element(scratch.begin(), farthest, scratch.end());
    const double limit = *farthest;
    auto ties = static_cast<std::int64_t>(out.size()) -
                std::count_if(scratch.begin(), farthest,
                              [limit](double distance) { return distance < limit; });
    std::size_t found = 0;
    for (std::size_t j = 0; found < out.size(); ++j)
        if (distances[j] < limit || (distances[j] == limit && ties-- > 0))
            out[found++] = static_cast<std::int32_t>(first + static_cast<std::int64_t>(j));
}

void fill_block(ConstMatrixView x, const Block& block, const Parameters& parameters,
                Neighborhoods& neighborhoods) {
    const std::int64_t w = parameters.window;
    // Distances are needed from each frame of the block to its own window only.
    const std::int64_t low = std::max(block.clip_begin, block.begin - w);
    const std::int64_t high = std::min(block.clip_end, block.end + w);
    const BandDistances distances(x, low, high, w, parameters.simd);
    constexpr double never = std::numeric_limits<double>::infinity();
    std::vector<double> window, scratch;
    for (std::int64_t i = block.begin; i < block.end; ++i) {
        const std::int64_t first = std::max(low, i - w);
        window.clear();
        for (std::int64_t j = first; j < std::min(high, i + w + 1); ++j)
            window.push_back(j != i || parameters.include_self ? distances(i, j) : never);
        select_in_order(window, first, scratch, neighborhoods.of(i));
    }
}

} // namespace

Neighborhoods temporal_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                 const Parameters& parameters, const Progress& progress) {
    Neighborhoods neighborhoods{parameters.neighbors, {}};
    neighborhoods.index.resize(checked_size(x.rows, parameters.neighbors));
    const auto blocks = clip_blocks(lengths, frame_block(parameters.window));
    const auto count = static_cast<std::int64_t>(blocks.size());
    parallel_blocks(
        count, parameters.threads,
        [&](std::int64_t b) {
            fill_block(x, blocks[static_cast<std::size_t>(b)], parameters, neighborhoods);
        },
        [&](std::int64_t done) {
            progress.report(Stage::neighbors,
                            static_cast<double>(done) / static_cast<double>(count));
        });
    return neighborhoods;
}

} // namespace stltsa::ltsa
