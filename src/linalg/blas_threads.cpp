// SPDX-License-Identifier: BSD-3-Clause
#include "linalg/blas_threads.hpp"

#include <mutex>

// With -lblas, the machine on which a program runs decides whether the BLAS is OpenBLAS; if not,
// these addresses are null. With -lopenblas the references are strong, because a static linker does
// not search a library for weak ones.
#ifdef STLTSA_OPENBLAS
#define STLTSA_IF_LOADED
#else
#define STLTSA_IF_LOADED [[gnu::weak]]
#endif
extern "C" {
STLTSA_IF_LOADED int openblas_get_num_threads();
STLTSA_IF_LOADED void openblas_set_num_threads(int count);
}

namespace stltsa {
namespace {

// OpenBLAS has one setting per process, so its users are counted per process.
std::mutex mutex;
int users = 0;
int threads_before = 1;

} // namespace

bool blas_is_openblas() {
#ifdef STLTSA_OPENBLAS
    return true;
#else
    return openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr;
#endif
}

SingleThreadedBlas::SingleThreadedBlas() {
    if (!blas_is_openblas())
        return;
    const std::lock_guard lock(mutex);
    if (users++ == 0) {
        threads_before = openblas_get_num_threads();
        openblas_set_num_threads(1);
    }
}

SingleThreadedBlas::~SingleThreadedBlas() {
    if (!blas_is_openblas())
        return;
    const std::lock_guard lock(mutex);
    if (--users == 0)
        openblas_set_num_threads(threads_before);
}

} // namespace stltsa
