// SPDX-License-Identifier: BSD-3-Clause
// A decomposition does each thing once: its graphs and embeddings, counted by their stages.
#include "motion/testing.hpp"

#include <algorithm>

#include "motion/decompose.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;
using stltsa::Progress;
using stltsa::Stage;

struct Work {
    int graphs = 0;
    int embeddings = 0;
    int searches = 0; ///< for the period
    int cuts = 0;
    Stage stage = Stage::read;
    double fraction = 0;

    /// A stage that begins again begins with a smaller fraction, or after another stage.
    void add(Stage next, double done) {
        if (next != stage || done < fraction) {
            graphs += next == Stage::tangents;
            embeddings += next == Stage::alignment;
            searches += next == Stage::neighbors;
            cuts += next == Stage::units;
        }
        stage = next;
        fraction = done;
    }
};

Work work_of(const Matrix& samples, const DecomposeOptions& options = {}) {
    Work work;
    const auto count = [](void* user, std::int32_t stage, double fraction) {
        static_cast<Work*>(user)->add(static_cast<Stage>(stage), fraction);
        return std::int32_t{0};
    };
    decompose(samples.view(), 30, options, Progress(count, &work));
    return work;
}

void check_once(const Work& work, int embeddings) {
    assert_int_equal(work.searches, 1);
    assert_int_equal(work.graphs, 1);
    assert_int_equal(work.embeddings, embeddings);
    assert_int_equal(work.cuts, 1);
}

/// The coordinate is chosen among three dimensions, and nothing is embedded twice.
void cycles_need_three_embeddings_of_one_graph(void**) {
    check_once(work_of(Exercise{}.samples(30)), 3);
}

void a_requested_dimension_is_the_only_one(void**) {
    DecomposeOptions options;
    options.dimension = 2;
    check_once(work_of(Exercise{}.samples(30), options), 1);
    options.dimension = 1; // and two for the loop
    check_once(work_of(Exercise{}.samples(30), options), 2);
}

/// Work within a later stage shows that stage alone, and the callback never runs within ARPACK.
void work_within_a_stage_shows_only_that_stage(void**) {
    std::vector<std::pair<std::int32_t, double>> calls;
    const auto record = [](void* user, std::int32_t stage, double fraction) {
        static_cast<decltype(calls)*>(user)->emplace_back(stage, fraction);
        return std::int32_t{0};
    };
    const Progress progress(record, &calls);
    decompose(Exercise{}.samples(30).view(), 30, {}, progress.part(1, 2).within(Stage::units, 0.5));
    assert_true(calls.size() > 5);
    for (const auto& [stage, fraction] : calls) {
        assert_int_equal(stage, Stage::units);
        ASSERT_NEAR(fraction, 0.75, 0);
    }
    calls.clear();
    progress.within(Stage::units, 0.5).report(Stage::spectrum, 0);
    assert_true(calls.empty());
}

/// This includes a single channel, which has no second dimension.
void without_a_choice_there_is_one_embedding(void**) {
    const Matrix line = sampled(
        300, 10, 30, [](double t, std::int64_t c) { return t * std::cos(1.0 * double(c)); });
    check_once(work_of(line), 1);
    const Matrix sine = sampled(300, 1, 30, [](double t, std::int64_t) { return std::sin(5 * t); });
    check_once(work_of(sine), 1);
}

void the_intrinsic_dimension_needs_no_graph_and_no_embedding(void**) {
    DecomposeOptions options;
    options.estimate.emplace();
    for (const std::optional<int> dimension : {std::optional<int>(), std::optional(2)}) {
        options.dimension = dimension;
        const Matrix samples = Exercise{}.samples(30);
        check_once(work_of(samples, options), dimension ? 1 : 3);
        const auto with = decompose(samples.view(), 30, options, Progress{});
        assert_true(with.intrinsic && with.intrinsic->local_pca > 0);
        assert_int_equal(with.intrinsic->eigenvalues.size(), 7);
        assert_int_equal(with.eigenvalues.size(), with.parameters.dimension + 2);
        options.estimate.reset();
        const auto without = decompose(samples.view(), 30, options, Progress{});
        assert_true(!without.intrinsic);
        assert_int_equal(without.units.size(), with.units.size());
        for (std::size_t u = 0; u < with.units.size(); ++u)
            ASSERT_NEAR(with.units[u].end, without.units[u].end, 1e-6);
        options.estimate.emplace();
    }
}

void samples_without_an_embedding_have_no_dimension(void**) {
    DecomposeOptions options;
    options.estimate.emplace();
    const auto still = decompose(Matrix(300, 4).view(), 30, options, Progress{});
    assert_true(still.intrinsic && still.intrinsic->local_pca == 0);
    assert_true(!still.intrinsic->local_pca_reason.empty());
}

} // namespace

int main() {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cycles_need_three_embeddings_of_one_graph),
        cmocka_unit_test(a_requested_dimension_is_the_only_one),
        cmocka_unit_test(without_a_choice_there_is_one_embedding),
        cmocka_unit_test(work_within_a_stage_shows_only_that_stage),
        cmocka_unit_test(the_intrinsic_dimension_needs_no_graph_and_no_embedding),
        cmocka_unit_test(samples_without_an_embedding_have_no_dimension),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
