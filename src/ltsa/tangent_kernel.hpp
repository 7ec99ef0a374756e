// SPDX-License-Identifier: BSD-3-Clause
// The arithmetic of TangentBatch, compiled once for each width of packs.
#pragma once

#include <algorithm>
#include <cstdint>

#include "linalg/pack.hpp"
#include "ltsa/small_ritz.hpp"
#include "ltsa/tangents.hpp"

namespace stltsa::ltsa {

/// Rows and columns of a product that are computed together: eight sums fit into the registers of
/// every machine.
inline constexpr std::int64_t product_rows = 4;
inline constexpr std::int64_t product_columns = 2;

/// Iterations between two Rayleigh-Ritz steps, and before a lane is given up.
inline constexpr std::int64_t ritz_interval = 3;
inline constexpr std::int64_t most_iterations = 60;

/// What rounding leaves of the residual of an eigenpair, relative to the largest eigenvalue.
inline constexpr double small_residual = 2e-15;

/// All arrays hold packs: entry i at [i]. Matrices of vectors are stored column after column.
struct TangentKernel {
    std::int64_t size, rows, columns, count;
    double* matrix_data;
    const double* start;
    double* block_data;
    double* product_data;
    double* small_data;
    double* values_data;
    double* vectors_data;

    template <int W>
    STLTSA_INLINE void run() const {
        using P = Pack<W>;
        const P trace = center<P>();
        const P scale = trace > 0 ? 1 / trace : P{};
        P* block = reinterpret_cast<P*>(block_data);
        for (std::int64_t i = 0; i < rows * columns; ++i)
            block[i] = P{} + start[i];
        reinterpret_cast<P*>(values_data)[count] = P{};
        for (std::int64_t step = 1; step <= most_iterations; ++step) {
            multiply<P>(scale);
            if (step % ritz_interval == 0) {
                rotate_to_ritz_vectors<P>();
                if (record<P>(trace))
                    return;
            }
            orthonormalize<P>();
        }
    }

    /// The correlation matrix from distances, -1/2 J D J with J = I - e e^T / k; its trace.
    template <class P>
    STLTSA_INLINE P center() const {
        P* matrix = reinterpret_cast<P*>(matrix_data);
        P* mean = reinterpret_cast<P*>(product_data);
        const double k = static_cast<double>(size);
        std::fill_n(mean, size, P{});
        for (std::int64_t a = 0; a < size; ++a) {
            matrix[a * rows + a] = P{};
            for (std::int64_t b = a + 1; b < size; ++b) {
                mean[a] += matrix[a * rows + b];
                mean[b] += matrix[a * rows + b];
            }
        }
        P total{};
        for (std::int64_t a = 0; a < size; ++a) {
            mean[a] /= k;
            total += mean[a];
        }
        total /= k;
        P trace{};
        for (std::int64_t a = 0; a < size; ++a) {
            const P shift = total - mean[a];
            for (std::int64_t b = a; b < size; ++b)
                matrix[a * rows + b] = matrix[b * rows + a] =
                    -0.5 * (matrix[a * rows + b] - mean[b] + shift);
            trace += matrix[a * rows + a];
        }
        return trace;
    }

    /// product := scale A block. Scaled, so that squares of its entries neither over- nor
    /// underflow.
    template <class P>
    STLTSA_INLINE void multiply(P scale) const {
        const P* matrix = reinterpret_cast<const P*>(matrix_data);
        const P* block = reinterpret_cast<const P*>(block_data);
        P* product = reinterpret_cast<P*>(product_data);
        for (std::int64_t a = 0; a < rows; a += product_rows)
            for (std::int64_t l = 0; l < columns; l += product_columns) {
                P sum[product_columns][product_rows] = {};
                for (std::int64_t b = 0; b < size; ++b)
                    for (std::int64_t i = 0; i < product_rows; ++i) {
                        // The matrix is symmetric: these are adjacent.
                        const P entry = matrix[b * rows + a + i];
                        for (std::int64_t j = 0; j < product_columns; ++j)
                            sum[j][i] += entry * block[(l + j) * rows + b];
                    }
                for (std::int64_t j = 0; j < product_columns; ++j)
                    for (std::int64_t i = 0; i < product_rows; ++i)
                        product[(l + j) * rows + a + i] = sum[j][i] * scale;
            }
    }

