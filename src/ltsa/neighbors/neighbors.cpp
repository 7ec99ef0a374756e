// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/neighbors/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "ltsa/frames.hpp"
#include "ltsa/neighbors/band_distances.hpp"
#include "ltsa/neighbors/neighborhood_distances.hpp"

namespace stltsa::ltsa {

namespace {

/// Selects the nearest of the frames first, first + 1, ... with these distances, in ascending order
/// and ties to the earlier frame, without sorting frames. There are enough (check_parameters()),
/// and no distance is NaN.
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

/// The widest window whose distances are stored, so that each is computed once: they take about
/// 48 w^2 bytes per thread.
constexpr std::int64_t widest_band = 1024;

} // namespace

WindowNeighbors::WindowNeighbors(std::span<const std::int64_t> lengths,
                                 const Parameters& parameters)
    : window_(parameters.window), include_self_(parameters.include_self) {
    for (const std::int64_t length : lengths)
        begins_.push_back(begins_.back() + length);
}

template <class Distance>
void WindowNeighbors::select(const Distance& distance, std::int64_t first, std::int64_t last,
                             Neighborhoods& neighborhoods) const {
    constexpr double excluded = std::numeric_limits<double>::infinity();
    std::vector<double> window, scratch;
    auto clip_end = std::ranges::upper_bound(begins_, first);
    for (std::int64_t i = first; i < last; ++i) {
        while (i >= *clip_end)
            ++clip_end;
        const std::int64_t begin = std::max(*(clip_end - 1), i - window_);
        window.clear();
        double sum = 0;
        for (std::int64_t j = begin; j < std::min(*clip_end, i + window_ + 1); ++j)
            sum += window.emplace_back(j != i || include_self_ ? distance(i, j) : excluded);
        if (std::isnan(sum))
            fail_changed(i);
        select_in_order(window, begin, scratch, neighborhoods.of(i));
    }
}

template void WindowNeighbors::select(const BandDistances&, std::int64_t, std::int64_t,
                                      Neighborhoods&) const;

void WindowNeighbors::select(ConstMatrixView x, Simd simd, std::int64_t first, std::int64_t last,
                             Neighborhoods& neighborhoods) const {
    if (window_ > widest_band)
        select(NeighborhoodDistances(x, neighborhoods.size, simd), first, last, neighborhoods);
    else
        select(BandDistances::of_windows(x, first, last, window_, window_, simd), first, last,
               neighborhoods);
}

Neighborhoods temporal_neighbors(ConstMatrixView x, std::span<const std::int64_t> lengths,
                                 const Parameters& parameters) {
    Neighborhoods neighborhoods{parameters.neighbors, {}};
    neighborhoods.index.resize(checked_size(x.rows, parameters.neighbors));
    const WindowNeighbors windows(lengths, parameters);
    const std::int64_t block = frame_block(parameters.window);
    const std::int64_t blocks = (x.rows + block - 1) / block;
    parallel_blocks(
        blocks, parameters.threads,
        [&](std::int64_t b) {
            windows.select(x, parameters.simd, b * block, std::min((b + 1) * block, x.rows),
                           neighborhoods);
        },
        Stage::neighbors);
    return neighborhoods;
}

} // namespace stltsa::ltsa
