// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

struct NpyHeader {
    char kind = 'f';           ///< f: floats of 4 or 8 bytes; i, u: integers, u without sign
    std::size_t item_size = 8; ///< 1, 2, 4 or 8
    bool big_endian = false;
    bool fortran_order = false;
    std::vector<std::int64_t> shape;
    std::size_t data_begin = 0;
};

/// Reads versions 1.0 to 3.0 of the format (NumPy Enhancement Proposal 1 and numpy.lib.format).
NpyHeader read_npy_header(std::string_view bytes, const std::string& name);

} // namespace stltsa::clip
