// SPDX-License-Identifier: BSD-3-Clause
#include "base/thread_pool.hpp"

#include <algorithm>
#include <exception>

namespace stltsa {
ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        wake_.notify_all();
    }
    for (auto& thread : threads_)
        thread.join();
}

void ThreadPool::run(std::int64_t helpers, const std::function<void()>& help,
                     const std::function<void()>& lead) {
    start(helpers);
    const std::int64_t slots = std::min(helpers, static_cast<std::int64_t>(threads_.size()));
    {
        const std::lock_guard lock(mutex_);
        help_ = &help;
        slots_ = slots;
        // While the mutex is held, or helgrind reports an error. A loop of 8 blocks takes 26 us
        // with it and without it.
        for (std::int64_t i = 0; i < slots; ++i)
            wake_.notify_one();
    }
    lead();
    std::unique_lock lock(mutex_);
    slots_ = 0;
    idle_.wait(lock, [this] { return working_ == 0; });
    help_ = nullptr;
}

void ThreadPool::start(std::int64_t count) {
    try {
        while (static_cast<std::int64_t>(threads_.size()) < count)
            threads_.emplace_back([this] { work(); });
    } catch (const std::exception&) {
        // No more threads can be started: those that exist do the work.
    }
}

void ThreadPool::work() {
    for (;;) {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return slots_ > 0 || ending_; });
        if (ending_)
            return;
        --slots_;
        ++working_;
        lock.unlock();
        (*help_)();
        lock.lock();
        if (--working_ == 0)
            idle_.notify_one();
    }
}

} // namespace stltsa
