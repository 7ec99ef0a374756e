// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/marks.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "exit_status.hpp"

namespace tool {
namespace {

std::optional<double> number_in(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace

Marks parse_marks(const std::vector<std::string>& given, double fps) {
    Marks marks;
    for (const std::string& typed : given) {
        const std::size_t sign = typed.find('=');
        std::string_view place = std::string_view(typed).substr(0, sign);
        const bool seconds = place.ends_with('s');
        if (seconds)
            place.remove_suffix(1);
        const auto value = number_in(place);
        if (!value || sign == std::string::npos || sign + 1 == typed.size())
            throw Failure(Exit::usage,
                          fmt::format("--mark is given '{}': it takes FRAME=NAME, such as "
                                      "131=strike or 2.5s=strike",
                                      typed));
        if (seconds && !(fps > 0))
            throw Failure(Exit::usage, fmt::format("--mark {}: the frame rate is unknown: give a "
                                                   "frame, or --fps",
                                                   typed));
        marks[typed.substr(sign + 1)].push_back(seconds ? *value * fps : *value);
    }
    return marks;
}

} // namespace tool
