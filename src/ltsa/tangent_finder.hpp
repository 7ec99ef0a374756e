// SPDX-License-Identifier: BSD-3-Clause
// The tangents of some frames' neighborhoods, by whichever way finds them soonest and well.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "linalg/matrix.hpp"
#include "ltsa/local_pca.hpp"
#include "ltsa/local_svd.hpp"
#include "ltsa/neighbors.hpp"
#include "ltsa/tangent_batch.hpp"
#include "ltsa/tangent_track.hpp"
#include "ltsa/tangents.hpp"

namespace stltsa::ltsa {

/// Where an eigenvalue is a smaller share of the first one than this, the direction is computed
/// from the frames themselves: matrices of products have as many digits less of it. Motion is far
/// above, but for features of very different sizes.
inline constexpr double least_share_by_products = 1e-5;

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
    void find(std::int64_t first, std::int64_t last, Distance&& distance) {
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

    /// Small, but not so small that they are dropped whatever rounding did to them.
    bool has_small_directions(std::int64_t i) const {
        for (std::int64_t l = 1; l < computed_; ++l) {
            const double share = values_(i, l) / values_(i, 0);
            if (share < least_share_by_products && share > 0.1 * negligible_value)
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

} // namespace stltsa::ltsa
