// SPDX-License-Identifier: BSD-3-Clause
// Block iteration for the leading eigenvectors of positive semidefinite matrices (Table 1, step 2),
// one matrix per lane of a pack: V := orthonormal basis of A V, with an occasional Rayleigh-Ritz
// step (the best eigenvectors in the span of V), as in H. Rutishauser, "Computational aspects of
// F. L. Bauer's simultaneous iteration method", Numer. Math. 13 (1969). Compiled once for each
// width of packs.
#pragma once

#include <algorithm>
#include <cstdint>

#include "linalg/pack.hpp"
#include "ltsa/tangents/small_ritz.hpp"

namespace stltsa::ltsa {

/// Rows and columns of a tile of the product: eight sums fit into the registers of every machine.
inline constexpr std::int64_t product_rows = 4;
inline constexpr std::int64_t product_columns = 2;

/// Rayleigh-Ritz steps are made at iterations 5, 9, 12, 15, ...: the fastest choice for windows of
/// 12 to 140 frames. Smooth synthetic motion converges within 5 iterations, recorded motion in 9
/// to 17. Starting from the vectors of the previous window, or from polynomials in time, saves at
/// most one.
inline constexpr std::int64_t early_ritz = 5;
inline constexpr std::int64_t first_ritz = 9;
inline constexpr std::int64_t ritz_interval = 3;

/// Iterations after which a lane is abandoned.
inline constexpr std::int64_t most_iterations = 60;

/// A lane is abandoned after this many iterations if the trace that the block misses exceeds the
/// last wanted eigenvalue by this factor: on noise, the iteration could never exclude a missed
/// eigenvalue.
inline constexpr std::int64_t iterations_for_noise = first_ritz;
inline constexpr double abandon_factor = 2;

/// Eigenvalues below this share of the largest are rounding noise, not directions: they belong to
/// deviations smaller by 3e-7, about the precision of 32-bit numbers.
inline constexpr double negligible_value = 1e-13;

/// Residual of an eigenpair that rounding leaves, relative to the largest eigenvalue.
inline constexpr double small_residual = 2e-15;

/// Works on the arrays of an EigenBatch, whose entries are packs. The matrix is rows x rows, zero
/// beyond `size`; vectors are stored in columns of `rows` entries.
struct BlockIteration {
    std::int64_t size, rows, columns, count;
    const double* start_data; ///< the initial block of all lanes, as numbers
    double* matrix_data;
    double* block_data;
    double* product_data;
    double* small_data;
    double* values_data; ///< count eigenvalues, then a state: 0 iterating, 1 found, -1 abandoned
    double* vectors_data;

    /// Iterates from the start until every lane has its eigenvectors or is abandoned.
    template <class P>
    STLTSA_INLINE void iterate() const {
        begin<P>();
        const P trace = this->trace<P>();
        const P scale = trace > 0 ? 1 / trace : P{};
        reinterpret_cast<P*>(values_data)[count] = P{};
        for (std::int64_t step = 1; step <= most_iterations; ++step) {
            multiply<P>(scale);
            if (is_ritz(step)) {
                rotate_to_ritz_vectors<P>();
                if (record<P>(trace, step >= iterations_for_noise))
                    return;
            }
            orthonormalize<P>(product_data);
            // Twice before a Rayleigh-Ritz step: with a single large eigenvalue, one pass leaves
            // too much of the large columns in the small ones.
            if (is_ritz(step + 1))
                orthonormalize<P>(block_data);
        }
    }

  private:
    template <class P>
    STLTSA_INLINE void begin() const {
        P* block = reinterpret_cast<P*>(block_data);
        for (std::int64_t i = 0; i < rows * columns; ++i)
            block[i] = P{} + start_data[i];
    }

    template <class P>
    STLTSA_INLINE P trace() const {
        const P* matrix = reinterpret_cast<const P*>(matrix_data);
        P sum{};
        for (std::int64_t a = 0; a < size; ++a)
            sum += matrix[a * rows + a];
        return sum;
    }

    static bool is_ritz(std::int64_t step) {
        return step == early_ritz ||
               (step >= first_ritz && (step - first_ritz) % ritz_interval == 0);
    }

    /// product := scale A block. The scale keeps squares of entries from over- and underflow.
    template <class P>
    STLTSA_INLINE void multiply(P scale) const {
        for (std::int64_t a = 0; a < rows; a += product_rows)
            for (std::int64_t l = 0; l < columns; l += product_columns)
                multiply_tile(scale, a, l);
    }

