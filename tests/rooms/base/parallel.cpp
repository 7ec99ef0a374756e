// SPDX-License-Identifier: BSD-3-Clause
// Parallel loops, and the threads that they share.
#include "base/parallel.hpp"

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "assertions.hpp"
#include "checkpoints.hpp"

namespace {

using stltsa::parallel_blocks;
using stltsa::SharedThreads;
using stltsa::Stage;
using testing::Answering;

std::atomic<int> threads_seen;

/// Counts the threads that enter.
void see_thread() {
    thread_local bool seen = false;
    if (!seen)
        ++threads_seen;
    seen = true;
}

/// Every block runs once.
void check_loop(std::int64_t blocks, int threads) {
    std::vector<std::atomic<int>> runs(static_cast<std::size_t>(blocks));
    parallel_blocks(blocks, threads, [&](std::int64_t block) {
        see_thread();
        ++runs[static_cast<std::size_t>(block)];
    });
    for (const auto& count : runs)
        assert_int_equal(count.load(), 1);
}

void check_loops() {
    for (const std::int64_t blocks : {0, 1, 2, 3, 100, 5000})
        for (const int threads : {1, 2, 3, 8})
            check_loop(blocks, threads);
}

void every_block_runs_once(void**) {
    check_loops();
    const SharedThreads threads;
    check_loops();
}

/// Two blocks that wait for each other run at the same time.
void check_two_at_once() {
    std::atomic<int> here{0};
    parallel_blocks(2, 2, [&](std::int64_t) {
        see_thread();
        ++here;
        while (here < 2)
            std::this_thread::yield();
    });
}

void threads_are_shared(void**) {
    const SharedThreads threads;
    see_thread();
    threads_seen = 0;
    for (int loop = 0; loop < 100; ++loop)
        check_two_at_once();
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // the other thread sleeps by then
    check_two_at_once();
    assert_int_equal(threads_seen, 1);
}

void each_loop_starts_its_own_threads(void**) {
    see_thread();
    threads_seen = 0;
    for (int loop = 0; loop < 10; ++loop)
        check_two_at_once();
    assert_int_equal(threads_seen, 10);
}

std::string failure_of(const std::function<void()>& loop) {
    try {
        loop();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

void the_lowest_failure_is_thrown(void**) {
    const SharedThreads threads;
    for (int times = 0; times < 50; ++times) {
        std::atomic<int> here{0};
        const auto both = [&](std::int64_t block) {
            ++here;
            while (here < 2)
                std::this_thread::yield();
            throw std::runtime_error(std::to_string(block));
        };
        assert_string_equal(failure_of([&] { parallel_blocks(2, 2, both); }).c_str(), "0");
        const Answering stop([] { throw std::runtime_error("stopped"); });
        const auto nothing = [](std::int64_t) {};
        assert_string_equal(
            failure_of([&] { parallel_blocks(1000, 2, nothing, Stage::map); }).c_str(), "stopped");
        check_loop(10, 2);
    }
}

void progress_is_reported(void**) {
    const SharedThreads threads;
    const auto nothing = [](std::int64_t) {};
    for (int times = 0; times < 300; ++times) {
        assert_true(testing::checkpoints_of([&] { parallel_blocks(100, 2, nothing, Stage::map); }) >
                    0);
        if (times % 10 == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    assert_int_equal(testing::checkpoints_of([&] { parallel_blocks(100, 2, nothing); }), 0);
}

/// Runs two endless blocks of which only the caller's asks, but both end. `block`: runs within each
/// of them until a checkpoint ends it.
void check_endless(const std::function<void()>& block) {
    std::atomic<int> here{0}, ended{0};
    const auto endless = [&](std::int64_t) {
        ++here;
        while (here < 2)
            std::this_thread::yield();
        struct Count {
            std::atomic<int>& ended;
            ~Count() { ++ended; }
        } count{ended};
        block();
    };
    int asked = 0;
    const Answering stop([&] {
        if (++asked == 100)
            throw std::runtime_error("stopped");
    });
    assert_string_equal(failure_of([&] { parallel_blocks(2, 2, endless, Stage::map); }).c_str(),
                        "stopped");
    assert_int_equal(asked, 100);
    assert_int_equal(ended, 2);
}

void a_checkpoint_within_a_block_stops_the_others(void**) {
    const SharedThreads threads;
    const auto endless = [] {
        for (;;)
            stltsa::checkpoint();
    };
    check_endless(endless);
    check_loop(10, 2);
    check_endless([&] { parallel_blocks(2, 2, [&](std::int64_t) { endless(); }); });
    check_loop(10, 2);
    // If nobody answers, nothing happens.
    parallel_blocks(3, 1, [](std::int64_t) { stltsa::checkpoint(); });
    stltsa::checkpoint();
}

void loops_within_loops(void**) {
    assert_null(SharedThreads::available_pool());
    const SharedThreads threads;
    { const SharedThreads again; }
    assert_non_null(SharedThreads::available_pool());
    std::atomic<int> count{0};
    const auto inner = [&](std::int64_t) { ++count; };
    const Answering again([&] {
        assert_null(SharedThreads::available_pool()); // it is busy
        check_loop(10, 2);
    });
    parallel_blocks(
        8, 2, [&](std::int64_t) { parallel_blocks(10, 2, inner); }, Stage::map);
    assert_int_equal(count, 80);
    assert_non_null(SharedThreads::available_pool());
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(every_block_runs_once),
        cmocka_unit_test(threads_are_shared),
        cmocka_unit_test(each_loop_starts_its_own_threads),
        cmocka_unit_test(the_lowest_failure_is_thrown),
        cmocka_unit_test(progress_is_reported),
        cmocka_unit_test(a_checkpoint_within_a_block_stops_the_others),
        cmocka_unit_test(loops_within_loops),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
