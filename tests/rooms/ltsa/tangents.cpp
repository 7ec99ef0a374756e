// SPDX-License-Identifier: BSD-3-Clause
// Compares tangents found in batches with those of LAPACK.
#include <algorithm>
#include <limits>

#include "linalg/blas_threads.hpp"
#include "linalg/simd.hpp"
#include "ltsa/neighbors/neighborhood_distances.hpp"
#include "ltsa/tangents/covariance_batch.hpp"
#include "ltsa/tangents/finder.hpp"
#include "ltsa/tangents/gram_batch.hpp"
#include "ltsa/tangents/local_pca.hpp"
#include "ltsa/tangents/local_tangents.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::ltsa::CovarianceBatch;
using stltsa::ltsa::GramBatch;
using stltsa::ltsa::LocalPca;
using stltsa::ltsa::Neighborhoods;
using stltsa::ltsa::Parameters;
using stltsa::ltsa::Tangents;

constexpr std::int64_t features = 40;

/// Every window has one direction, orthogonal to all polynomials of low degree that are even about
/// the middle of the window.
Matrix alternation(std::int64_t frames) {
    Matrix x(frames, features);
    for (std::int64_t i = 0; i < frames; ++i)
        x(i, 0) = i % 2 == 0 ? 1 : -1;
    return x;
}

Neighborhoods windows(std::int64_t frames, std::int64_t size) {
    Neighborhoods result{size, {}};
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t j = 0; j < size; ++j)
            result.index.push_back(
                static_cast<std::int32_t>(std::clamp(i - size / 2, 0L, frames - size) + j));
    return result;
}

Tangents tangents_of(const Matrix& x, std::int64_t size, int dimension, Simd simd) {
    Parameters parameters;
    parameters.neighbors = parameters.window = size;
    parameters.dimension = dimension;
    parameters.simd = simd;
    return local_tangents(x.view(), windows(x.rows(), size), parameters);
}

/// Residual of LAPACK's tangents outside the computed ones, over all windows. Needs well-separated
/// eigenvalues.
double largest_difference(const Matrix& x, std::int64_t size, int dimension) {
    const Tangents tangents = tangents_of(x, size, dimension, stltsa::widest_simd());
    const Neighborhoods neighborhoods = windows(x.rows(), size);
    LocalPca pca(x.view(), size, dimension, Simd::baseline);
    double worst = 0;
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        pca.compute(neighborhoods.of(i));
        Matrix expected(dimension, size);
        for (std::int64_t l = 0; l < dimension; ++l) {
            pca.direction(l, expected.row(l), expected.row(0));
            for (std::int64_t b = 0; b < dimension; ++b) {
                const double* g = tangents.direction(i, b);
                stltsa::axpy(-stltsa::dot(g, expected.row(l), size), g, expected.row(l), size);
            }
        }
        for (std::int64_t l = 0; l < tangents.rank[static_cast<std::size_t>(i)]; ++l)
            worst = std::max(worst, stltsa::dot(expected.row(l), expected.row(l), size));
    }
    return std::sqrt(worst);
}

void tangents_are_those_of_lapack(void**) {
    for (const std::int64_t size : {5, 8, 12, 33, 40, 41, 60, 140})
        for (int dimension = 1; dimension <= 3; ++dimension) {
            ASSERT_NEAR(largest_difference(cyclic(200, features), size, dimension), 0, 1e-9);
            ASSERT_NEAR(largest_difference(noise(200, features), size, dimension), 0, 1e-9);
        }
}

/// Orthonormal polynomials of 0 .. size - 1, of degree 0, 1, .. in the rows.
Matrix polynomials(std::int64_t degrees, std::int64_t size) {
    Matrix rows(degrees, size);
    for (std::int64_t l = 0; l < degrees; ++l) {
        double* p = rows.row(l);
        for (std::int64_t a = 0; a < size; ++a)
            p[a] = l == 0 ? 1 : rows(l - 1, a) * static_cast<double>(2 * a - size + 1);
        for (int pass = 0; pass < 2; ++pass)
            for (std::int64_t b = 0; b < l; ++b)
                stltsa::axpy(-stltsa::dot(rows.row(b), p, size), rows.row(b), p, size);
        const double norm = std::sqrt(stltsa::dot(p, p, size));
        for (std::int64_t a = 0; a < size; ++a)
            p[a] /= norm;
    }
    return rows;
}

