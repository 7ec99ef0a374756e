// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/width.hpp"

#include <algorithm>
#include <cstdlib>

#include <sys/ioctl.h>

namespace tool {
namespace {

// Texts are hard to read in longer lines, and tables in shorter ones.
constexpr long least = 40;
constexpr long most = 120;
constexpr long usual = 80;

} // namespace

std::size_t terminal_columns(int descriptor) {
    const char* variable = std::getenv("COLUMNS");
    long columns = variable == nullptr ? 0 : std::strtol(variable, nullptr, 10);
    winsize window{};
    if (columns <= 0 && ::ioctl(descriptor, TIOCGWINSZ, &window) == 0)
        columns = window.ws_col;
    return static_cast<std::size_t>(std::clamp(columns <= 0 ? usual : columns, least, most));
}

} // namespace tool
