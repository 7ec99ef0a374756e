// SPDX-License-Identifier: BSD-3-Clause
#include "coords_file.hpp"

#include <bit>
#include <cstring>

#include <fmt/format.h>

namespace tool {

std::string npy_bytes(const Grid& grid) {
    constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
    std::string header =
        fmt::format("{{'descr': '{}f8', 'fortran_order': False, 'shape': ({}, {}), }}", order,
                    grid.rows, grid.cols);
    constexpr std::size_t preamble = 10; // magic, version, two bytes of header length
    constexpr std::size_t alignment = 64;
    const std::size_t unpadded = preamble + header.size() + 1;
    header.append((alignment - unpadded % alignment) % alignment, ' ');
    header += '\n';

    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() % 256);
    bytes += static_cast<char>(header.size() / 256);
    bytes += header;
    const std::size_t start = bytes.size();
    bytes.resize(start + grid.values.size() * sizeof(double));
    if (!grid.empty())
        std::memcpy(bytes.data() + start, grid.values.data(), grid.values.size() * sizeof(double));
    return bytes;
}

std::string csv_text(const Grid& grid, const char* column) {
    std::string text;
    for (std::int64_t c = 0; c < grid.cols; ++c)
        text += fmt::format("{}{}{}", c == 0 ? "" : ",", column, c + 1);
    text += '\n';
    for (std::int64_t r = 0; r < grid.rows; ++r) {
        for (std::int64_t c = 0; c < grid.cols; ++c)
            text += fmt::format("{}{}", c == 0 ? "" : ",", grid(r, c));
        text += '\n';
    }
    return text;
}

} // namespace tool
