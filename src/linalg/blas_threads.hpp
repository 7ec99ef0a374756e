// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace stltsa {

/// Whether this process has loaded OpenBLAS.
bool blas_is_openblas();

/// During its lifetime OpenBLAS runs single-threaded; the last one to end restores the number of
/// threads. The library's own loops already use all requested threads. No effect on other BLAS
/// libraries.
class SingleThreadedBlas {
  public:
    SingleThreadedBlas();
    ~SingleThreadedBlas();
    SingleThreadedBlas(const SingleThreadedBlas&) = delete;
    SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;
};

} // namespace stltsa
