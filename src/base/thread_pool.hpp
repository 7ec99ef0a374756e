// SPDX-License-Identifier: BSD-3-Clause
// Threads that wait between parallel loops: a fit has many loops, some as short as the start of a
// thread. The pool and its threads end with the call that made it. Threads of OpenMP or TBB would
// outlive the call, and a process that forks between two calls would then wait for them forever.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace stltsa {

/// Used by one calling thread at a time.
class ThreadPool {
  public:
    ThreadPool() = default;
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// Runs lead() on this thread and help() on up to `helpers` others: on fewer if lead() ends
    /// before they start, or if no more can be started. Returns when all have ended. Neither may
    /// throw.
    void run(std::int64_t helpers, const std::function<void()>& help,
             const std::function<void()>& lead);
    /// Whether a call of run() is in progress.
    bool running() const { return help_ != nullptr; }

  private:
    void start(std::int64_t count);
    void work();

    std::vector<std::thread> threads_;
    std::mutex mutex_; ///< guards the members below
    const std::function<void()>* help_ = nullptr;
    std::int64_t slots_ = 0; ///< threads that may still join
    std::int64_t working_ = 0;
    bool ending_ = false;
    std::condition_variable wake_; ///< a free slot, or the end
    std::condition_variable idle_; ///< no thread is working
};

} // namespace stltsa
