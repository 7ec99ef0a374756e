// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel.hpp"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

namespace stltsa {
namespace {

/// Ends a block whose loop was stopped.
struct LoopStopped {};

/// The state that all threads of a loop share.
class BlockQueue {
  public:
    BlockQueue(std::int64_t blocks, const std::function<void(std::int64_t)>& body)
        : blocks_(blocks), body_(body) {}

    /// Runs the next block; false if none is left.
    bool run_one() {
        if (stopped_.load())
            return false;
        const std::int64_t block = next_.fetch_add(1);
        if (block >= blocks_)
            return false;
        try {
            body_(block);
            done_.fetch_add(1);
        } catch (const LoopStopped&) { // the checkpoint's exception is recorded
        } catch (...) {
            record(block, std::current_exception());
        }
        return true;
    }

    /// Keeps the exception of the lowest block that failed, whichever failed first; block -1 is a
    /// checkpoint.
    void record(std::int64_t block, std::exception_ptr error) {
        const std::lock_guard lock(mutex_);
        if (block < error_block_) {
            error_block_ = block;
            error_ = error;
        }
        stopped_.store(true);
    }

    /// Called on the caller's thread. If it throws, the loop stops, and so does each block at its
    /// next checkpoint.
    void check(Checkpoints* outer) {
        if (outer == nullptr || cancelled())
            return;
        try {
            outer->check();
        } catch (...) {
            cancelled_.store(true);
            record(-1, std::current_exception());
        }
    }

    bool cancelled() const { return cancelled_.load(); }
    double done() const {
        return static_cast<double>(done_.load()) /
               static_cast<double>(std::max<std::int64_t>(1, blocks_));
    }
    void rethrow() const {
        if (error_)
            std::rethrow_exception(error_);
    }

  private:
    const std::int64_t blocks_;
    const std::function<void(std::int64_t)>& body_;
    std::atomic<std::int64_t> next_{0};
    std::atomic<std::int64_t> done_{0};
    std::atomic<bool> stopped_{false};
    std::atomic<bool> cancelled_{false};
    std::mutex mutex_;
    std::int64_t error_block_ = std::numeric_limits<std::int64_t>::max();
    std::exception_ptr error_;
};

/// Answers the checkpoints of one thread of a loop.
class LoopCheckpoints final : public Checkpoints {
  public:
    /// `leads`: this thread called parallel_blocks().
    LoopCheckpoints(BlockQueue& queue, bool leads)
        : Checkpoints(true), queue_(queue), leads_(leads) {}

    void check() override {
        if (leads_)
            queue_.check(outer());
        if (queue_.cancelled())
            throw LoopStopped();
    }
    /// Between two blocks.
    void report(Stage stage) {
        Call::reach(stage, queue_.done());
        queue_.check(outer());
    }

  private:
    BlockQueue& queue_;
    bool leads_;
};

} // namespace

int thread_count(std::optional<std::int64_t> requested) {
    if (requested)
        return static_cast<int>(*requested);
    // hardware_concurrency() counts the machine; a container or taskset allows fewer.
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
        return std::max(1, CPU_COUNT(&allowed));
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_blocks(std::int64_t blocks, int threads,
                     const std::function<void(std::int64_t)>& body, std::optional<Stage> stage) {
    BlockQueue queue(blocks, body);
    const auto help = [&queue] {
        const LoopCheckpoints checkpoints(queue, false);
        while (queue.run_one()) {
        }
    };
    const auto lead = [&queue, stage] {
        LoopCheckpoints checkpoints(queue, true);
        bool reported = !stage;
        while (queue.run_one())
            if (stage) {
                checkpoints.report(*stage);
                reported = true;
            }
        if (!reported) // the other threads took all blocks
            checkpoints.report(*stage);
    };
    const std::int64_t helpers = std::min<std::int64_t>(threads, blocks) - 1;
    if (helpers < 1)
        lead();
    else if (ThreadPool* pool = SharedThreads::available_pool())
        pool->run(helpers, help, lead);
    else
        ThreadPool().run(helpers, help, lead);
    queue.rethrow();
}

namespace {

thread_local SharedThreads* shared_threads = nullptr;

} // namespace

SharedThreads::SharedThreads() {
    if (shared_threads == nullptr)
        shared_threads = this;
}

SharedThreads::~SharedThreads() {
    if (shared_threads == this)
        shared_threads = nullptr;
}

ThreadPool* SharedThreads::available_pool() {
    if (shared_threads == nullptr)
        return nullptr;
    auto& pool = shared_threads->pool_;
    if (!pool)
        pool = std::make_unique<ThreadPool>();
    return pool->running() ? nullptr : pool.get();
}

} // namespace stltsa
