// SPDX-License-Identifier: BSD-3-Clause
// Threads that wait for work between one parallel loop and the next: a fit has many loops, and
// some take no longer than starting a thread. They end with their pool, and that with the call that
// made it: those of OpenMP or TBB would outlive it, and a process that forks between two calls
// would wait for them for ever.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace stltsa {

/// Used by one thread at a time, from the outside.
class ThreadPool {
  public:
    ThreadPool() = default;
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;
    ~ThreadPool();

    /// Runs lead() here and meanwhile help() on up to `helpers` other threads: on fewer where
    /// lead() is over before they come, or where no more can be started. Returns when none of
    /// them is at it any more. Neither may throw.
    void run(std::int64_t helpers, const std::function<void()>& help,
             const std::function<void()>& lead);
    /// Whether run() is under way.
    bool running() const { return help_ != nullptr; }

  private:
    void start(std::int64_t count);
    void work();

    std::vector<std::thread> threads_;
    std::mutex mutex_; ///< held to change what is below
    const std::function<void()>* help_ = nullptr;
    std::int64_t places_ = 0; ///< for threads that may still come
    std::int64_t working_ = 0;
    bool ended_ = false;
    std::condition_variable wanted_; ///< a place, or the end
    std::condition_variable idle_;   ///< none is working
};

} // namespace stltsa
