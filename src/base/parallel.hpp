// SPDX-License-Identifier: BSD-3-Clause
// Parallel loops whose results do not depend on the number of threads: the caller divides the work
// into blocks, each block writes only its own outputs, and the caller adds up sums in block order.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "base/progress.hpp"
#include "base/thread_pool.hpp"

namespace stltsa {

/// Threads to use: as many as requested, else one for each core that this process may run on.
int thread_count(std::optional<std::int64_t> requested);

/// Runs body(block) for block = 0 .. blocks-1 on up to `threads` threads. With a stage, its
/// progress is reported on the caller's thread as blocks finish, at least once. The first exception
/// (lowest block, but that of a checkpoint before all others) is rethrown on the caller's thread
/// after every worker has stopped. Long blocks may call checkpoint(), also on the other threads: if
/// the loop is cancelled, it ends the block by an exception, which must reach parallel_blocks().
void parallel_blocks(std::int64_t blocks, int threads,
                     const std::function<void(std::int64_t block)>& body,
                     std::optional<Stage> stage = {});

/// During its lifetime the parallel loops of the thread that made it share their threads, which
/// start with the first loop that needs them. A nested one has no effect.
class SharedThreads {
  public:
    SharedThreads();
    ~SharedThreads();
    SharedThreads(const SharedThreads&) = delete;
    SharedThreads& operator=(const SharedThreads&) = delete;

    /// The threads for a loop of this thread; null outside these objects, and within another loop.
    static ThreadPool* available_pool();

  private:
    std::unique_ptr<ThreadPool> pool_;
};

} // namespace stltsa