    template <class P>
    STLTSA_INLINE void multiply_tile(P scale, std::int64_t a, std::int64_t l) const {
        const P* matrix = reinterpret_cast<const P*>(matrix_data) + a * rows;
        const P* block = reinterpret_cast<const P*>(block_data) + l * rows;
        P* product = reinterpret_cast<P*>(product_data) + l * rows + a;
        P sum[product_columns][product_rows] = {};
        for (std::int64_t b = 0; b < size; ++b)
            for (std::int64_t i = 0; i < product_rows; ++i) {
                const P entry = matrix[i * rows + b];
                for (std::int64_t j = 0; j < product_columns; ++j)
                    sum[j][i] += entry * block[j * rows + b];
            }
        for (std::int64_t j = 0; j < product_columns; ++j)
            for (std::int64_t i = 0; i < product_rows; ++i)
                product[j * rows + i] = sum[j][i] * scale;
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

    /// block := orthonormal basis of these columns, of the product or of the block itself, by
    /// modified Gram-Schmidt. A zero column stays zero.
    template <class P>
    STLTSA_INLINE void orthonormalize(const double* columns_data) const {
        const P* from = reinterpret_cast<const P*>(columns_data);
        P* block = reinterpret_cast<P*>(block_data);
        for (std::int64_t l = 0; l < columns; ++l) {
            P* column = block + l * rows;
            if (from != block)
                std::copy_n(from + l * rows, rows, column);
            for (std::int64_t b = 0; b < l; ++b)
                subtract(inner<P>(block + b * rows, column), block + b * rows, column);
            const P norm = square_root(inner<P>(column, column));
            scale(norm > 0 ? 1 / norm : P{}, column);
        }
    }

    template <class P>
    STLTSA_INLINE void subtract(P factor, const P* other, P* column) const {
        for (std::int64_t a = 0; a < rows; ++a)
            column[a] -= factor * other[a];
    }
    template <class P>
    STLTSA_INLINE void scale(P factor, P* column) const {
        for (std::int64_t a = 0; a < rows; ++a)
            column[a] *= factor;
    }

    /// Replaces the block by the best eigenvectors in its span, and the product accordingly.
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

    /// Keeps the pairs of each lane whose residuals have become small and marks the lane with 1, or
    /// with -1 if it is abandoned; true if no lane is left. The matrix is positive semidefinite, so
    /// a missed eigenvalue is at most the trace minus the Ritz values: if that is below the last
    /// wanted eigenvalue, or negligible, none was missed.
    template <class P>
    STLTSA_INLINE bool record(P trace, bool may_abandon) const {
        const P* block = reinterpret_cast<const P*>(block_data);
        const P* product = reinterpret_cast<const P*>(product_data);
        P* values = reinterpret_cast<P*>(values_data);
        P* vectors = reinterpret_cast<P*>(vectors_data);
        const SmallRitz<P> ritz(columns, reinterpret_cast<P*>(small_data));
        P worst{};
        for (std::int64_t l = 0; l < count; ++l) {
            P square{};
            for (std::int64_t a = 0; a < rows; ++a) {
                const P residual = product[l * rows + a] - ritz.value(l) * block[l * rows + a];
                square += residual * residual;
            }
            worst = square > worst ? square : worst;
        }
        P missed = P{} + 1.0;
        for (std::int64_t l = 0; l < columns; ++l)
            missed -= ritz.value(l);
        const P limit = small_residual * ritz.value(0);
        const P converged = worst <= limit * limit ? P{} + 1.0 : P{};
        const P last = ritz.value(count - 1);
        const P noise = negligible_value * ritz.value(0);
        const P least = last > noise ? last : noise;
        const P complete = missed <= least ? converged : P{};
        const P state = values[count];
        const P newly_found = state == 0.0 ? complete : P{};
        for (std::int64_t l = 0; l < count; ++l)
            values[l] = newly_found > 0 ? ritz.value(l) * trace : values[l];
        for (std::int64_t i = 0; i < count * rows; ++i)
            vectors[i] = newly_found > 0 ? block[i] : vectors[i];
        P updated = newly_found > 0 ? newly_found : state;
        if (may_abandon)
            updated =
                updated == 0.0 ? (missed > abandon_factor * least ? P{} - 1.0 : updated) : updated;
        values[count] = updated;
        return all_done(updated);
    }

    template <class P>
    STLTSA_INLINE static bool all_done(P v) {
        bool none = true;
        for (unsigned l = 0; l < sizeof(P) / sizeof(double); ++l)
            none = none && v[l] != 0.0;
        return none;
    }
};

} // namespace stltsa::ltsa
