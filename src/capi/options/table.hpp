// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "stltsa.h"

namespace stltsa::capi {

/// One row per option in order of keys; `size` is left 0.
std::span<const stltsa_option_info> options_table();

/// The row of a key. Throws Status::argument for an unknown key or one of another type.
const stltsa_option_info& option_row(int32_t key);
const stltsa_option_info& option_row(int32_t key, int32_t type);

} // namespace stltsa::capi
