// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents/local_tangents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "linalg/machine.hpp"
#include "linalg/simd.hpp"
#include "ltsa/neighbors/band_distances.hpp"
#include "ltsa/neighbors/neighborhood_distances.hpp"
#include "ltsa/tangents/finder.hpp"
#include "ltsa/tangents/local_pca.hpp"

namespace stltsa::ltsa {
namespace {

/// Frames of a long clip whose median eigenvalue is taken.
constexpr std::int64_t most_sampled = 1 << 12;

/// Removes directions whose eigenvalue is rounding noise: their vectors are arbitrary. `values`:
/// frames x computed directions.
void drop_missing_directions(const Matrix& values, Tangents& tangents, const Machine& machine) {
    const std::int64_t step = (values.rows() + most_sampled - 1) / most_sampled;
    std::vector<double> first;
    for (std::int64_t i = 0; i < values.rows(); i += step)
        first.push_back(values(i, 0));
    const auto middle = first.begin() + static_cast<std::ptrdiff_t>(first.size() / 2);
    std::nth_element(first.begin(), middle, first.end());
    const double floor = 1e-18 * *middle;
    for_row_blocks(
        values.rows(), machine, [&](std::int64_t, std::int64_t begin, std::int64_t rows) {
            for (std::int64_t i = begin; i < begin + rows; ++i) {
                std::int32_t rank = 0;
                while (rank < values.cols() &&
                       values(i, rank) > std::max(negligible_value * values(i, 0), floor))
                    ++rank;
                tangents.rank[static_cast<std::size_t>(i)] = rank;
                std::fill(tangents.direction(i, rank), tangents.direction(i, tangents.count), 0.0);
            }
        });
}

/// Estimates by how much rounding may have turned the directions: a matrix of products is rounded
/// relative to its largest eigenvalue.
void set_rounding(const Matrix& values, Tangents& tangents, const Machine& machine) {
    const std::int64_t blocks = row_blocks(values.rows());
    Matrix squares(blocks, values.cols()), windows(blocks, values.cols());
    tangents.rounding.resize(static_cast<std::size_t>(tangents.count));
    for_row_blocks(
        values.rows(), machine, [&](std::int64_t block, std::int64_t begin, std::int64_t rows) {
            for (std::int64_t i = begin; i < begin + rows; ++i)
                for (std::int64_t l = 0; l < tangents.rank[static_cast<std::size_t>(i)]; ++l) {
                    const double angle =
                        std::numeric_limits<double>::epsilon() * values(i, 0) / values(i, l);
                    squares(block, l) += angle * angle;
                    windows(block, l) += 1;
                }
        });
    for (std::int64_t l = 0; l < values.cols(); ++l) {
        double square = 0, count = 0;
        for (std::int64_t b = 0; b < blocks; ++b) {
            square += squares(b, l);
            count += windows(b, l);
        }
        tangents.rounding[static_cast<std::size_t>(l)] = count > 0 ? std::sqrt(square / count) : 0;
    }
}

/// Neighbors and tangents share distances if a window is at most this many times as large as a
/// neighborhood. In larger windows, most of the distances would be unused.
constexpr std::int64_t widest_shared = 4;

struct Range {
    std::int64_t first, last;
};

/// Blocks of at most `block` frames. Each clip begins a new block, so that its tangents do not
/// depend on the previous clips: CovarianceBatch sums in groups of frames of a block.
std::vector<Range> blocks_of(std::span<const std::int64_t> lengths, std::int64_t block) {
    std::vector<Range> blocks;
    std::int64_t end = 0;
    for (const std::int64_t length : lengths) {
        std::int64_t begin = end;
        end += length;
        for (; begin < end; begin += block)
            blocks.push_back({begin, std::min(begin + block, end)});
    }
    return blocks;
}

/// Calls find(finder, first, last) for each block of frames.
template <class Find>
Tangents find_in_blocks(ConstMatrixView x, const Neighborhoods& neighborhoods,
                        const Parameters& parameters, const std::vector<Range>& blocks,
                        const Find& find) {
    const std::int64_t count = parameters.dimension;
    Tangents tangents{neighborhoods.size, count, {}, {}, {}};
    tangents.g.resize(
        checked_size(checked_size(x.rows, count) > 0 ? x.rows * count : 0, neighborhoods.size));
    tangents.rank.resize(static_cast<std::size_t>(x.rows));
    const std::int64_t computed = std::min({count, neighborhoods.size, x.cols});
    Matrix values = Matrix::unset(x.rows, computed);
    const auto count_of_blocks = static_cast<std::int64_t>(blocks.size());
    const auto work = [&](std::int64_t b) {
        TangentFinder finder(x, neighborhoods, computed, parameters.simd, values, tangents);
        const auto [first, last] = blocks[static_cast<std::size_t>(b)];
        find(finder, first, last);
    };
    parallel_blocks(count_of_blocks, parameters.threads, work, Stage::tangents);
    const Machine machine{parameters.simd, parameters.threads};
    drop_missing_directions(values, tangents, machine);
    set_rounding(values, tangents, machine);
    return tangents;
}

} // namespace

Tangents local_tangents(ConstMatrixView x, const Neighborhoods& neighborhoods,
                        const Parameters& parameters) {
    const std::int64_t all[] = {x.rows};
    return find_in_blocks(x, neighborhoods, parameters, blocks_of(all, frame_block(0)),
                          [&](TangentFinder& finder, std::int64_t first, std::int64_t last) {
                              NeighborhoodDistances distances(x, neighborhoods.size,
                                                              parameters.simd);
                              finder.find(first, last, distances);
                          });
}

Tangents temporal_tangents(ConstMatrixView x, std::span<const std::int64_t> lengths,
                           const Parameters& parameters, Neighborhoods& neighborhoods) {
    neighborhoods.size = parameters.neighbors;
    neighborhoods.index.resize(checked_size(x.rows, parameters.neighbors));
    const WindowNeighbors windows(lengths, parameters);
    const std::int64_t window = parameters.window;
    const bool shared = TangentFinder::takes_distances(neighborhoods.size, x.cols) &&
                        window <= widest_shared * neighborhoods.size;
    const auto find = [&](TangentFinder& finder, std::int64_t first, std::int64_t last) {
        if (shared) {
            // Frames of one neighborhood are at most two windows apart.
            const auto distances =
                BandDistances::of_windows(x, first, last, window, 2 * window, parameters.simd);
            windows.select(distances, first, last, neighborhoods);
            finder.find(first, last, distances);
        } else {
            windows.select(x, parameters.simd, first, last, neighborhoods);
            NeighborhoodDistances distances(x, neighborhoods.size, parameters.simd);
            finder.find(first, last, distances);
        }
    };
    return find_in_blocks(x, neighborhoods, parameters, blocks_of(lengths, frame_block(window)),
                          find);
}

Matrix local_spectra(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                     std::int64_t stride, int threads) {
    const std::int64_t rows = (x.rows + stride - 1) / stride;
    constexpr std::int64_t block = 256;
    const std::int64_t blocks = (rows + block - 1) / block;
    Matrix spectra(rows, count);
    const auto work = [&](std::int64_t b) {
        LocalPca pca(x, neighborhoods.size, count, widest_simd());
        for (std::int64_t r = b * block; r < std::min((b + 1) * block, rows); ++r) {
            pca.compute_values(neighborhoods.of(r * stride));
            for (std::int64_t l = 0; l < count; ++l)
                spectra(r, l) = std::max(0.0, pca.value(l));
        }
    };
    parallel_blocks(blocks, threads, work, Stage::tangents);
    return spectra;
}

} // namespace stltsa::ltsa
