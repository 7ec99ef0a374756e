// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <stltsa.hpp>

namespace tool {

/// Heading y1,y2,... for a column "y", and a line per row; numbers read back to the same bits.
std::string csv_text(const stltsa::Matrix& grid, const char* column);

} // namespace tool
