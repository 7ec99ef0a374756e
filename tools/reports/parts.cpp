// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "arguments/choices.hpp"
#include "reports/report.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

std::string in_seconds(std::int64_t samples, double fps) {
    return fps > 0 ? fmt::format(" ({:.2f} s)", static_cast<double>(samples) / fps) : "";
}

} // namespace

std::string samples_text(const stltsa::Info& result) {
    std::string text = std::to_string(result.integer(STLTSA_INFO_ROWS));
    if (const std::int64_t step = result.integer(STLTSA_INFO_FRAME_STEP); step > 1)
        text += fmt::format(", one frame in {}", step);
    if (const std::int64_t first = result.integer(STLTSA_INFO_FIRST_FRAME); first > 0)
        text += fmt::format(" from frame {} on", first);
    if (const double fps = result.real(STLTSA_INFO_FPS); fps > 0)
        text += fmt::format(", {:.6g} per second", fps);
    return text;
}

std::string neighbors_text(const stltsa::Info& result) {
    const double fps = result.real(STLTSA_INFO_FPS);
    const std::int64_t mode = result.integer(STLTSA_INFO_MODE);
    const std::int64_t neighbors = result.integer(STLTSA_INFO_NEIGHBORS);
    const std::int64_t window = result.integer(STLTSA_INFO_WINDOW);
    std::string text = fmt::format("k = {}{}", neighbors, in_seconds(neighbors, fps));
    if (mode != STLTSA_MODE_SPATIAL)
        text += fmt::format(", w = {}{}", window, in_seconds(window, fps));
    if (result.integer(STLTSA_INFO_INCLUDE_SELF) == 0)
        text += ", excluding the frame itself";
    text += ", " + named(result, STLTSA_INFO_MODE);
    if (mode == STLTSA_MODE_RECURRENT)
        text += fmt::format(" with {} links beyond {} samples", result.integer(STLTSA_INFO_LINKS),
                            result.integer(STLTSA_INFO_EXCLUSION));
    return text;
}

std::string features_text(const stltsa::Info& result) {
    std::string text = fmt::format("{}, {}", named(result, STLTSA_INFO_FEATURES),
                                   counted(result.integer(STLTSA_INFO_FEATURE_COUNT), "column"));
    if (result.integer(STLTSA_INFO_UP_AXIS) > 0)
        text += fmt::format(", {} up", named(result, STLTSA_INFO_UP_AXIS));
    if (const double smoothing = result.real(STLTSA_INFO_SMOOTHING); smoothing > 0)
        text += fmt::format(", smoothed over {:g} s", smoothing);
    return text;
}

} // namespace tool
