// SPDX-License-Identifier: BSD-3-Clause
// Local tangents: the d leading right singular vectors of each neighborhood's centered frames
// (Zhang and Zha 2004; steps 2 and 3 of Table 1 in Li, Niu, Zhang, Hu 2012), from the eigenvectors
// of the smaller of its two Gram matrices.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

#include "leading.hpp"
#include "moments.hpp"
#include "neighbors.hpp"
#include "vectors.hpp"

namespace reference {

/// Row i * d + l holds g_l of frame i, one entry per neighbor.
template <class T>
struct Tangents {
    std::size_t dimension = 0;
    Table<T> g;
    const T* of(std::size_t frame, std::size_t l) const { return g.row(frame * dimension + l); }
    T* of(std::size_t frame, std::size_t l) { return g.row(frame * dimension + l); }
};

/// Channels x neighbors, each channel centered.
template <class T>
Table<T> centered(const Frames& x, const std::size_t* neighbors, std::size_t k) {
    Table<T> z(x.cols, k);
    for (std::size_t c = 0; c < x.cols; ++c) {
        T mean(0);
        for (std::size_t j = 0; j < k; ++j)
            mean += T(x(neighbors[j], c));
        mean /= T(static_cast<double>(k));
        for (std::size_t j = 0; j < k; ++j)
            z(c, j) = T(x(neighbors[j], c)) - mean;
    }
    return z;
}

/// Z^T Z, neighbors x neighbors.
template <class T>
Table<T> gram(const Table<T>& z) {
    Table<T> result(z.cols, z.cols);
    for (std::size_t c = 0; c < z.rows; ++c)
        for (std::size_t i = 0; i < z.cols; ++i)
            add_scaled(result.row(i), z(c, i), z.row(c), z.cols);
    return result;
}

/// Z^T u / |Z^T u|
template <class T>
void project(const Table<T>& z, const T* u, T* g) {
    std::fill_n(g, z.cols, T(0));
    for (std::size_t c = 0; c < z.rows; ++c)
        add_scaled(g, u[c], z.row(c), z.cols);
    const T scale = T(1) / sqrt(inner<T>(g, g, z.cols));
    for (std::size_t j = 0; j < z.cols; ++j)
        g[j] *= scale;
}

template <class T>
Tangents<T> tangents(const Frames& x, const Neighbors& neighbors, std::size_t d) {
    const std::size_t k = neighbors.cols;
    Tangents<T> result{d, Table<T>(x.rows * d, k)};
    Moments<T> moments(x);
    for (std::size_t i = 0; i < x.rows; ++i) {
        const Table<T> z = centered<T>(x, neighbors.row(i), k);
        if (k > x.cols)
            moments.move_to(neighbors.row(i), k);
        const auto eigen = leading_eigenpairs(k > x.cols ? moments.scatter() : gram(z), d);
        if (!(eigen.values[d - 1] > eigen.values[0] * T(1e-13)))
            throw std::runtime_error("the neighborhood of frame " + std::to_string(i) +
                                     " has fewer than d directions");
        for (std::size_t l = 0; l < d; ++l)
            if (k > x.cols)
                project(z, eigen.vectors.row(l), result.of(i, l));
            else
                std::copy_n(eigen.vectors.row(l), k, result.of(i, l));
    }
    return result;
}

} // namespace reference
