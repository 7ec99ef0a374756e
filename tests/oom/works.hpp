// SPDX-License-Identifier: BSD-3-Clause
// Tasks during which memory runs out.
#pragma once

#include <string>
#include <vector>

#include "stltsa.h"

/// Returns the status of the first failed call; 1 if a failed call left a handle. The first run of
/// a work, and those during which no allocation fails, must succeed.
struct Work {
    const char* name;
    stltsa_status (*run)(const std::string& input);
    bool allocates = true; ///< else no allocation may fail in it
};

/// The functions that the works of oom.cpp do not call (scripts/check-tested compares the calls
/// with the header).
std::vector<Work> other_works();
