// SPDX-License-Identifier: BSD-3-Clause
// The smallest eigenvectors, looked for among vectors that are constant over runs of frames.
#include "linalg/aggregation.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/simd.hpp"
#include "ltsa/components.hpp"
#include "ltsa/spectrum.hpp"
#include "ltsa/tangents.hpp"
#include "ltsa_testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::Aggregation;
using stltsa::Machine;
using stltsa::ltsa::Alignment;
using stltsa::ltsa::Patches;
using stltsa::ltsa::Spectrum;

void runs_are_orthonormal(void**) {
    const Machine machine;
    for (const std::int64_t rows : {1, 7, 12, 100000})
        for (const std::int64_t length : {1, 2, 5, 12}) {
            const Aggregation runs(rows, length);
            assert_int_equal(runs.runs(), (rows + length - 1) / length);
            const Matrix coarse = noise(runs.runs(), 2);
            Matrix panel(rows, 2), back(runs.runs(), 2);
            runs.spread(coarse.view(), panel.view(), machine);
            for (std::int64_t i = 1; i < rows; ++i)
                if (i % length != 0)
                    assert_true(panel(i, 0) == panel(i - 1, 0) && panel(i, 1) == panel(i - 1, 1));
            runs.gather(panel.view(), back.view(), machine);
            for (std::int64_t i = 0; i < 2 * runs.runs(); ++i)
                ASSERT_NEAR(back.data()[i], coarse.data()[i], 1e-15);
        }
}

/// What the first of the vectors of `a` have that those of `b` (both orthonormal) do not span.
double largest_rest(const Matrix& a, const Matrix& b) {
    double largest = 0;
    for (std::int64_t l = 0; l < a.rows(); ++l) {
        std::vector<double> rest(a.row(l), a.row(l) + a.cols());
        for (std::int64_t m = 0; m < b.rows(); ++m) {
            const double overlap = stltsa::dot(a.row(l), b.row(m), a.cols());
            for (std::size_t i = 0; i < rest.size(); ++i)
                rest[i] -= overlap * b.row(m)[i];
        }
        largest = std::max(largest, std::sqrt(stltsa::dot(rest.data(), rest.data(), a.cols())));
    }
    return largest;
}

/// Of a motion of so many frames, looked for with runs of these lengths.
std::vector<Spectrum> spectra(std::int64_t frames, const std::vector<std::int64_t>& run_lengths) {
    constexpr int dimension = 2;
    const Matrix x = cyclic(frames, 12);
    stltsa::ltsa::Parameters parameters;
    parameters.neighbors = parameters.window = 12;
    parameters.dimension = dimension;
    const std::int64_t lengths[] = {frames};
    const auto found = stltsa::ltsa::temporal_neighbors(x.view(), lengths, parameters, {});
    const auto tangents = stltsa::ltsa::local_tangents(x.view(), found, parameters, {});
    const auto components = stltsa::ltsa::connected_components(found, {});
    const Patches patches(found, tangents, components, 0, dimension);
    const auto alignment = stltsa::ltsa::difference_alignment(patches, {});
    std::vector<Spectrum> result;
    for (const std::int64_t length : run_lengths)
        result.push_back(smallest_eigenpairs(*alignment, dimension + 1, dimension, length, {}));
    return result;
}

/// A few frames are taken as one: one solve less exact, and corrected.
void short_runs_change_nothing(void**) {
    const auto found = spectra(20000, {1, 2, 3});
    for (const Spectrum& spectrum : found) {
        assert_true(spectrum.first_change < 1e-9);
        if (!(largest_rest(spectrum.vectors, found[0].vectors) < 1e-11))
            FAIL("%.1e", largest_rest(spectrum.vectors, found[0].vectors));
        for (std::size_t l = 0; l < spectrum.values.size(); ++l)
            ASSERT_NEAR(spectrum.values[l] / found[0].values[l], 1, 1e-9);
    }
}

/// Runs of a cycle and more hide what is looked for: it is looked for without them.
void long_runs_are_given_up(void**) {
    const auto found = spectra(3000, {1, 500, 900});
    for (const Spectrum& spectrum : found) {
        assert_true(spectrum.values == found[0].values);
        assert_true(
            std::equal(spectrum.vectors.row(0), spectrum.vectors.row(2), found[0].vectors.row(0)));
        assert_true(spectrum.first_change == found[0].first_change);
    }
    assert_true(found[1].solves > found[0].solves && found[2].solves > found[0].solves);
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(runs_are_orthonormal),
        cmocka_unit_test(short_runs_change_nothing),
        cmocka_unit_test(long_runs_are_given_up),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