    template <class P>
    STLTSA_INLINE P inner(const P* a, const P* b) const {
        P even{}, odd{};
        for (std::int64_t i = 0; i < rows; i += 2) {
            even += a[i] * b[i];
            odd += a[i + 1] * b[i + 1];
        }
        return even + odd;
    }

    /// block := orthonormal basis of the product's columns (modified Gram-Schmidt). A column of
    /// zeros stays one.
    template <class P>
    STLTSA_INLINE void orthonormalize() const {
        const P* product = reinterpret_cast<const P*>(product_data);
        P* block = reinterpret_cast<P*>(block_data);
        for (std::int64_t l = 0; l < columns; ++l) {
            P* column = block + l * rows;
            std::copy_n(product + l * rows, rows, column);
            for (std::int64_t b = 0; b < l; ++b) {
                const P* other = block + b * rows;
                const P overlap = inner(other, static_cast<const P*>(column));
                for (std::int64_t a = 0; a < rows; ++a)
                    column[a] -= overlap * other[a];
            }
            const P norm = square_root(inner<P>(column, column));
            const P inverse = norm > 0 ? 1 / norm : P{};
            for (std::int64_t a = 0; a < rows; ++a)
                column[a] *= inverse;
        }
    }

    /// Turns block and product so that the columns are the best eigenvectors in their span.
    template <class P>
    STLTSA_INLINE void rotate_to_ritz_vectors() const {
        P* block = reinterpret_cast<P*>(block_data);
        P* product = reinterpret_cast<P*>(product_data);
        const SmallRitz<P> ritz(columns, reinterpret_cast<P*>(small_data));
        for (std::int64_t i = 0; i < columns; ++i)
            for (std::int64_t j = i; j < columns; ++j)
                ritz.set(i, j, inner<P>(block + i * rows, product + j * rows));
        ritz.solve();
        for (std::int64_t a = 0; a < rows; ++a) {
            ritz.rotate(block + a, rows);
            ritz.rotate(product + a, rows);
        }
    }

    /// Keeps the pairs of each lane whose residuals are small for the first time; true when no lane
    /// is left. The matrix is positive semidefinite, so an eigenvalue that the block has missed is
    /// at most what the Ritz values leave of the trace: below the last wanted one, or negligible,
    /// none was missed.
    template <class P>
    STLTSA_INLINE bool record(P trace) const {
        const P* block = reinterpret_cast<const P*>(block_data);
        const P* product = reinterpret_cast<const P*>(product_data);
        P* values = reinterpret_cast<P*>(values_data);
        P* vectors = reinterpret_cast<P*>(vectors_data);
        const SmallRitz<P> ritz(columns, reinterpret_cast<P*>(small_data));
        P worst{};
        for (std::int64_t l = 0; l < count; ++l) {
            P square{};
            for (std::int64_t a = 0; a < rows; ++a) {
                const P rest = product[l * rows + a] - ritz.value(l) * block[l * rows + a];
                square += rest * rest;
            }
            worst = square > worst ? square : worst;
        }
        P missed = P{} + 1.0;
        for (std::int64_t l = 0; l < columns; ++l)
            missed -= ritz.value(l);
        const P limit = small_residual * ritz.value(0);
        const P good = worst <= limit * limit ? P{} + 1.0 : P{};
        const P last = ritz.value(count - 1);
        const P noise = negligible_value * ritz.value(0);
        const P sure = missed <= (last > noise ? last : noise) ? good : P{};
        const P fresh = trace > 0 ? sure - values[count] : P{} + 1.0;
        for (std::int64_t l = 0; l < count; ++l) {
            values[l] = fresh > 0 ? ritz.value(l) * trace : values[l];
            for (std::int64_t a = 0; a < rows; ++a)
                vectors[l * rows + a] = fresh > 0 ? block[l * rows + a] : vectors[l * rows + a];
        }
        values[count] = fresh > 0 ? fresh : values[count];
        return all_positive(values[count]);
    }

    template <class P>
    STLTSA_INLINE static bool all_positive(P v) {
        bool all = true;
        for (unsigned l = 0; l < sizeof(P) / sizeof(double); ++l)
            all = all && v[l] > 0;
        return all;
    }
};

} // namespace stltsa::ltsa
