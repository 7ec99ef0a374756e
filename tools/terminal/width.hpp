// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tool {

/// Columns of the terminal behind a descriptor, 40 to 120: the variable COLUMNS, or else its
/// window; 80 without a terminal.
std::size_t terminal_columns(int descriptor);

} // namespace tool
