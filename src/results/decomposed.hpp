// SPDX-License-Identifier: BSD-3-Clause
// A decomposition in frames and seconds of the source file.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "motion/decompose.hpp"
#include "results/samples.hpp"
#include "stltsa.h"

namespace stltsa::results {

struct Decomposed {
    motion::Decomposition result; ///< in samples
    Source source;
    std::vector<stltsa_interval>
        units; ///< in frames of the source file, from its first to its last
    std::vector<stltsa_interval> cycles;
};

/// The clip's frame rate must be known. Sets the fields of `options` that are for messages only.
Decomposed decompose(const clip::Clip& clip, const clip::PrepareOptions& prepare,
                     motion::DecomposeOptions options, const Progress& progress);

} // namespace stltsa::results
