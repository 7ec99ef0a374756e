// SPDX-License-Identifier: BSD-3-Clause
// Tangents found several at a time against those of LAPACK, and the same bits on every machine
// code.
#include <algorithm>
#include <cstring>

#include "base/random.hpp"
#include "linalg/simd.hpp"
#include "ltsa/local_pca.hpp"
#include "ltsa/model.hpp"
#include "ltsa/neighborhood_distances.hpp"
#include "ltsa/tangent_batch.hpp"
#include "ltsa/tangents.hpp"
#include "motion_testing.hpp"

namespace {

using namespace motion_testing;
using stltsa::Simd;
using stltsa::ltsa::LocalPca;
using stltsa::ltsa::Neighborhoods;
using stltsa::ltsa::Parameters;
using stltsa::ltsa::TangentBatch;
using stltsa::ltsa::Tangents;

constexpr std::int64_t features = 40;

Matrix motion(std::int64_t frames) {
    return sampled(frames, features, 120, cyclic_pose);
}

Matrix noise(std::int64_t frames) {
    stltsa::Random random(3);
    Matrix x(frames, features);
    for (std::int64_t i = 0; i < frames * features; ++i)
        x.data()[i] = random.symmetric();
    return x;
}

/// Every window has one direction, and it is orthogonal to every polynomial of low degree that is
/// even about the middle of the window.
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
    return local_tangents(x.view(), windows(x.rows(), size), parameters, {});
}

/// What the first tangents leave of LAPACK's, over all windows. Needs eigenvalues well apart.
double largest_difference(const Matrix& x, std::int64_t size, int dimension) {
    const Tangents tangents = tangents_of(x, size, dimension, stltsa::widest_simd());
    const Neighborhoods neighborhoods = windows(x.rows(), size);
    LocalPca pca(x.view(), size, dimension);
    double worst = 0;
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        pca.compute(neighborhoods.of(i), [&x](std::int64_t p, std::int64_t q) {
            return stltsa::squared_distance(x.row(p), x.row(q), x.cols());
        });
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
    for (const std::int64_t size : {5, 8, 12, 33, 40, 41})
        for (int dimension = 1; dimension <= 3; ++dimension) {
            ASSERT_NEAR(largest_difference(motion(100), size, dimension), 0, 1e-9);
            ASSERT_NEAR(largest_difference(noise(100), size, dimension), 0, 1e-9);
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

/// Motion is found together, noise one at a time; the numbers are as large or small as they may be.
void lanes_that_converge_are_known(void**) {
    for (const double scale : {1e-140, 1.0, 1e100}) {
        TangentBatch batch(7, 1, stltsa::widest_simd());
        for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
            for (std::int64_t a = 0; a < 7; ++a)
                for (std::int64_t b = a + 1; b < 7; ++b)
                    // Lane 0: a straight line. The others: a simplex, all directions alike.
                    batch.set_distance(
                        lane, a, b, scale * scale * (lane == 0 ? double((b - a) * (b - a)) : 1.0));
        batch.solve();
        for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
            assert_int_equal(batch.found(lane), lane == 0);
        ASSERT_NEAR(batch.value(0, 0) / (scale * scale), 28, 1e-12);
    }
}

/// Points on the axes, so that the eigenvalues are about 1, 0.5, 0.12, 0.096, .. : two that stand
/// out, but take more iterations than noise gets.
void slow_lanes_are_found(void**) {
    constexpr std::int64_t size = 37;
    const auto square = [](std::int64_t a) {
        return a < 2 ? 1 / double(1 + a) : 0.12 * std::pow(0.8, double(a - 2));
    };
    TangentBatch batch(size, 2, stltsa::widest_simd());
    for (std::int64_t lane = 0; lane < batch.lanes(); ++lane)
        for (std::int64_t a = 0; a < size; ++a)
            for (std::int64_t b = a + 1; b < size; ++b)
                batch.set_distance(lane, a, b, square(a) + square(b));
    batch.solve();
    for (std::int64_t lane = 0; lane < batch.lanes(); ++lane) {
        assert_true(batch.found(lane));
        ASSERT_NEAR(batch.value(lane, 1), 0.5, 0.1);
    }
}

void distances_within_a_neighborhood_are_those_of_frames(void**) {
    for (const std::int64_t size : {2, 8, 13, 40}) {
        const Matrix x = noise(2 * size);
        std::vector<std::int32_t> members;
        for (std::int32_t i = 0; i < size; ++i)
            members.push_back(2 * i + i % 2);
        for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512}) {
            if (!simd_available(simd))
                continue;
            stltsa::ltsa::NeighborhoodDistances distances(x.view(), size, simd);
            const auto among = distances.among(members);
            for (std::int64_t b = 1; b < size; ++b)
                for (std::int64_t a = 0; a < b; ++a)
                    assert_true(among(a, b) == distances(members[static_cast<std::size_t>(a)],
                                                         members[static_cast<std::size_t>(b)]));
        }
    }
}

void same_bits(const double* a, const double* b, std::int64_t count) {
    assert_memory_equal(a, b, static_cast<std::size_t>(count) * sizeof(double));
}

void every_machine_code_gives_the_same_bits(void**) {
    for (const Matrix& x : {motion(301), noise(301)})
        for (const std::int64_t size : {8, 12, 50}) {
            Parameters parameters;
            parameters.neighbors = parameters.window = size;
            parameters.simd = Simd::baseline;
            const std::int64_t lengths[] = {x.rows()};
            const auto expected = fit(x.view(), lengths, parameters, {});
            for (const Simd simd : {Simd::avx2, Simd::avx512}) {
                if (!simd_available(simd)) {
                    print_message("SKIPPED: %s is not on this machine\n",
                                  simd == Simd::avx2 ? "AVX2" : "AVX-512");
                    continue;
                }
                parameters.simd = simd;
                const auto model = fit(x.view(), lengths, parameters, {});
                same_bits(model.coords.data(), expected.coords.data(), x.rows() * 2);
                same_bits(model.components[0].eigenvalues.data(),
                          expected.components[0].eigenvalues.data(), 4);
            }
        }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(tangents_are_those_of_lapack),
        cmocka_unit_test(a_direction_that_the_start_lacks_is_found),
        cmocka_unit_test(windows_that_do_not_vary_have_no_direction),
        cmocka_unit_test(lanes_that_converge_are_known),
        cmocka_unit_test(slow_lanes_are_found),
        cmocka_unit_test(distances_within_a_neighborhood_are_those_of_frames),
        cmocka_unit_test(every_machine_code_gives_the_same_bits),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
