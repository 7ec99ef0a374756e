// SPDX-License-Identifier: BSD-3-Clause
#include "base/npy_bytes.hpp"

#include <bit>
#include <cstring>

#include "base/text.hpp"

namespace stltsa {

std::string npy_bytes(const double* values, std::int64_t rows, std::int64_t cols,
                      std::int64_t space) {
    constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
    std::string header =
        format_text("{{'descr': '{}f8', 'fortran_order': False, 'shape': ({}), }}", order,
                    space > 0 ? format_text("{}, {}, {}", rows, cols / space, space)
                              : format_text("{}, {}", rows, cols));
    constexpr std::size_t preamble = 10; // magic, version, two bytes of header length
    constexpr std::size_t alignment = 64;
    const std::size_t unpadded = preamble + header.size() + 1;
    header.append((alignment - unpadded % alignment) % alignment, ' ');
    header += '\n';

    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() % 256);
    bytes += static_cast<char>(header.size() / 256);
    bytes += header;
    const std::size_t begin = bytes.size();
    const std::size_t size =
        static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols) * sizeof(double);
    bytes.resize(begin + size);
    std::memcpy(bytes.data() + begin, values, size);
    return bytes;
}

} // namespace stltsa
