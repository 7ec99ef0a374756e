// SPDX-License-Identifier: BSD-3-Clause
#include "ltsa/tangents.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "base/parallel.hpp"
#include "linalg/machine.hpp"
#include "linalg/simd.hpp"
#include "ltsa/band_distances.hpp"
#include "ltsa/local_pca.hpp"
#include "ltsa/local_svd.hpp"
#include "ltsa/neighborhood_distances.hpp"
#include "ltsa/tangent_batch.hpp"
#include "ltsa/tangent_track.hpp"

namespace stltsa::ltsa {
namespace {

/// Where an eigenvalue is a smaller share of the first one than this, the direction is computed
/// from the frames themselves: matrices of products have as many digits less of it. Recorded motion
/// is well above (3 directions of 12 frames: 6e-4), but for features of very different sizes.
constexpr double small_share = 1e-5;

/// Writes the tangents of neighborhoods: several at a time where they are small, following them
/// from frame to frame where they are large, and one at a time where that did not find them, or
/// not well.
class TangentFinder {
  public:
    TangentFinder(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t computed,
                  Simd simd, Matrix& values, Tangents& tangents)
        : x_(x), neighborhoods_(neighborhoods), computed_(computed), values_(values),
          tangents_(tangents), pca_(x, neighborhoods.size, computed) {
        if (takes_distances(neighborhoods.size, x.cols))
            batch_ = std::make_unique<TangentBatch>(neighborhoods.size, computed, simd);
        else if (TangentTrack::worth_while(neighborhoods.size, x.cols))
            track_ =
                std::make_unique<TangentTrack>(x, neighborhoods, computed, simd, values, tangents);
    }

    /// Whether it needs the distances within all neighborhoods.
    static bool takes_distances(std::int64_t size, std::int64_t features) {
        return size <= std::min(features, TangentBatch::largest_size);
    }

    /// distance(p, q): squared distance of frames p < q; distance.among(members): of these.
    template <class Distance>
    void find(std::int64_t first, std::int64_t last, Distance distance) {
        find_by_products(first, last, distance);
        for (std::int64_t i = first; i < last; ++i)
            if (has_small_directions(i))
                find_by_svd(i);
    }

  private:
    template <class Distance>
    void find_by_products(std::int64_t first, std::int64_t last, Distance& distance) {
        if (batch_) {
            for (std::int64_t i = first; i < last; i += batch_->lanes())
                find_together(i, std::min(i + batch_->lanes(), last), distance);
        } else if (track_) {
            for (const std::int64_t i : track_->find(first, last))
                find_alone(i, distance);
        } else {
            for (std::int64_t i = first; i < last; ++i)
                find_alone(i, distance);
        }
    }

    /// Small, but not so small that they count as rounding noise however exact.
    bool has_small_directions(std::int64_t i) const {
        for (std::int64_t l = 1; l < computed_; ++l) {
            const double share = values_(i, l) / values_(i, 0);
            if (share < small_share && share > 0.1 * negligible_value)
                return true;
        }
        return false;
    }

    void find_by_svd(std::int64_t i) {
        if (!svd_)
            svd_ = std::make_unique<LocalSvd>(x_, neighborhoods_.size, computed_);
        if (!svd_->compute(neighborhoods_.of(i)))
            return; // what products gave stays
        for (std::int64_t l = 0; l < computed_; ++l) {
            values_(i, l) = svd_->value(l);
            svd_->direction(l, tangents_.direction(i, l), tangents_.direction(i, 0));
        }
    }

    template <class Distance>
    void find_alone(std::int64_t i, const Distance& distance) {
        pca_.compute(neighborhoods_.of(i), std::cref(distance));
        for (std::int64_t l = 0; l < computed_; ++l) {
            values_(i, l) = pca_.value(l);
            pca_.direction(l, tangents_.direction(i, l), tangents_.direction(i, 0));
        }
    }

    template <class Distance>
    void find_together(std::int64_t first, std::int64_t last, Distance& distance) {
        for (std::int64_t lane = 0; lane < batch_->lanes(); ++lane) {
            // Lanes too many repeat the last frame.
            const auto members = neighborhoods_.of(std::min(first + lane, last - 1));
            const auto among = distance.among(members);
            for (std::int64_t b = 1; b < neighborhoods_.size; ++b)
                for (std::int64_t a = 0; a < b; ++a)
                    batch_->set_distance(lane, a, b, among(a, b));
        }
        batch_->solve();
        for (std::int64_t i = first; i < last; ++i) {
            if (!batch_->found(i - first)) {
                find_alone(i, distance);
                continue;
            }
            for (std::int64_t l = 0; l < computed_; ++l) {
                values_(i, l) = batch_->value(i - first, l);
                double* g = tangents_.direction(i, l);
                batch_->direction(i - first, l, g);
                make_tangent(tangents_.direction(i, 0), l, neighborhoods_.size, g);
            }
        }
    }

