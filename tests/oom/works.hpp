// SPDX-License-Identifier: BSD-3-Clause
// Tasks during which memory runs out.
#pragma once

#include <string>
#include <vector>

#include "stltsa.h"

/// Returns the status of the first failed call, or 1 if a failed call left a handle. The first run
/// of a work, and runs in which no allocation fails, must succeed.
struct Work {
    const char* name;
    stltsa_status (*run)(const std::string& input);
    bool allocates = true; ///< if false, the work must not allocate
};

/// The functions that the works of oom.cpp do not call (scripts/check-tested compares the calls
/// with the header).
std::vector<Work> other_works();
