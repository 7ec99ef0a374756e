// SPDX-License-Identifier: BSD-3-Clause
// Second moments of the frames of a neighborhood, updated from one neighborhood to the next by the
// frames that enter and leave.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "neighbors.hpp"
#include "scalar.hpp"
#include "vectors.hpp"

namespace reference {

/// Neighborhoods between fresh sums of the moments. In double-double, rounding errors stay
/// negligible over this many; other scalars sum each neighborhood from scratch.
template <class T>
inline constexpr std::size_t neighborhoods_of_a_sum = 1;
template <>
inline constexpr std::size_t neighborhoods_of_a_sum<dd> = 64;

template <class T>
class Moments {
  public:
    explicit Moments(const Frames& x) : x_(x), sum_(x.cols), squares_(x.cols, x.cols) {}

    /// Moves to the neighborhood with the k neighbors p.
    void move_to(const std::size_t* p, std::size_t k) {
        if (age_++ % neighborhoods_of_a_sum<T> == 0) {
            members_.clear();
            origin_ = p[k / 2];
            std::fill(sum_.begin(), sum_.end(), T(0));
            std::fill(squares_.values.begin(), squares_.values.end(), T(0));
        }
        std::vector<std::size_t> left;
        std::set_difference(members_.begin(), members_.end(), p, p + k, std::back_inserter(left));
        std::vector<std::size_t> come;
        std::set_difference(p, p + k, members_.begin(), members_.end(), std::back_inserter(come));
        for (const std::size_t frame : left)
            add(frame, T(-1));
        for (const std::size_t frame : come)
            add(frame, T(1));
        members_.assign(p, p + k);
    }

    /// Sum of (x - mean) (x - mean)^T.
    Table<T> scatter() const {
        Table<T> result = squares_;
        const T share = T(-1) / T(static_cast<double>(members_.size()));
        for (std::size_t a = 0; a < x_.cols; ++a) {
            add_scaled(result.row(a), share * sum_[a], sum_.data(), x_.cols);
            for (std::size_t b = a + 1; b < x_.cols; ++b)
                result(a, b) = T(0); // set below
        }
        for (std::size_t a = 0; a < x_.cols; ++a)
            for (std::size_t b = a + 1; b < x_.cols; ++b)
                result(a, b) = result(b, a);
        return result;
    }

  private:
    void add(std::size_t frame, T sign) {
        std::vector<T> term(x_.cols);
        for (std::size_t c = 0; c < x_.cols; ++c)
            term[c] = T(x_(frame, c)) - T(x_(origin_, c));
        add_scaled(sum_.data(), sign, static_cast<const T*>(term.data()), x_.cols);
        for (std::size_t a = 0; a < x_.cols; ++a)
            add_scaled(squares_.row(a), sign * term[a], static_cast<const T*>(term.data()), a + 1);
    }

    const Frames& x_;
    std::vector<T> sum_;
    Table<T> squares_; ///< lower triangle
    std::vector<std::size_t> members_;
    std::size_t origin_ = 0;
    std::size_t age_ = 0;
};

} // namespace reference
