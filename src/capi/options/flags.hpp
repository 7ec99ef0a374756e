// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "stltsa.h"

namespace stltsa::capi {

/// The options that were set and that these calls (STLTSA_CALL_*) have, as flags of the command: a
/// blank before each. Without the number of threads, which changes no result.
std::string flags_of(const stltsa_options* options, int32_t calls);

} // namespace stltsa::capi
