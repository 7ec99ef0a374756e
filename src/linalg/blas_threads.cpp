// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/blas_threads.hpp"

#include <mutex>

#ifdef STLTSA_OPENBLAS
extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int count);
}
#endif

namespace stltsa {

#ifdef STLTSA_OPENBLAS
namespace {

// OpenBLAS has one setting per process, so its users are counted per process.
std::mutex mutex;
int users = 0;
int threads_before = 1;

} // namespace

SingleThreadedBlas::SingleThreadedBlas() {
    const std::lock_guard lock(mutex);
    if (users++ == 0) {
        threads_before = openblas_get_num_threads();
        openblas_set_num_threads(1);
    }
}

SingleThreadedBlas::~SingleThreadedBlas() {
    const std::lock_guard lock(mutex);
    if (--users == 0)
        openblas_set_num_threads(threads_before);
}
#else
SingleThreadedBlas::SingleThreadedBlas() = default;
SingleThreadedBlas::~SingleThreadedBlas() = default;
#endif

} // namespace stltsa
