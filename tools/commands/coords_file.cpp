// SPDX-License-Identifier: BSD-3-Clause
#include "commands/coords_file.hpp"

#include <fmt/format.h>

namespace tool {

std::string csv_text(const stltsa::Matrix& grid, const char* column, double fps) {
    const bool timed = fps > 0;
    std::string text = timed ? "time" : "";
    for (std::int64_t c = 0; c < grid.cols; ++c)
        text += fmt::format("{}{}{}", c > 0 || timed ? "," : "", column, c + 1);
    text += '\n';
    for (std::int64_t r = 0; r < grid.rows; ++r) {
        if (timed)
            text += fmt::format("{}", static_cast<double>(r) / fps);
        for (std::int64_t c = 0; c < grid.cols; ++c)
            text += fmt::format("{}{}", c > 0 || timed ? "," : "", grid(r, c));
        text += '\n';
    }
    return text;
}

} // namespace tool
