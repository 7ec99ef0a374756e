// SPDX-License-Identifier: BSD-3-Clause
#include "terminal/progress_bar.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <stltsa.h>

namespace tool {
namespace {

const char* stage_name(std::int32_t stage) {
    switch (stage) {
    case STLTSA_STAGE_READ:
        return "reading";
    case STLTSA_STAGE_FEATURES:
        return "features";
    case STLTSA_STAGE_NEIGHBORS:
        return "neighbors";
    case STLTSA_STAGE_TANGENTS:
        return "tangents";
    case STLTSA_STAGE_ALIGNMENT:
        return "alignment";
    case STLTSA_STAGE_SPECTRUM:
        return "spectrum";
    case STLTSA_STAGE_UNITS:
        return "units";
    case STLTSA_STAGE_MAP:
        return "mapping";
    case STLTSA_STAGE_DENOISE:
        return "denoising";
    case STLTSA_STAGE_SYNTHESIS:
        return "synthesis";
    case STLTSA_STAGE_WRITE:
        return "writing";
    default:
        return "working";
    }
}

void write_stderr(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

} // namespace

void ProgressBar::show(std::int32_t stage, double fraction) {
    show(std::string(stage_name(stage)), fraction);
}

void ProgressBar::show(const std::string& label, double fraction) {
    constexpr auto rest = std::chrono::milliseconds(50);
    const auto now = std::chrono::steady_clock::now();
    // What takes less than half a second needs no bar.
    constexpr auto patience = std::chrono::milliseconds(500);
    if (!shown_ || now - begun_ < patience || (label == label_ && now - last_ < rest))
        return;
    label_ = label;
    last_ = now;
    drawn_ = true;
    constexpr int width = 30;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const auto full = static_cast<std::size_t>(share * width);
    write_stderr(fmt::format("\r\x1b[K{:<10} [{}{}] {:3.0f} %", label, std::string(full, '#'),
                             std::string(width - full, '.'), 100 * share));
}

void ProgressBar::clear() {
    if (drawn_)
        write_stderr("\r\x1b[K");
    drawn_ = false;
}

} // namespace tool
