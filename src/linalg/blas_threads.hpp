// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace stltsa {

/// While at least one of these lives, OpenBLAS runs single-threaded; the number of threads it had
/// comes back with the last one. Our own loops already use every thread asked for, and results
/// must not depend on how BLAS would split its sums. Does nothing for other BLAS libraries.
class SingleThreadedBlas {
  public:
    SingleThreadedBlas();
    ~SingleThreadedBlas();
    SingleThreadedBlas(const SingleThreadedBlas&) = delete;
    SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;
};

} // namespace stltsa
