// SPDX-License-Identifier: BSD-3-Clause
// The smallest eigenvectors, looked for among vectors that are straight over runs of frames.
#include "linalg/aggregation.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/run_sums.hpp"
#include "linalg/simd.hpp"
#include "ltsa/components.hpp"
#include "ltsa/local_tangents.hpp"
#include "ltsa/spectrum.hpp"
#include "ltsa_testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::Aggregation;
using stltsa::Machine;
using stltsa::Simd;
using stltsa::ltsa::Patches;
using stltsa::ltsa::Spectrum;

/// Entry (i, t) of the columns of Q of a run of this length.
double entry_of(std::int64_t i, std::int64_t t, std::int64_t length) {
    const auto from_middle = [length](std::int64_t j) { return double(2 * j - length + 1); };
    double squares = 0;
    for (std::int64_t j = 0; j < length; ++j)
        squares += t == 0 ? 1 : from_middle(j) * from_middle(j);
    return squares > 0 ? (t == 0 ? 1 : from_middle(i)) / std::sqrt(squares) : 0;
}

/// Q^T panel
Matrix gathered(const Aggregation& runs, const Matrix& panel) {
    Matrix coarse(runs.columns(), panel.cols());
    for (std::int64_t run = 0; run < runs.runs(); ++run) {
        const std::int64_t begin = runs.begin(run), length = runs.begin(run + 1) - begin;
        for (std::int64_t t = 0; t < runs.terms(); ++t)
            for (std::int64_t i = 0; i < length; ++i) {
                const double entry = entry_of(i, t, length);
                for (std::int64_t c = 0; c < panel.cols(); ++c)
                    coarse(run * runs.terms() + t, c) += entry * panel(begin + i, c);
            }
    }
    return coarse;
}

/// A last run of one row has a mean, but no slope.
bool is_missing(const Aggregation& runs, std::int64_t column) {
    return column + 1 == runs.columns() && runs.terms() == 2 &&
           runs.begin(runs.runs() - 1) + 1 == runs.rows();
}

void runs_are_orthonormal(void**) {
    const Machine machine;
    for (const std::int64_t rows : {1, 7, 12, 100000})
        for (const std::int64_t length : {1, 2, 5, 12}) {
            const Aggregation runs(rows, length);
            assert_int_equal(runs.runs(), (rows + length - 1) / length);
            assert_int_equal(runs.terms(), length == 1 ? 1 : 2);
            const Matrix coarse = noise(runs.columns(), 2);
            Matrix panel(rows, 2);
            runs.spread(coarse.view(), panel.view(), machine);
            for (std::int64_t i = 2; i < rows; ++i)
                for (std::int64_t c = 0; c < 2; ++c)
                    if (i % length >= 2)
                        ASSERT_NEAR(panel(i, c) - panel(i - 1, c),
                                    panel(i - 1, c) - panel(i - 2, c), 1e-14);
            const Matrix back = gathered(runs, panel);
            for (std::int64_t i = 0; i < runs.columns(); ++i)
                for (std::int64_t c = 0; c < 2; ++c)
                    ASSERT_NEAR(back(i, c), is_missing(runs, i) ? 0 : coarse(i, c), 1e-14);
        }
}

void what_runs_lack_is_measured(void**) {
    for (const std::int64_t length : {1, 2, 5, 12, 3000}) {
        const Aggregation runs(100001, length);
        const Matrix x = noise(runs.rows(), 2);
        Matrix rest(runs.rows(), 2);
        runs.spread(gathered(runs, x).view(), rest.view(), {});
        double squares = 0;
        for (std::int64_t i = 0; i < runs.rows(); ++i)
            squares += std::pow(x(i, 1) - rest(i, 1), 2);
        for (const int threads : {1, 3})
            ASSERT_NEAR(runs.variation_within(x.view(), 1, {Simd::baseline, threads}),
                        std::sqrt(squares), 1e-10);
    }
}

/// By its definition.
Matrix centered(Matrix x) {
    for (std::int64_t c = 0; c < x.cols(); ++c) {
        long double sum = 0;
        for (std::int64_t i = 0; i < x.rows(); ++i)
            sum += x(i, c);
        for (std::int64_t i = 0; i < x.rows(); ++i)
            x(i, c) -= static_cast<double>(sum / x.rows());
    }
    return x;
}

void check_equal(const Matrix& a, const Matrix& b) {
    double largest = 0;
    for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
        largest = std::max(largest, std::abs(b.data()[i]));
    for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
        ASSERT_NEAR(a.data()[i], b.data()[i], 1e-13 * (1 + largest));
}

/// x := sums(x) with all the code that this machine has, on one and more threads: the same bits.
template <class Sums>
Matrix same_everywhere(std::int64_t rows, std::int64_t cols, const Sums& sums) {
    Matrix first(rows, cols);
    sums(first, Machine{Simd::baseline, 1});
    for (const Simd simd : {Simd::baseline, Simd::avx2, Simd::avx512})
        for (const int threads : {1, 3}) {
            if (!stltsa::simd_available(simd))
                continue;
            Matrix x(rows, cols);
            sums(x, Machine{simd, threads});
            assert_true(std::equal(x.row(0), x.row(rows), first.row(0)));
        }
    return first;
}

