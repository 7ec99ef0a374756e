// SPDX-License-Identifier: BSD-3-Clause
// The coordinate of all samples, from the stretches that have cycles.
#pragma once

#include "motion/recording/drafts.hpp"

namespace stltsa::motion {

Curve curve_of(const Signal& signal, const std::vector<Draft>& drafts, std::int64_t samples);

/// Why nothing repeats, with numbers; empty if something does.
std::string reason_of(const std::vector<Draft>& drafts, ConstMatrixView samples,
                      const Options& options);

} // namespace stltsa::motion
