// SPDX-License-Identifier: BSD-3-Clause
// Compares the reference with the definition: a dense alignment matrix B in binary128, tangents
// from the covariance of the channels instead of the Gram matrix, all eigenpairs by Jacobi.
#include <cstdio>
#include <cstdlib>

#include "reference.hpp"
#include "scalar.hpp"
#include "synthetic.hpp"

namespace {

using namespace reference;

int failures = 0;

void check(bool ok, const char* what, double value) {
    std::printf("%-58s %.2e  %s\n", what, value, ok ? "ok" : "FAILED");
    failures += ok ? 0 : 1;
}

/// Every neighbor is at least as near as every other frame of the window.
void neighbors_are_nearest(const Frames& x, const Neighbors& neighbors, std::size_t w) {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < x.rows; ++i) {
        const std::size_t* row = neighbors.row(i);
        const std::size_t* end = row + neighbors.cols;
        wrong += std::find(row, end, i) == end;
        for (std::size_t j = 0; j < x.rows; ++j) {
            const bool near = j + w >= i && j <= i + w;
            const bool chosen = std::find(row, end, j) != end;
            wrong += chosen && !near;
            for (const std::size_t* p = row; p != end && near && !chosen; ++p)
                wrong += squared_distance(x, i, j) < squared_distance(x, i, *p);
        }
    }
    check(wrong == 0, "neighbors out of place", static_cast<double>(wrong));
}

#ifdef REFERENCE_QUAD

using Dense = Table<quad>;

/// g_l = Z^T u_l / sqrt(theta_l) for the eigenpairs (theta_l, u_l) of Z Z^T (channels x channels).
Dense tangents_by_channels(const Frames& x, const std::size_t* p, std::size_t k, std::size_t d) {
    Dense z(x.cols, k);
    Dense covariance(x.cols, x.cols);
    for (std::size_t c = 0; c < x.cols; ++c) {
        quad mean = 0;
        for (std::size_t j = 0; j < k; ++j)
            mean += static_cast<quad>(x(p[j], c)) / static_cast<quad>(k);
        for (std::size_t j = 0; j < k; ++j)
            z(c, j) = static_cast<quad>(x(p[j], c)) - mean;
    }
    for (std::size_t a = 0; a < x.cols; ++a)
        for (std::size_t b = 0; b < x.cols; ++b)
            covariance(a, b) = inner(z.row(a), z.row(b), k);
    const auto eigen = symmetric_eigen(covariance);
    Dense g = combine(eigen.vectors, z, d);
    for (std::size_t l = 0; l < d; ++l)
        for (std::size_t j = 0; j < k; ++j)
            g(l, j) /= sqrt(eigen.values[l]);
    return g;
}

/// B(I_i, I_i) += I - G_i G_i^T with G_i = [e / sqrt(k), g_1 .. g_d]: step 4 of the paper's
/// Table 1.
Dense dense_alignment(const Frames& x, const Neighbors& neighbors, std::size_t d) {
    const std::size_t k = neighbors.cols;
    Dense matrix(x.rows, x.rows);
    for (std::size_t i = 0; i < x.rows; ++i) {
        const std::size_t* p = neighbors.row(i);
        const Dense g = tangents_by_channels(x, p, k, d);
        for (std::size_t a = 0; a < k; ++a)
            for (std::size_t b = 0; b < k; ++b) {
                quad entry = (a == b ? 1 : 0) - static_cast<quad>(1) / static_cast<quad>(k);
                for (std::size_t l = 0; l < d; ++l)
                    entry -= g(l, a) * g(l, b);
                matrix(p[a], p[b]) += entry;
            }
    }
    return matrix;
}

dd rounded(quad a) {
    const double high = static_cast<double>(a);
    return quick_two_sum(high, static_cast<double>(a - static_cast<quad>(high)));
}

/// Compares in double: with so few frames a shift does little harm.
void check_other_ways(const Neighbors& neighbors, const Tangents<double>& local, std::size_t d,
                      const Table<dd>& truth) {
    const auto angle_to = [&truth](const Table<double>& coords) {
        return static_cast<double>(largest_angle(truth, widened(coords)));
    };
    const double plain = angle_to(embed(neighbors, local, d).coords);
    check(plain < 1e-8, "Cholesky in double", plain);
    const double rotated = angle_to(embed_by_rotations(neighbors, local, d).coords);
    check(rotated < 1e-11, "rotations in double", rotated);
    const auto shifted = embed_by_shift(neighbors, local, d, 1e-12);
    const double by_shift = shifted ? angle_to(*shifted) : 1;
    check(by_shift < 1e-7, "B plus a shift, in double", by_shift);
}

void against_definition(const Frames& x, std::size_t k, std::size_t w, std::size_t most) {
    const Neighbors neighbors = temporal_neighbors(x, k, w);
    neighbors_are_nearest(x, neighbors, w);
    const Tangents<dd> local = local_tangents<dd>(x, neighbors, most);
    const Tangents<double> plain = local_tangents<double>(x, neighbors, most);
    for (std::size_t d = 1; d <= most; ++d) {
        const auto dense = symmetric_eigen(dense_alignment(x, neighbors, d));
        const Spectrum<dd> embedding = embed(neighbors, local, d);
        Table<dd> coords(d, x.rows);
        double worst = 0;
        for (std::size_t v = 0; v < d; ++v) {
            const std::size_t from_end = x.rows - 2 - v; // the last one is lambda_1 = 0
            const dd lambda = rounded(dense.values[from_end]);
            worst = std::max(worst, static_cast<double>(abs(embedding.lambda[v] / lambda - dd(1))));
            for (std::size_t i = 0; i < x.rows; ++i)
                coords(v, i) = rounded(dense.vectors(from_end, i));
        }
        std::printf("n = %zu, k = %zu, w = %zu, d = %zu:\n", x.rows, k, w, d);
        check(worst < 1e-24, "eigenvalues against dense B, relative", worst);
        const double angle = static_cast<double>(largest_angle(embedding.coords, coords));
        check(angle < 1e-24, "angle to the eigenvectors of dense B", angle);
        check_other_ways(neighbors, plain, d, coords);
    }
}

#endif

/// Two planes that differ by a rotation of known angle.
void angle_is_measured() {
    const double tiny = 0x1p-66;
    Table<dd> a(2, 4);
    Table<dd> b(2, 4);
    a(0, 0) = a(1, 1) = b(0, 0) = b(1, 1) = dd(1);
    b(0, 2) = dd(tiny);
    b(1, 0) = dd(3); // another basis of the same plane: row 1 plus 3 times row 0
    b(1, 2) = dd(3 * tiny);
    const double angle = static_cast<double>(largest_angle(a, b));
    check(std::abs(angle / tiny - 1) < 1e-9, "an angle of 2^-66 as measured", angle);
}

} // namespace

int main() {
    angle_is_measured();
#ifdef REFERENCE_QUAD
    // More channels than neighbors, then fewer: covers both Gram matrices of the local step.
    against_definition(smooth_curve(48, 12, 0.1, 7), 8, 8, 3);
    against_definition(smooth_curve(48, 6, 0.1, 7), 8, 8, 3);
    against_definition(smooth_curve(50, 5, 0.05, 8), 7, 10, 2);
    // Long enough to require a fresh sum of the moments.
    against_definition(smooth_curve(90, 6, 0.1, 9), 12, 12, 2);
#else
    std::printf("no binary128 on this machine: the dense comparison is left out\n");
#endif
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
