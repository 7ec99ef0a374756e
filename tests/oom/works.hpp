// SPDX-License-Identifier: BSD-3-Clause
// Tasks during which memory runs out.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "stltsa.h"

/// A hash (FNV-1a with offset basis 0) of the results of the tasks. It must not depend on failed
/// allocations.
inline std::uint64_t noted = 0;

inline void note(const void* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
        noted = (noted ^ static_cast<const unsigned char*>(bytes)[i]) * 1099511628211U;
}
/// Of a text, if there is one.
inline void note(const char* text) {
    note(text, text == nullptr ? 0 : std::strlen(text));
}

/// Returns the status of the first failed call, or 1 if a failed call left a handle. The first run
/// of a work, and runs in which no allocation fails, must succeed.
struct Work {
    const char* name;
    stltsa_status (*run)(const std::string& input);
    bool allocates = true; ///< if false, the work must not allocate
};

/// The functions that the works of oom.cpp do not call (tests/checks/tested compares the calls
/// with the header).
std::vector<Work> other_works();

/// A batch of one clip, in a file of its own.
stltsa_status batches(const std::string& input);
