// SPDX-License-Identifier: BSD-3-Clause
// Eigenpairs of very small symmetric matrices by Jacobi's method, one matrix per lane of P.
#pragma once

#include <algorithm>
#include <cstdint>

#include "linalg/pack.hpp"

namespace stltsa::ltsa {

/// Works on `data`, which has room for `order` values and two matrices of that order.
template <class P>
class SmallRitz {
  public:
    STLTSA_INLINE SmallRitz(std::int64_t order, P* data)
        : order_(order), values_(data), matrix_(data + order), vectors_(matrix_ + order * order) {}

    STLTSA_INLINE void set(std::int64_t i, std::int64_t j, P entry) const {
        matrix_[i * order_ + j] = matrix_[j * order_ + i] = entry;
    }
    /// Descending, valid after solve(), which destroys the matrix.
    STLTSA_INLINE P value(std::int64_t i) const { return values_[i]; }

    STLTSA_INLINE void solve() const {
        for (std::int64_t i = 0; i < order_ * order_; ++i)
            vectors_[i] = P{} + (i % (order_ + 1) == 0 ? 1.0 : 0.0);
        for (int done = 0; done < most_sweeps; ++done) {
            P largest{};
            for (std::int64_t i = 0; i < order_; ++i)
                for (std::int64_t j = i + 1; j < order_; ++j) {
                    const P size = magnitude(matrix_[i * order_ + j]);
                    largest = size > largest ? size : largest;
                }
            if (!any_above(largest, negligible))
                break;
            sweep();
        }
        for (std::int64_t i = 0; i < order_; ++i)
            values_[i] = matrix_[i * order_ + i];
        sort();
    }

    /// Multiplies the row whose entries are `stride` apart by the eigenvectors.
    STLTSA_INLINE void rotate(P* row, std::int64_t stride) const {
        P* turned = matrix_; // no longer needed
        for (std::int64_t j = 0; j < order_; ++j)
            turned[j] = row[0] * vectors_[j];
        for (std::int64_t i = 1; i < order_; ++i)
            for (std::int64_t j = 0; j < order_; ++j)
                turned[j] += row[i * stride] * vectors_[i * order_ + j];
        for (std::int64_t j = 0; j < order_; ++j)
            row[j * stride] = turned[j];
    }

  private:
    /// Off-diagonal entries below this are taken as zero; matrices have a trace of at most 1. The
    /// sweeps that other lanes need do not change a lane whose entries are all zero.
    static constexpr double negligible = 1e-18;
    static constexpr int most_sweeps = 12;

    STLTSA_INLINE static bool any_above(P v, double limit) {
        bool any = false;
        for (unsigned l = 0; l < sizeof(P) / sizeof(double); ++l)
            any = any || v[l] > limit;
        return any;
    }

    /// Rotates every pair once, in rounds of disjoint pairs as in a round-robin tournament, so that
    /// the rotations of a round do not depend on each other.
    STLTSA_INLINE void sweep() const {
        const std::int64_t ring = order_ - 1 + order_ % 2;
        for (std::int64_t round = 0; round < ring; ++round)
            for (std::int64_t pair = 0; pair <= ring / 2; ++pair) {
                const std::int64_t a = pair == 0 ? ring : (round + pair) % ring;
                const std::int64_t b = (round + ring - pair) % ring;
                if (a < order_) // else b has no partner in this round
                    annihilate(std::min(a, b), std::max(a, b));
            }
    }

    /// Rotates so that the entry (i, j) becomes zero.
    STLTSA_INLINE void annihilate(std::int64_t i, std::int64_t j) const {
        const P one = P{} + 1.0;
        const P entry = matrix_[i * order_ + j];
        const P twice = entry + entry;
        const P difference = matrix_[j * order_ + j] - matrix_[i * order_ + i];
        const P root = square_root(difference * difference + twice * twice);
        const P full = twice / (difference < 0 ? difference - root : difference + root);
        const P tangent = magnitude(entry) > negligible ? full : P{};
        const P cosine = one / square_root(one + tangent * tangent);
        const P sine = tangent * cosine;
        for (std::int64_t l = 0; l < order_; ++l) {
            turn(matrix_[l * order_ + i], matrix_[l * order_ + j], cosine, sine);
            turn(vectors_[l * order_ + i], vectors_[l * order_ + j], cosine, sine);
        }
        for (std::int64_t l = 0; l < order_; ++l)
            turn(matrix_[i * order_ + l], matrix_[j * order_ + l], cosine, sine);
    }

    STLTSA_INLINE static void turn(P& a, P& b, P cosine, P sine) {
        const P before = a;
        a = cosine * before - sine * b;
        b = sine * before + cosine * b;
    }

    STLTSA_INLINE void sort() const {
        for (std::int64_t i = 0; i < order_; ++i)
            for (std::int64_t j = i + 1; j < order_; ++j) {
                const auto out_of_order = values_[i] < values_[j];
                exchange(out_of_order, values_[i], values_[j]);
                for (std::int64_t l = 0; l < order_; ++l)
                    exchange(out_of_order, vectors_[l * order_ + i], vectors_[l * order_ + j]);
            }
    }

    template <class Mask>
    STLTSA_INLINE static void exchange(Mask out_of_order, P& a, P& b) {
        const P before = a;
        a = out_of_order ? b : a;
        b = out_of_order ? before : b;
    }

    std::int64_t order_;
    P* values_;
    P* matrix_;
    P* vectors_;
};

} // namespace stltsa::ltsa