/// Neighborhoods that are too large for distances, of frames that are too wide for covariances.
void large_neighborhoods_of_wide_frames(void**) {
    constexpr std::int64_t size = 140, width = 300, count = 3;
    assert_false(stltsa::ltsa::TangentFinder::takes_distances(size, width));
    assert_false(CovarianceBatch::worth_while(size, width));
    const Matrix direction = polynomials(count + 1, size);
    Matrix x(size, width);
    for (std::int64_t l = 0; l < count; ++l)
        for (std::int64_t a = 0; a < size; ++a)
            for (std::int64_t c = 0; c < 90; ++c)
                x(a, 100 * l + c) = direction(l + 1, a) / static_cast<double>(1 + l);
    const Tangents tangents = tangents_of(x, size, count, stltsa::widest_simd());
    for (std::int64_t i = 0; i < size; ++i) {
        assert_int_equal(tangents.rank[static_cast<std::size_t>(i)], count);
        for (std::int64_t l = 0; l < count; ++l)
            ASSERT_NEAR(std::abs(stltsa::dot(tangents.direction(i, l), direction.row(l + 1), size)),
                        1, 1e-12);
    }
}

/// Polynomials of time in separate features, which are the principal directions. The rounding of
/// the small ones is known.
void features_of_uneven_size(void**) {
    constexpr std::int64_t count = 3;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double all_sizes[][count] = {{1, 0.1, 0.02}, {1, 4e-3, 3e-6}, {1e4, 1, 3e-2}};
    for (const auto& sizes : all_sizes)
        for (const std::int64_t size : {12, 33, 60, 140}) {
            const Matrix direction = polynomials(count + 1, size);
            Matrix x(size, features);
            for (std::int64_t l = 0; l < count; ++l)
                for (std::int64_t a = 0; a < size; ++a)
                    for (std::int64_t c = 0; c < 9; ++c)
                        x(a, 10 * l + c) =
                            sizes[l] * static_cast<double>(1 + c) * direction(l + 1, a);
            const Tangents tangents = tangents_of(x, size, count, stltsa::widest_simd());
            for (std::int64_t l = 0; l < count; ++l) {
                const double rounding = epsilon * std::pow(sizes[0] / sizes[l], 2);
                ASSERT_NEAR(tangents.rounding[static_cast<std::size_t>(l)] / rounding, 1, 1e-3);
                ASSERT_NEAR(std::abs(stltsa::dot(tangents.direction(size / 2, l),
                                                 direction.row(l + 1), size)),
                            1, 1e-14 + rounding);
            }
        }
}

void a_direction_that_the_start_lacks_is_found(void**) {
    for (const std::int64_t size : {5, 7, 12}) {
        const Tangents tangents = tangents_of(alternation(50), size, 1, stltsa::widest_simd());
        for (std::int64_t i = 0; i < 50; ++i) {
            assert_int_equal(tangents.rank[static_cast<std::size_t>(i)], 1);
            const double* g = tangents.direction(i, 0);
            for (std::int64_t j = 2; j < size; ++j)
                ASSERT_NEAR(g[j], g[j - 2], 1e-14);
        }
    }
}

void windows_that_do_not_vary_have_no_direction(void**) {
    const Tangents tangents = tangents_of(Matrix(50, features), 12, 2, stltsa::widest_simd());
    for (const double g : tangents.g)
        ASSERT_NEAR(g, 0, 0);
    const Tangents line = tangents_of(alternation(50), 12, 2, stltsa::widest_simd());
    for (const std::int32_t rank : line.rank)
        assert_int_equal(rank, 1);
}

/// Standing still except for rounding, like positions computed with matrices.
void rounding_noise_has_no_direction(void**) {
    for (const std::int64_t size : {12, 40, 60}) {
        Matrix x = cyclic(400, features);
        const Matrix rounding = noise(200, features);
        for (std::int64_t i = 100; i < 300; ++i)
            for (std::int64_t c = 0; c < features; ++c)
                x(i, c) = x(100, c) + 1e-15 * rounding(i - 100, c);
        const Tangents tangents = tangents_of(x, size, 2, stltsa::widest_simd());
        assert_int_equal(tangents.rank[200], 0);
        assert_int_equal(tangents.rank[30], 2);
    }
}

/// Motion is found in batches, noise one window at a time; numbers may have any magnitude.
void lanes_that_converge_are_known(void**) {
    for (const double scale : {1e-140, 1.0, 1e100}) {
        GramBatch batch(7, 1, stltsa::widest_simd());
        for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
            for (std::int64_t a = 0; a < 7; ++a)
                for (std::int64_t b = a + 1; b < 7; ++b)
                    // Lane 0: a straight line. The others: a simplex, with all directions equal.
                    batch.set_distance(
                        lane, a, b, scale * scale * (lane == 0 ? double((b - a) * (b - a)) : 1.0));
        batch.solve();
        for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
            assert_int_equal(batch.found(lane), lane == 0);
        ASSERT_NEAR(batch.value(0, 0) / (scale * scale), 28, 1e-12);
    }
}

/// Points on the axes, with eigenvalues about these squares: two of them dominate.
template <class Square>
void check_found(std::int64_t size, const Square& square, double second) {
    GramBatch batch(size, 2, stltsa::widest_simd());
    for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
        for (std::int64_t a = 0; a < size; ++a)
            for (std::int64_t b = a + 1; b < size; ++b)
                batch.set_distance(lane, a, b, square(a) + square(b));
    batch.solve();
    for (std::int64_t lane = 0; lane < batch.lanes(); ++lane) {
        assert_true(batch.found(lane));
        ASSERT_NEAR(batch.value(lane, 1), second, 0.1);
    }
}

