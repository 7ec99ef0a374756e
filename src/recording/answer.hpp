// SPDX-License-Identifier: BSD-3-Clause
// From segments in rows, or from one motion, to the whole answer in samples.
#pragma once

#include "recording/drafts.hpp"

namespace stltsa::recording {

/// Of a clip of one motion.
Recording answer_of(const Signal& signal, motion::Decomposition single, ConstMatrixView samples,
                    const Options& options, const Progress& progress);

struct Context {
    const Signal& signal;
    const KernelFeatures& features;
    const Pauses& pauses;
};

/// `single`: the whole clip as one motion; empty for a long recording.
Recording answer_of(const Context& context, std::vector<Draft> drafts, motion::Decomposition single,
                    ConstMatrixView samples, const Options& options, const Progress& progress);

} // namespace stltsa::recording
