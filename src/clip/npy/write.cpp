// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cstring>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// Version 1.0 of the format (NumPy Enhancement Proposal 1).
std::string format_npy(const Clip& clip) {
    constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
    std::string header =
        format_text("{{'descr': '{}f8', 'fortran_order': False, 'shape': ({}, {}), }}", order,
                    clip.values.rows(), clip.values.cols());
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
    const std::size_t size = checked_size(clip.values.rows(), clip.values.cols()) * sizeof(double);
    bytes.resize(begin + size);
    std::memcpy(bytes.data() + begin, clip.values.data(), size);
    return bytes;
}

} // namespace stltsa::clip