/// These need more iterations than noise is allowed.
void slow_lanes_are_found(void**) {
    check_found(
        37, [](std::int64_t a) { return a < 2 ? 1 / double(1 + a) : 0.12 * std::pow(0.8, a - 2); },
        0.5);
}

void distances_within_a_neighborhood_are_those_of_frames(void**) {
    for (const std::int64_t size : {2, 8, 13, 40}) {
        const Matrix x = noise(2 * size, features);
        std::vector<std::int32_t> members;
        for (std::int32_t i = 0; i < size; ++i)
            members.push_back(2 * i + i % 2);
        for (const Simd simd : instruction_sets()) {
            stltsa::ltsa::NeighborhoodDistances distances(x.view(), size, simd);
            const auto among = distances.among(members);
            for (std::int64_t b = 1; b < size; ++b)
                for (std::int64_t a = 0; a < b; ++a)
                    assert_true(among(a, b) == distances(members[static_cast<std::size_t>(a)],
                                                         members[static_cast<std::size_t>(b)]));
        }
    }
}

// Hard motions for covariance matrices of overlapping neighborhoods.
constexpr std::int64_t length = 400;

/// Moves, holds still except for a drift in one direction, and moves again.
Matrix stopping() {
    return sampled(length, features, 120, [](double t, std::int64_t c) {
        const double u = std::clamp(std::abs(t - 1.7) - 0.6, 0.0, 1.0);
        return u * u * (3 - 2 * u) * cyclic_pose(t, c) + 1e-3 * t * static_cast<double>(c);
    });
}

Matrix line() {
    return sampled(length, features, 120,
                   [](double t, std::int64_t c) { return std::sin(t) * static_cast<double>(c); });
}

/// One feature jumps between two levels, as angles do.
Matrix jumping() {
    Matrix x = cyclic(length, features);
    for (std::int64_t i = length / 2; i < length; ++i)
        x(i, 3) += 1000;
    return x;
}

/// One frame is an outlier.
Matrix spiked() {
    Matrix x = cyclic(length, features);
    x(length / 2, 3) += 1e5;
    return x;
}

Matrix moved(double offset) {
    return changed(cyclic(length, features), [offset](double value) { return value + offset; });
}

/// The number of windows that are left to LAPACK.
std::int64_t not_found(const Matrix& x, std::int64_t size, int dimension) {
    const Neighborhoods neighborhoods = windows(x.rows(), size);
    CovarianceBatch batch(x.view(), size, dimension, stltsa::widest_simd());
    std::int64_t count = 0;
    for (std::int64_t i = 0; i < x.rows(); i += batch.lanes()) {
        batch.begin_group(neighborhoods, i, i + batch.lanes());
        for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
            batch.set_members(lane, neighborhoods.of(i + lane));
        batch.solve();
        for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
            count += batch.found(lane) ? 0 : 1;
    }
    return count;
}

/// `tolerance`: of the first direction and of the first two; any method rounds relative to the
/// largest eigenvalue.
void check_hard(const Matrix& x, double tolerance, double tolerance_of_two) {
    for (const std::int64_t size : {50, 60, 140}) {
        ASSERT_NEAR(largest_difference(x, size, 1), 0, tolerance);
        ASSERT_NEAR(largest_difference(x, size, 2), 0, tolerance_of_two);
        assert_in_range(not_found(x, size, 2), 0, 4);
    }
}

void hard_motions_are_found_in_batches(void**) {
    check_hard(stopping(), 1e-13, 1e-11);
    check_hard(line(), 1e-13, 1e-13);
    check_hard(jumping(), 1e-13, 1e-9);
    check_hard(spiked(), 1e-13, 1e-6);
    check_hard(moved(1e8), 1e-13, 1e-13);
    check_hard(scaled(cyclic(length, features), 1e-140), 1e-13, 1e-13);
    check_hard(scaled(cyclic(length, features), 1e100), 1e-13, 1e-13);
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(tangents_are_those_of_lapack),
        cmocka_unit_test(large_neighborhoods_of_wide_frames),
        cmocka_unit_test(features_of_uneven_size),
        cmocka_unit_test(a_direction_that_the_start_lacks_is_found),
        cmocka_unit_test(windows_that_do_not_vary_have_no_direction),
        cmocka_unit_test(rounding_noise_has_no_direction),
        cmocka_unit_test(lanes_that_converge_are_known),
        cmocka_unit_test(slow_lanes_are_found),
        cmocka_unit_test(distances_within_a_neighborhood_are_those_of_frames),
        cmocka_unit_test(hard_motions_are_found_in_batches),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