/// Against S, C and Q one by one.
void check_run_sums(const Aggregation& runs, std::int64_t cols) {
    const std::int64_t rows = runs.rows();
    const Matrix z = noise(rows - 1, cols, 5);
    Matrix sums(rows, cols);
    for (std::int64_t i = 1; i < rows; ++i)
        for (std::int64_t c = 0; c < cols; ++c)
            sums(i, c) = sums(i - 1, c) + z(i - 1, c);
    const Matrix prefix =
        same_everywhere(runs.columns(), cols, [&](Matrix& x, const Machine& machine) {
            centered_prefix_sums(z.view(), runs, x.view(), machine);
        });
    check_equal(prefix, gathered(runs, centered(sums)));

    const Matrix coarse = noise(runs.columns(), cols, 6);
    Matrix spread(rows, cols), expected(rows - 1, cols);
    runs.spread(coarse.view(), spread.view(), {});
    spread = centered(spread);
    for (std::int64_t i = rows - 1; i > 0; --i)
        for (std::int64_t c = 0; c < cols; ++c)
            expected(i - 1, c) = spread(i, c) + (i < rows - 1 ? expected(i, c) : 0);
    const Matrix suffix = same_everywhere(rows - 1, cols, [&](Matrix& x, const Machine& machine) {
        centered_suffix_sums(runs, coarse.view(), x.view(), machine);
    });
    check_equal(suffix, expected);
}

void sums_are_those_of_what_runs_stand_for(void**) {
    for (const std::int64_t rows : {2, 7, 12, 1025, 200001})
        for (const std::int64_t length : {1, 2, 5, 12, 3000})
            for (const std::int64_t cols : {1, 4, 8})
                check_run_sums({rows, length}, cols);
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

/// Of these frames, looked for with runs of these lengths.
std::vector<Spectrum> spectra(const Matrix& x, int dimension, std::int64_t window,
                              const std::vector<std::int64_t>& run_lengths) {
    stltsa::ltsa::Parameters parameters;
    parameters.neighbors = 12;
    parameters.window = window;
    parameters.dimension = dimension;
    const std::int64_t lengths[] = {x.rows()};
    const auto found = stltsa::ltsa::temporal_neighbors(x.view(), lengths, parameters, {});
    const auto tangents = stltsa::ltsa::local_tangents(x.view(), found, parameters, {});
    const auto components = stltsa::ltsa::connected_components(found, {});
    assert_int_equal(components.count, 1);
    const Patches patches(found, tangents, components, 0, dimension, {stltsa::widest_simd(), 3});
    const auto alignment = stltsa::ltsa::difference_alignment(patches, {});
    std::vector<Spectrum> result;
    for (const std::int64_t length : run_lengths)
        result.push_back(smallest_eigenpairs(*alignment, dimension + 1, dimension, length, {}));
    return result;
}

/// A few frames are taken as one: one solve less exact, and corrected.
void short_runs_change_nothing(void**) {
    const auto found = spectra(cyclic(60001, 12), 2, 12, {1, 3, 4});
    for (const Spectrum& spectrum : found) {
        assert_true(spectrum.first_change < 1e-9);
        assert_true(spectrum.solves < 20); // once
        if (!(largest_rest(spectrum.vectors, found[0].vectors) < 1e-11))
            FAIL("%.1e", largest_rest(spectrum.vectors, found[0].vectors));
        for (std::size_t l = 0; l < spectrum.values.size(); ++l)
            ASSERT_NEAR(spectrum.values[l] / found[0].values[l], 1, 1e-9);
    }
}

/// Found without runs in the end.
void check_given_up(const Spectrum& spectrum, const Spectrum& without) {
    assert_true(spectrum.values == without.values);
    assert_true(std::equal(spectrum.vectors.row(0), spectrum.vectors.row(spectrum.vectors.rows()),
                           without.vectors.row(0)));
    assert_true(spectrum.first_change == without.first_change);
    assert_true(spectrum.solves > without.solves);
}

/// Runs of a cycle and more hide what is looked for.
void long_runs_are_given_up(void**) {
    const auto found = spectra(cyclic(3000, 12), 2, 12, {1, 500, 900});
    check_given_up(found[1], found[0]);
    check_given_up(found[2], found[0]);
}

/// Two sources, so far apart, whose frames come in the order ABBA; few of one are near any of the
/// other.
Matrix alternating(double apart) {
    const Matrix rest = noise(10000, 3);
    Matrix x(2 * rest.rows(), 5);
    double phase = 0;
    for (std::int64_t i = 0; i < x.rows(); ++i) {
        const std::int64_t pair = i / 2;
        const double sign = i % 4 == 0 || i % 4 == 3 ? 1 : -1;
        if (i % 2 == 0)
            phase += 0.52 * (1 + 0.5 * rest(pair, 0));
        x(i, 0) = std::cos(phase);
        x(i, 1) = std::sin(phase);
        x(i, 2) = sign * apart * (1 + 0.3 * std::sin(1.7 * phase));
        x(i, 3) = 0.05 * rest(pair, 1);
        x(i, 4) = sign * 0.02 * rest(pair, 2);
    }
    return x;
}

/// Which of two sources a frame is from is a wanted vector, without mean and slope in every run of
/// four, that ARPACK cannot see.
void what_alternates_is_found(void**) {
    for (const double apart : {0.9, 0.97}) {
        const auto found = spectra(alternating(apart), 1, 40, {1, 4});
        check_given_up(found[1], found[0]);
    }
}

/// Where the spectrum falls slowly, as that of noise does, ARPACK's vectors are solved for several
/// times, so that the first correction has little to do. After one solve it turns them by 6e-12.
void slow_spectra_are_solved_for_again(void**) {
    const auto found = spectra(noise(500, 6), 3, 12, {1});
    if (!(found[0].first_change < 5e-13))
        FAIL("%.1e", found[0].first_change);
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(runs_are_orthonormal),
        cmocka_unit_test(what_runs_lack_is_measured),
        cmocka_unit_test(sums_are_those_of_what_runs_stand_for),
        cmocka_unit_test(short_runs_change_nothing),
        cmocka_unit_test(long_runs_are_given_up),
        cmocka_unit_test(what_alternates_is_found),
        cmocka_unit_test(slow_spectra_are_solved_for_again),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
