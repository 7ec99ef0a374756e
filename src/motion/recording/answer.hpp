// SPDX-License-Identifier: BSD-3-Clause
// From segments in rows to the whole answer in samples.
#pragma once

#include "motion/recording/drafts.hpp"

namespace stltsa::motion {

struct Context {
    const Signal& signal;
    const KernelFeatures& features;
    const Pauses& pauses;
};

Recording answer_of(const Context& context, std::vector<Draft> drafts, ConstMatrixView samples,
                    const Options& options);

} // namespace stltsa::motion
