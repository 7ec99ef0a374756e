// SPDX-License-Identifier: BSD-3-Clause
// For tests of work that can be cancelled.
#pragma once

#include "base/error.hpp"

namespace testing {

/// Whether the work ends with Status::cancelled.
template <class Work>
bool is_cancelled(const Work& work) {
    try {
        work();
        return false;
    } catch (const stltsa::Error& error) {
        return error.status() == stltsa::Status::cancelled;
    }
}

} // namespace testing
