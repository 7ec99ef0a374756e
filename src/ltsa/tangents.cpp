// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents.hpp"

#include <algorithm>
#include <functional>

#include "base/parallel.hpp"
#include "linalg/simd.hpp"
#include "ltsa/band_distances.hpp"
#include "ltsa/local_pca.hpp"

namespace stltsa::ltsa {
namespace {

using Use = std::function<void(std::int64_t frame, LocalPca& pca)>;

/// Calls use(frame, pca) with the principal directions of every `stride`-th neighborhood.
void for_each_neighborhood(ConstMatrixView x, const Neighborhoods& neighborhoods,
                           std::int64_t count, std::int64_t window, std::int64_t stride,
                           int threads, const Progress& progress, const Use& use) {
    const std::int64_t block = frame_block(window);
    const std::int64_t blocks = (x.rows + block - 1) / block;
    const auto work = [&](std::int64_t b) {
        const std::int64_t first = b * block;
        const std::int64_t last = std::min(first + block, x.rows);
        LocalPca pca(x, neighborhoods.size, count);
        std::optional<BandDistances> band;
        LocalPca::Distance distance = [&x](std::int64_t p, std::int64_t q) {
            return squared_distance(x.row(p), x.row(q), x.cols);
        };
        if (window > 0 && neighborhoods.size <= x.cols) {
            band.emplace(x, std::max<std::int64_t>(0, first - window),
                         std::min(x.rows, last + window), 2 * window);
            distance = [&band](std::int64_t p, std::int64_t q) { return (*band)(p, q); };
        }
        for (std::int64_t i = (first + stride - 1) / stride * stride; i < last; i += stride) {
            pca.compute(neighborhoods.of(i), distance);
            use(i, pca);
        }
    };
    parallel_blocks(blocks, threads, work, [&](std::int64_t done) {
        progress.report(Stage::tangents, static_cast<double>(done) / static_cast<double>(blocks));
    });
}

/// Directions whose eigenvalue is rounding noise are not there: the vectors that LAPACK gives for
/// them are arbitrary. `values`: frames x d.
void drop_missing_directions(const Matrix& values, Tangents& tangents) {
    std::vector<double> first(static_cast<std::size_t>(values.rows()));
    for (std::int64_t i = 0; i < values.rows(); ++i)
        first[static_cast<std::size_t>(i)] = values(i, 0);
    const auto middle = first.begin() + static_cast<std::ptrdiff_t>(first.size() / 2);
    std::nth_element(first.begin(), middle, first.end());
    const double floor = 1e-18 * *middle;
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        std::int32_t rank = 0;
        while (rank < tangents.count && values(i, rank) > std::max(1e-13 * values(i, 0), floor))
            ++rank;
        tangents.rank[static_cast<std::size_t>(i)] = rank;
        std::fill(tangents.direction(i, rank), tangents.direction(i, tangents.count), 0.0);
    }
}

} // namespace

Tangents local_tangents(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                        std::int64_t window, int threads, const Progress& progress) {
    Tangents tangents{neighborhoods.size, count, {}, {}};
    tangents.g.resize(
        checked_size(checked_size(x.rows, count) > 0 ? x.rows * count : 0, neighborhoods.size));
    tangents.rank.resize(static_cast<std::size_t>(x.rows));
    Matrix values(x.rows, count);
    const std::int64_t computed = std::min({count, neighborhoods.size, x.cols});
    for_each_neighborhood(x, neighborhoods, computed, window, 1, threads, progress,
                          [&](std::int64_t i, LocalPca& pca) {
                              for (std::int64_t l = 0; l < computed; ++l) {
                                  values(i, l) = pca.value(l);
                                  pca.direction(l, tangents.direction(i, l),
                                                tangents.direction(i, 0));
                              }
                          });
    drop_missing_directions(values, tangents);
    return tangents;
}

Matrix local_spectra(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                     std::int64_t stride, int threads, const Progress& progress) {
    Matrix spectra((x.rows + stride - 1) / stride, count);
    for_each_neighborhood(x, neighborhoods, count, 0, stride, threads, progress,
                          [&](std::int64_t i, LocalPca& pca) {
                              for (std::int64_t l = 0; l < count; ++l)
                                  spectra(i / stride, l) = std::max(0.0, pca.value(l));
                          });
    return spectra;
}

} // namespace stltsa::ltsa
