// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <stltsa.hpp>

namespace tool {

/// A heading y1,y2,... if `column` is "y", then one line per row; numbers are read back to the same
/// bits. If the rate is known, a column of seconds comes first.
std::string csv_text(const stltsa::Matrix& grid, const char* column, double fps = 0);

} // namespace tool
