// SPDX-License-Identifier: BSD-3-Clause
#include "clip/text/number.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

namespace stltsa::clip {
namespace {

std::string_view without_plus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+')
        text.remove_prefix(1);
    return text;
}

/// A value that std::from_chars reports as out of range is either huge or tiny.
double out_of_range(std::string_view text) {
    const bool tiny = text.find("e-") != text.npos || text.find("E-") != text.npos ||
                      text.find_first_of("123456789") > text.find('.');
    if (tiny)
        return 0;
    const double huge = std::numeric_limits<double>::infinity();
    return text[0] == '-' ? -huge : huge;
}

} // namespace

std::optional<double> parse_number(std::string_view text) {
    text = without_plus(text);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error == std::errc::invalid_argument)
        return std::nullopt;
    return error == std::errc::result_out_of_range ? out_of_range(text) : value;
}

void append_number(std::string& text, double value) {
    // Fixed notation as long as the number of zeros stays readable.
    const double size = std::abs(value);
    const bool plain = value == 0 || (size >= 1e-5 && size < 1e16);
    char digits[32];
    const auto result =
        std::to_chars(std::begin(digits), std::end(digits), value,
                      plain ? std::chars_format::fixed : std::chars_format::scientific);
    text.append(digits, result.ptr);
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
    text = without_plus(text);
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (stop != end || error != std::errc())
        return std::nullopt;
    return value;
}

double rate_of(double seconds) {
    // .008333 gives 120.005; the rate that is nearest to an integer, 29.97, is 0.1 % off.
    constexpr double tolerance = 5e-4;
    const double fps = seconds > 0 ? 1 / seconds : 0;
    if (!std::isfinite(fps))
        return 0;
    const double whole = std::round(fps);
    return std::abs(fps - whole) <= tolerance * whole ? whole : fps;
}

} // namespace stltsa::clip