    ConstMatrixView x_;
    const Neighborhoods& neighborhoods_;
    std::int64_t computed_;
    Matrix& values_;
    Tangents& tangents_;
    LocalPca pca_;
    std::unique_ptr<TangentBatch> batch_;
    std::unique_ptr<TangentTrack> track_;
    std::unique_ptr<LocalSvd> svd_;
};

void report(const Progress& progress, std::int64_t done, std::int64_t blocks) {
    progress.report(Stage::tangents, static_cast<double>(done) / static_cast<double>(blocks));
}

/// Frames of a long clip whose median says what size the eigenvalues have.
constexpr std::int64_t most_sampled = 1 << 16;

/// Directions whose eigenvalue is rounding noise are not there: the vectors that LAPACK gives for
/// them are arbitrary. `values`: frames x those computed.
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

/// A matrix of products is rounded relative to its largest eigenvalue.
double rounding_of(double value, double largest) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    return value < small_share * largest ? epsilon : epsilon * largest / value;
}

void set_rounding(const Matrix& values, Tangents& tangents, const Machine& machine) {
    const std::int64_t blocks = row_blocks(values.rows());
    Matrix squares(blocks, values.cols()), windows(blocks, values.cols());
    for_row_blocks(
        values.rows(), machine, [&](std::int64_t block, std::int64_t begin, std::int64_t rows) {
            for (std::int64_t i = begin; i < begin + rows; ++i)
                for (std::int64_t l = 0; l < tangents.rank[static_cast<std::size_t>(i)]; ++l) {
                    const double angle = rounding_of(values(i, l), values(i, 0));
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

/// Neighbors and tangents share distances where a window is at most so many times as large as a
/// neighborhood: beyond, most of two windows' distances would be needed by neither.
constexpr std::int64_t widest_shared = 4;

/// Block after block of frames, find(finder, first, last) for each.
template <class Find>
Tangents find_in_blocks(ConstMatrixView x, const Neighborhoods& neighborhoods,
                        const Parameters& parameters, const Progress& progress, std::int64_t block,
                        const Find& find) {
    const std::int64_t count = parameters.dimension;
    Tangents tangents{neighborhoods.size, count, {}, {}};
    tangents.g.resize(
        checked_size(checked_size(x.rows, count) > 0 ? x.rows * count : 0, neighborhoods.size));
    tangents.rank.resize(static_cast<std::size_t>(x.rows));
    const std::int64_t computed = std::min({count, neighborhoods.size, x.cols});
    Matrix values = Matrix::unset(x.rows, computed);
    const std::int64_t blocks = (x.rows + block - 1) / block;
    const auto work = [&](std::int64_t b) {
        TangentFinder finder(x, neighborhoods, computed, parameters.simd, values, tangents);
        find(finder, b * block, std::min((b + 1) * block, x.rows));
    };
    parallel_blocks(blocks, parameters.threads, work,
                    [&](std::int64_t done) { report(progress, done, blocks); });
    const Machine machine{parameters.simd, parameters.threads};
    drop_missing_directions(values, tangents, machine);
    set_rounding(values, tangents, machine);
    return tangents;
}

} // namespace

Tangents local_tangents(ConstMatrixView x, const Neighborhoods& neighborhoods,
                        const Parameters& parameters, const Progress& progress) {
    return find_in_blocks(
        x, neighborhoods, parameters, progress, TangentTrack::block,
        [&](TangentFinder& finder, std::int64_t first, std::int64_t last) {
            finder.find(first, last, NeighborhoodDistances(x, neighborhoods.size, parameters.simd));
        });
}

Tangents temporal_tangents(ConstMatrixView x, std::span<const std::int64_t> lengths,
                           const Parameters& parameters, const Progress& progress,
                           Neighborhoods& neighborhoods) {
    neighborhoods.size = parameters.neighbors;
    neighborhoods.index.resize(checked_size(x.rows, parameters.neighbors));
    const WindowNeighbors windows(lengths, parameters);
    const std::int64_t window = parameters.window;
    const bool shared = TangentFinder::takes_distances(neighborhoods.size, x.cols) &&
                        window <= widest_shared * neighborhoods.size;
    const auto find = [&](TangentFinder& finder, std::int64_t first, std::int64_t last) {
        if (shared) {
            // Frames of one neighborhood are at most two windows apart.
            const BandDistances distances(x, std::max<std::int64_t>(0, first - window),
                                          std::min(x.rows, last + window), 2 * window,
                                          parameters.simd);
            windows.select(distances, first, last, neighborhoods);
            finder.find(first, last, distances);
        } else {
            windows.select(x, parameters.simd, first, last, neighborhoods);
            finder.find(first, last, NeighborhoodDistances(x, neighborhoods.size, parameters.simd));
        }
    };
    const std::int64_t block =
        TangentTrack::block * (frame_block(window) / TangentTrack::block + 1);
    return find_in_blocks(x, neighborhoods, parameters, progress, block, find);
}

Matrix local_spectra(ConstMatrixView x, const Neighborhoods& neighborhoods, std::int64_t count,
                     std::int64_t stride, int threads, const Progress& progress) {
    const std::int64_t rows = (x.rows + stride - 1) / stride;
    const std::int64_t block = frame_block(0);
    const std::int64_t blocks = (rows + block - 1) / block;
    Matrix spectra(rows, count);
    const auto work = [&](std::int64_t b) {
        LocalPca pca(x, neighborhoods.size, count);
        for (std::int64_t r = b * block; r < std::min((b + 1) * block, rows); ++r) {
            pca.compute(neighborhoods.of(r * stride), [&x](std::int64_t p, std::int64_t q) {
                return squared_distance(x.row(p), x.row(q), x.cols);
            });
            for (std::int64_t l = 0; l < count; ++l)
                spectra(r, l) = std::max(0.0, pca.value(l));
        }
    };
    parallel_blocks(blocks, threads, work,
                    [&](std::int64_t done) { report(progress, done, blocks); });
    return spectra;
}

} // namespace stltsa::ltsa
