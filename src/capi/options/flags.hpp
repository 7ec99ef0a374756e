// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>

#include "stltsa.h"

namespace stltsa::capi {

/// "period-min" of option period_min.
std::string flag_name(const stltsa_option_info& row);

/// The value of an option that is set, as typed in the command.
std::string typed_value(const stltsa_options& options, const stltsa_option_info& row);

/// The options that were set and that these calls (STLTSA_CALL_*) have, as flags of the command: a
/// blank before each. Leaves out the keys of `without` (STLTSA_OPT_*) and the number of threads,
/// which changes no result.
std::string flags_of(const stltsa_options* options, int32_t calls,
                     std::initializer_list<int32_t> without = {});

} // namespace stltsa::capi
