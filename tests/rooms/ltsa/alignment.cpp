// SPDX-License-Identifier: BSD-3-Clause
// Compares the alignment matrix B, applied and factored in its unknowns, with its definition.
#include <algorithm>

#include "../checkpoints.hpp"
#include "linalg/panel.hpp"
#include "linalg/simd.hpp"
#include "ltsa/alignment/alignment.hpp"
#include "ltsa/alignment/patch_passes.hpp"
#include "ltsa/tangents/local_tangents.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::Machine;
using stltsa::ltsa::Alignment;
using stltsa::ltsa::Neighborhoods;
using stltsa::ltsa::Patches;

/// Windows; with `links`, their first frame is replaced by a distant one.
Neighborhoods neighborhoods(std::int64_t frames, std::int64_t size, bool links) {
    Neighborhoods result{size, {}};
    for (std::int64_t i = 0; i < frames; ++i) {
        const std::int64_t first = std::clamp(i - size / 2, 0L, frames - size);
        const std::int64_t link = (i + 71) % (frames - 2 * size);
        const std::int64_t linked = link < first ? link : link + 2 * size;
        std::vector<std::int32_t> of_frame;
        for (std::int64_t j = 0; j < size; ++j)
            of_frame.push_back(
                static_cast<std::int32_t>(links && j == 0 && linked < frames ? linked : first + j));
        std::ranges::sort(of_frame);
        if (std::ranges::adjacent_find(of_frame) != of_frame.end())
            for (std::int64_t j = 0; j < size; ++j)
                of_frame[static_cast<std::size_t>(j)] = static_cast<std::int32_t>(first + j);
        result.index.insert(result.index.end(), of_frame.begin(), of_frame.end());
    }
    return result;
}

/// B y by its definition (Table 1, step 4): the sum of the residuals of all patches.
Matrix defined_product(const Patches& patches, const Matrix& y) {
    Matrix product(y.rows(), y.cols());
    const std::int64_t k = patches.size();
    for (std::int64_t p = 0; p < patches.count(); ++p)
        for (std::int64_t c = 0; c < y.cols(); ++c) {
            std::vector<double> local;
            double mean = 0;
            for (const std::int32_t frame : patches.of(p)) {
                local.push_back(y(frame, c));
                mean += y(frame, c) / static_cast<double>(k);
            }
            std::vector<double> projection(local.size(), mean);
            for (std::int64_t l = 0; l < patches.dimension(); ++l) {
                const double* g = patches.direction(p, l);
                double overlap = 0;
                for (std::size_t j = 0; j < local.size(); ++j)
                    overlap += g[j] * local[j];
                for (std::size_t j = 0; j < local.size(); ++j)
                    projection[j] += g[j] * overlap;
            }
            for (std::size_t j = 0; j < local.size(); ++j)
                product(patches.of(p)[j], c) += local[j] - projection[j];
        }
    return product;
}

double largest(const Matrix& x) {
    double size = 0;
    for (std::int64_t i = 0; i < x.rows() * x.cols(); ++i)
        size = std::max(size, std::abs(x.data()[i]));
    return size;
}

void check_near(const Matrix& a, const Matrix& b, double tolerance, std::int64_t k, int d) {
    Matrix difference = a;
    for (std::int64_t i = 0; i < a.rows() * a.cols(); ++i)
        difference.data()[i] -= b.data()[i];
    if (!(largest(difference) <= tolerance * largest(b)))
        FAIL("k = %ld, d = %d: %.1e", k, d, largest(difference) / largest(b));
}

void check_alignment(const Alignment& alignment, std::int64_t k, int d) {
    const Patches& patches = alignment.patches();
    const std::int64_t frames = patches.frames();
    const std::int64_t cols = stltsa::panel_width(d + 2);
    const Matrix in = noise(alignment.unknowns(), cols, 7);
    Matrix y(frames, cols);
    alignment.prolong(in.view(), y.view());
    const Matrix product = defined_product(patches, y);

    Matrix expected(alignment.unknowns(), cols);
    alignment.restrict_to(product.view(), expected.view());
    Matrix out(alignment.unknowns(), cols);
    const Matrix form = alignment.apply(in.view(), out.view(), d + 1);
    check_near(out, expected, 1e-12, k, d);

    Matrix forms(d + 1, cols);
    for (std::int64_t a = 0; a < forms.rows(); ++a)
        for (std::int64_t b = 0; b < cols; ++b)
            for (std::int64_t i = 0; i < frames; ++i)
                forms(a, b) += y(i, a) * product(i, b);
    check_near(form, forms, 1e-12, k, d);

    Matrix again(frames, cols);
    alignment.at_frames(out.view(), again.view());
    check_near(again, product, 1e-11, k, d);
    alignment.solve(out.view(), cols);
    check_near(out, in, 1e-6, k, d); // B is ill-conditioned
}

