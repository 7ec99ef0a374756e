// SPDX-License-Identifier: BSD-3-Clause
#include "report/packed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <zlib.h>

#include "base/error.hpp"
#include "base/text.hpp"

namespace stltsa::report {
namespace {

constexpr std::uint16_t missing = 65535;
constexpr double most = 65534; ///< the largest integer of a value

/// How the integers of each range of columns become values.
struct Ranges {
    std::vector<double> low, unit;
};

Ranges ranges_of(ConstMatrixView values, std::int64_t count) {
    const auto size = static_cast<std::size_t>(count);
    Ranges found{std::vector<double>(size, std::numeric_limits<double>::infinity()),
                 std::vector<double>(size)};
    std::vector<double> high(size, -std::numeric_limits<double>::infinity());
    for (std::int64_t r = 0; r < values.rows; ++r)
        for (std::int64_t c = 0; c < values.cols; ++c)
            if (const double value = values(r, c); std::isfinite(value)) {
                const auto at = static_cast<std::size_t>(c % count);
                found.low[at] = std::min(found.low[at], value);
                high[at] = std::max(high[at], value);
            }
    for (std::size_t i = 0; i < size; ++i) {
        found.low[i] = std::isfinite(found.low[i]) ? found.low[i] : 0;
        found.unit[i] = high[i] > found.low[i] ? (high[i] - found.low[i]) / most : 1;
    }
    return found;
}

std::string integers_of(ConstMatrixView values, const Ranges& ranges) {
    const auto count = static_cast<std::size_t>(values.rows * values.cols);
    std::string bytes(2 * count, '\0');
    std::size_t at = 0;
    for (std::int64_t c = 0; c < values.cols; ++c) {
        const auto range = static_cast<std::size_t>(c) % ranges.low.size();
        std::uint16_t above = 0;
        for (std::int64_t r = 0; r < values.rows; ++r, ++at) {
            const double steps = (values(r, c) - ranges.low[range]) / ranges.unit[range];
            const std::uint16_t integer =
                std::isfinite(steps)
                    ? static_cast<std::uint16_t>(std::lround(std::clamp(steps, 0.0, most)))
                    : missing;
            const auto difference = static_cast<std::uint16_t>(integer - above);
            bytes[at] = static_cast<char>(difference & 0xff);
            bytes[count + at] = static_cast<char>(difference >> 8);
            above = integer;
        }
    }
    return bytes;
}

std::string compressed(const std::string& bytes) {
    // Level 9 saves less than 1 % of the bytes of measure/report, whose ten minutes then take 1.5
    // times as long.
    constexpr int level = 6;
    uLongf size = ::compressBound(static_cast<uLong>(bytes.size()));
    std::string result(size, '\0');
    const int status = ::compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                                   reinterpret_cast<const Bytef*>(bytes.data()),
                                   static_cast<uLong>(bytes.size()), level);
    if (status == Z_MEM_ERROR)
        fail(Status::no_memory, "out of memory while compressing the numbers of the report");
    if (status != Z_OK)
        fail(Status::internal, "zlib cannot compress: status {}", status);
    result.resize(size);
    return result;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::string_view three = bytes.substr(i, 3);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= three.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace

std::string checksum(std::string_view bytes) {
    uLong sum = ::crc32(0, nullptr, 0);
    while (!bytes.empty()) { // zlib counts in unsigned int
        const std::string_view block = bytes.substr(0, std::size_t{1} << 30);
        sum = ::crc32(sum, reinterpret_cast<const Bytef*>(block.data()),
                      static_cast<uInt>(block.size()));
        bytes.remove_prefix(block.size());
    }
    return format_text("{:08x}", sum);
}

Json packed(ConstMatrixView values, std::int64_t ranges) {
    const Ranges found = ranges_of(values, ranges);
    return JsonObject("rows", values.rows, "cols", values.cols, "low", found.low, "unit",
                      found.unit, "data", base64(compressed(integers_of(values, found))));
}

Json packed(ConstMatrixView values) {
    return packed(values, std::max<std::int64_t>(values.cols, 1));
}

Json packed(std::span<const double> values) {
    Matrix column(static_cast<std::int64_t>(values.size()), 1);
    std::ranges::copy(values, column.data());
    return packed(column.view());
}

std::string compressed_text(const std::string& text) {
    return base64(compressed(text));
}

} // namespace stltsa::report
