// SPDX-License-Identifier: BSD-3-Clause
// Compares temporal neighborhoods with their definition, found alone and together with their
// tangents, and tests their components.
#include <algorithm>
#include <vector>

#include "linalg/blas_threads.hpp"
#include "linalg/simd.hpp"
#include "ltsa/neighbors/components.hpp"
#include "ltsa/neighbors/neighbors.hpp"
#include "ltsa/search/best.hpp"
#include "ltsa/tangents/local_tangents.hpp"
#include "ltsa/testing.hpp"

namespace {

using namespace ltsa_testing;
using stltsa::ltsa::Neighborhoods;
using stltsa::ltsa::Parameters;
using stltsa::ltsa::Tangents;

struct Case {
    std::vector<std::int64_t> lengths;
    std::int64_t neighbors, window;
    bool include_self = true;
};

const Case cases[] = {
    {{1300}, 12, 12},
    {{1300}, 12, 12, false},
    {{1300}, 12, 48},                    // the widest window that shares distances
    {{1300}, 12, 49},                    // a window that does not
    {{1300}, 30, 60},                    // more neighbors than features
    {{13, 700, 40, 13, 13, 521}, 9, 12}, // clips shorter than a block or a window
    {{13, 700, 40, 13, 13, 521}, 9, 12, false},
    {{2600}, 7, 1024}, // the widest window with stored distances
    {{2600}, 7, 1100},
    {{90, 2510}, 7, 1100, false},
};

std::int64_t frames_of(const Case& c) {
    std::int64_t frames = 0;
    for (const std::int64_t length : c.lengths)
        frames += length;
    return frames;
}

Parameters parameters_of(const Case& c) {
    Parameters parameters;
    parameters.neighbors = c.neighbors;
    parameters.window = c.window;
    parameters.include_self = c.include_self;
    return parameters;
}

/// The definition: the first of all frames of the window, sorted by distance, ties by number.
std::vector<std::int32_t> defined(const Matrix& x, std::int64_t begin, std::int64_t end,
                                  std::int64_t frame, const Case& c) {
    std::vector<stltsa::ltsa::Candidate> candidates;
    for (std::int64_t j = std::max(begin, frame - c.window);
         j < std::min(end, frame + c.window + 1); ++j)
        if (j != frame || c.include_self)
            candidates.push_back({stltsa::squared_distance(x.row(frame), x.row(j), x.cols()),
                                  static_cast<std::int32_t>(j)});
    std::partial_sort(candidates.begin(), candidates.begin() + c.neighbors, candidates.end());
    std::vector<std::int32_t> nearest;
    for (std::int64_t j = 0; j < c.neighbors; ++j)
        nearest.push_back(candidates[static_cast<std::size_t>(j)].frame);
    std::sort(nearest.begin(), nearest.end());
    return nearest;
}

void check(const Case& c, const Matrix& x, const Neighborhoods& found) {
    assert_int_equal(found.frames(), x.rows());
    std::int64_t begin = 0;
    for (const std::int64_t length : c.lengths) {
        for (std::int64_t i = begin; i < begin + length; ++i)
            if (!std::ranges::equal(found.of(i), defined(x, begin, begin + length, i, c)))
                FAIL("k = %ld, w = %ld: frame %ld has other neighbors", c.neighbors, c.window, i);
        begin += length;
    }
}

/// Smooth frames, and frames with few values, whose distances are often equal.
std::vector<Matrix> frames_for(const Case& c) {
    return {cyclic(frames_of(c), 20), lattice(frames_of(c), 20, 5)};
}

void neighbors_are_the_nearest_of_the_window(void**) {
    for (const Case& c : cases)
        for (const Matrix& x : frames_for(c))
            check(c, x, temporal_neighbors(x.view(), c.lengths, parameters_of(c)));
}

void one_pass_finds_the_same_neighbors_and_tangents(void**) {
    for (const Case& c : cases)
        for (const Matrix& x : frames_for(c)) {
            const Parameters parameters = parameters_of(c);
            Neighborhoods found;
            const Tangents tangents = temporal_tangents(x.view(), c.lengths, parameters, found);
            check(c, x, found);
            const Tangents again = local_tangents(x.view(), found, parameters);
            assert_true(tangents.rank == again.rank);
            assert_int_equal(tangents.g.size(), again.g.size());
            for (std::size_t i = 0; i < again.g.size(); ++i)
                ASSERT_NEAR(tangents.g[i], again.g[i], 0);
        }
}

/// Frame 2 is in no neighborhood, not even its own; its neighbors are found nevertheless.
void a_window_belongs_to_the_component_of_its_frames(void**) {
    const Neighborhoods found{2, {0, 1, 0, 1, 0, 1, 3, 4, 3, 4, 4, 5}};
    const auto components = connected_components(found, {});
    assert_int_equal(components.count, 3);
    const std::vector<std::vector<std::int32_t>> members{{0, 1}, {2}, {3, 4, 5}};
    const std::vector<std::vector<std::int32_t>> windows{{0, 1, 2}, {}, {3, 4, 5}};
    for (std::size_t c = 0; c < 3; ++c) {
        assert_true(std::ranges::equal(components.members[c], members[c]));
        assert_true(std::ranges::equal(components.windows[c], windows[c]));
    }
}

} // namespace

int main() {
    const stltsa::SingleThreadedBlas single;
    const CMUnitTest tests[] = {
        cmocka_unit_test(neighbors_are_the_nearest_of_the_window),
        cmocka_unit_test(one_pass_finds_the_same_neighbors_and_tangents),
        cmocka_unit_test(a_window_belongs_to_the_component_of_its_frames),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
