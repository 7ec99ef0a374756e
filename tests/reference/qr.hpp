// SPDX-License-Identifier: BSD-3-Clause
// A second algorithm for the same embedding: B' = M'^T M' with the stacked local projectors M' = M
// S, and the triangle R of M' = Q R from rotations (George and Heath, Linear Algebra Appl. 34,
// 1980), so that B' is never formed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "differences.hpp"

namespace reference {

/// An upper triangular band matrix into which rows are rotated.
class Triangle {
  public:
    Triangle(std::size_t rows, std::size_t half_width) : r_(rows, half_width + 1) {}

    std::size_t rows() const { return r_.rows; }

    /// `row` begins at column c, has room for half_width + 1 entries, and is overwritten.
    void append(std::size_t c, std::vector<double>& row) {
        for (; c < rows(); ++c) {
            const bool empty = r_(c, 0) == 0;
            if (row[0] != 0)
                rotate(r_.row(c), row.data());
            else if (std::all_of(row.begin(), row.end(), [](double entry) { return entry == 0; }))
                return;
            if (empty && r_(c, 0) != 0)
                return; // the row is used up
            std::move(row.begin() + 1, row.end(), row.begin());
            row.back() = 0;
        }
    }

    /// z becomes (R^T R)^-1 z.
    void solve(std::vector<double>& z) const {
        for (std::size_t c = 0; c < rows(); ++c) {
            z[c] /= r_(c, 0);
            add_scaled(z.data() + c + 1, -z[c], r_.row(c) + 1, beyond(c));
        }
        for (std::size_t c = rows(); c-- > 0;)
            z[c] = (z[c] - inner<double>(z.data() + c + 1, r_.row(c) + 1, beyond(c))) / r_(c, 0);
    }

  private:
    std::size_t beyond(std::size_t c) const { return std::min(rows() - 1 - c, r_.cols - 1); }

    /// Makes the first entry of `row` zero.
    void rotate(double* upper, double* row) const {
        const double length = std::hypot(upper[0], row[0]);
        const double c = upper[0] / length;
        const double s = row[0] / length;
        for (std::size_t i = 0; i < r_.cols; ++i) {
            const double old = upper[i];
            upper[i] = c * old + s * row[i];
            row[i] = c * row[i] - s * old;
        }
        row[0] = 0;
    }

    Table<double> r_; ///< row c holds the entries of the columns c, c + 1, ...
};

/// R of the local projectors in differences: entry (j, c) of a neighborhood's projector is [p_j >
/// c] - a(c) / k - sum_l g_l(j) h_l(c), with a and h as in add_neighborhood().
inline Triangle triangle_of(const Neighbors& neighbors, const Tangents<double>& tangents,
                            std::size_t d) {
    const std::size_t k = neighbors.cols;
    Triangle result(neighbors.rows - 1, widest_span(neighbors) - 1);
    std::vector<double> row(widest_span(neighbors));
    for (std::size_t i = 0; i < neighbors.rows; ++i) {
        const std::size_t* p = neighbors.row(i);
        const SuffixSums<double> sums(tangents, i, p, k, d);
        for (std::size_t j = 0; j < k; ++j) {
            std::fill(row.begin(), row.end(), 0.0);
            for (std::size_t c = 0; c < sums.span; ++c) {
                row[c] = (p[j] > p[0] + c ? 1.0 : 0.0) - sums.a[c] / static_cast<double>(k);
                for (std::size_t l = 0; l < d; ++l)
                    row[c] -= tangents.of(i, l)[j] * sums.h(l, c);
            }
            result.append(p[0], row);
        }
    }
    return result;
}

} // namespace reference