using MakeAlignment = std::unique_ptr<Alignment> (*)(const Patches&, const Machine&);

/// `checkpoints`: at least so many while the matrix is assembled.
void check_alignment_of(MakeAlignment make, const Matrix& x, const Neighborhoods& found, int d,
                        int checkpoints = 0) {
    stltsa::ltsa::Parameters parameters;
    parameters.neighbors = parameters.window = found.size;
    parameters.dimension = d;
    const auto tangents = local_tangents(x.view(), found, parameters);
    const auto components = connected_components(found, {});
    assert_int_equal(components.count, 1);
    const Patches patches(found, tangents, components, 0, d, {stltsa::widest_simd(), 3});
    for (const Simd simd : instruction_sets()) {
        std::unique_ptr<Alignment> alignment;
        assert_in_range(testing::checkpoints_of([&] {
                            alignment = make(patches, {simd, 1});
                        }),
                        checkpoints, 1000);
        check_alignment(*alignment, found.size, d);
    }
}

/// Even and odd sizes, narrow and wide bands, and more directions than are summed at a time.
void check_alignments(MakeAlignment make, bool links) {
    const Matrix x = noise(150, 12);
    for (const std::int64_t k : {8, 9, 11, 12, 15, 33, 40, 70, 71})
        for (int d = 1; d <= 5; ++d)
            check_alignment_of(make, x, neighborhoods(x.rows(), k, links), d);
}

void differences_of_frames(void**) {
    check_alignments(stltsa::ltsa::difference_alignment, false);
}

/// For frames with distant neighbors, in several blocks.
void differences_of_many_frames(void**) {
    const Matrix x = noise(4500, 12);
    for (const std::int64_t k : {12, 40, 60}) {
        Neighborhoods found = neighborhoods(x.rows(), k, false);
        stltsa::Random random(5);
        for (std::int64_t i = 2 * k; i + 2 * k < x.rows(); ++i) {
            std::int32_t* of_frame = found.index.data() + i * k;
            for (std::int64_t j = 1; j < k; ++j) // every second one, all, or none
                of_frame[j] = of_frame[j - 1] + 1 + (random.symmetric() > 0.3 ? 1 : 0);
        }
        check_alignment_of(stltsa::ltsa::difference_alignment, x, found, 2, 3);
    }
}

/// The unknowns are the values at the frames.
struct FrameValues {
    template <class P>
    static void gather(const std::int32_t* frames, std::int64_t k, stltsa::ConstMatrixView values,
                       std::int64_t column, P* to) {
        for (std::int64_t j = 0; j < k; ++j)
            to[j] = values(frames[j], column);
    }
};

/// Values that are nearly a multiple of a direction: the residual is orthogonal to it, to rounding
/// of the residual, not of the values. After one projection it would contain 1e-9.
void residuals_are_orthogonal_to_directions(void**) {
    constexpr std::int64_t k = 30, d = 2;
    const Matrix x = noise(150, 12);
    const Neighborhoods found = neighborhoods(x.rows(), k, false);
    stltsa::ltsa::Parameters parameters;
    parameters.neighbors = parameters.window = k;
    const auto tangents = local_tangents(x.view(), found, parameters);
    const auto components = connected_components(found, {});
    const Patches patches(found, tangents, components, 0, d, {});
    for (std::int64_t p = 0; p < patches.count(); ++p) {
        Matrix values = noise(x.rows(), 1, 9);
        for (std::int64_t j = 0; j < k; ++j)
            values(patches.of(p)[static_cast<std::size_t>(j)], 0) +=
                1e8 * patches.direction(p, 1)[j];
        std::vector<double> left(k);
        stltsa::ltsa::project_patch<FrameValues>(patches, p, values.view(), 0, left.data());
        for (std::int64_t l = 0; l < d; ++l)
            ASSERT_NEAR(stltsa::dot(patches.direction(p, l), left.data(), k), 0, 1e-13);
    }
}

void all_but_the_grounded_frame(void**) {
    check_alignments(stltsa::ltsa::grounded_alignment, true);
    constexpr std::int64_t k = 71;
    const Matrix x = noise(1000, 12);
    check_alignment_of(stltsa::ltsa::grounded_alignment, x, neighborhoods(x.rows(), k, true), 2, 1);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(differences_of_frames),
        cmocka_unit_test(differences_of_many_frames),
        cmocka_unit_test(residuals_are_orthogonal_to_directions),
        cmocka_unit_test(all_but_the_grounded_frame),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
