// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace stltsa {

/// A file of float64, rows x cols, or with `space` rows x (cols / space) x space: version 1.0 of
/// the format (NumPy Enhancement Proposal 1).
std::string npy_bytes(const double* values, std::int64_t rows, std::int64_t cols,
                      std::int64_t space = 0);

} // namespace stltsa
