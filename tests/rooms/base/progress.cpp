// SPDX-License-Identifier: BSD-3-Clause
// What a progress callback sees.
#include "base/progress.hpp"

#include <functional>
#include <utility>
#include <vector>

#include "assertions.hpp"
#include "base/parallel.hpp"

namespace {

using namespace stltsa;

/// The stages and fractions that the callback of a call sees; after each of them it calls `then`.
struct Seen {
    std::vector<std::pair<Stage, double>> calls;
    std::function<void()> then = [] {};

    static std::int32_t note(void* user, std::int32_t stage, double fraction) {
        auto& seen = *static_cast<Seen*>(user);
        seen.calls.emplace_back(static_cast<Stage>(stage), fraction);
        seen.then();
        return 0;
    }
    Call::Asked asked() { return {note, this}; }
};

void progress_never_decreases(void**) {
    Seen seen;
    const Call call(seen.asked());
    report_progress(Stage::tangents, 0.5);
    report_progress(Stage::tangents, 0.25);
    report_progress(Stage::features, 1);
    checkpoint();
    report_progress(Stage::units, 0);
    assert_int_equal(seen.calls.size(), 5);
    for (std::size_t i = 0; i < 4; ++i)
        assert_true(seen.calls[i] == std::pair(Stage::tangents, 0.5));
    assert_true(seen.calls[4] == std::pair(Stage::units, 0.0));
}

void parts_share_a_stage(void**) {
    Seen seen;
    const Call call(seen.asked());
    {
        const PartOfStages second(1, 2);
        report_progress(Stage::map, 0.5);
        const PartOfStages last_of_four(3, 4);
        report_progress(Stage::map, 1);
    }
    report_progress(Stage::denoise, 0.5);
    assert_true(seen.calls[0].second == 0.75);
    assert_true(seen.calls[1].second == 1);
    assert_true(seen.calls[2].second == 0.5);
}

/// As while ARPACK is used.
void only_one_stage_is_seen(void**) {
    Seen seen;
    const Call call(seen.asked());
    report_progress(Stage::neighbors, 0);
    {
        const OnlyInStage spectrum(Stage::spectrum);
        checkpoint();
        assert_int_equal(seen.calls.size(), 1);
        report_progress(Stage::spectrum, 0);
        assert_int_equal(seen.calls.size(), 2);
        report_progress(Stage::units, 0);
        assert_int_equal(seen.calls.size(), 2);
    }
    checkpoint();
    assert_int_equal(seen.calls.size(), 3);
}

/// The counts of two calls do not add up.
void a_checkpoint_comes_after_millions_of_numbers(void**) {
    Seen seen;
    for (int times = 0; times < 2; ++times) {
        const Call call(seen.asked());
        for (int i = 0; i < 8; ++i)
            checkpoint(1'000'000);
        assert_int_equal(seen.calls.size(), times + 1);
    }
}

/// The callback of a call may call the library, also during a loop: what it calls has progress of
/// its own.
void calls_within_callbacks(void**) {
    Seen outer, inner;
    const auto call_inner = [&] {
        const Call call(inner.asked());
        const PartOfStages part(0, 2);
        report_progress(Stage::read, 1);
        parallel_blocks(
            4, 2, [](std::int64_t) { checkpoint(); }, Stage::map);
        assert_true(Checkpoints::cancellable());
        const Call without_options({});
        assert_false(Checkpoints::cancellable());
        report_progress(Stage::write, 1);
    };
    outer.then = call_inner;
    const Call call(outer.asked());
    const auto nothing = [](std::int64_t) {};
    parallel_blocks(1, 1, nothing, Stage::map);
    assert_int_equal(outer.calls.size(), 1);
    assert_true(outer.calls[0] == std::pair(Stage::map, 1.0));
    assert_true(inner.calls.size() > 1);
    assert_true(inner.calls[0] == std::pair(Stage::read, 0.5));
    assert_true(inner.calls.back() == std::pair(Stage::map, 0.5));
    outer.then = [] {};
    report_progress(Stage::denoise, 1);
    assert_int_equal(outer.calls.size(), 2);
    assert_true(outer.calls[1] == std::pair(Stage::denoise, 1.0));
}

void a_callback_cancels(void**) {
    int calls = 0;
    const Call call(Call::Asked{[](void* user, std::int32_t, double) -> std::int32_t {
                                    return ++*static_cast<int*>(user) == 3;
                                },
                                &calls});
    try {
        for (;;)
            checkpoint();
    } catch (const Error& error) {
        assert_true(error.status() == Status::cancelled);
    }
    assert_int_equal(calls, 3);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(progress_never_decreases),
        cmocka_unit_test(parts_share_a_stage),
        cmocka_unit_test(only_one_stage_is_seen),
        cmocka_unit_test(a_checkpoint_comes_after_millions_of_numbers),
        cmocka_unit_test(calls_within_callbacks),
        cmocka_unit_test(a_callback_cancels),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
