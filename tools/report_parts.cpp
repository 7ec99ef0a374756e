// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "report.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string in_seconds(std::int64_t samples, const Json& fps) {
    if (fps.is_null())
        return "";
    return fmt::format(" ({:.2f} s)", static_cast<double>(samples) / fps.get<double>());
}

} // namespace

std::string samples_text(const Json& result) {
    const Json& samples = result["samples"];
    std::string text = samples["count"].dump();
    if (const auto step = samples["frame_step"].get<std::int64_t>(); step > 1)
        text += fmt::format(", 1 frame in {}", step);
    if (const auto first = samples["first_frame"].get<std::int64_t>(); first > 0)
        text += fmt::format(" from frame {} (T-pose dropped)", first);
    if (!samples["fps"].is_null())
        text += fmt::format(", {:.6g} a second", samples["fps"].get<double>());
    return text;
}

std::string neighbors_text(const Json& result) {
    const Json& parameters = result["parameters"];
    const Json& fps = result["samples"]["fps"];
    const auto neighbors = parameters["neighbors"].get<std::int64_t>();
    const auto window = parameters["window"].get<std::int64_t>();
    const std::string mode = parameters["mode"];
    std::string text = fmt::format("k = {}{}", neighbors, in_seconds(neighbors, fps));
    if (mode != "spatial")
        text += fmt::format(", w = {}{}", window, in_seconds(window, fps));
    if (!parameters["include_self"].get<bool>())
        text += ", without the frame itself";
    text += ", " + mode;
    if (mode == "recurrent")
        text += fmt::format(" with {} links outside {} samples", parameters["links"].dump(),
                            parameters["exclusion"].dump());
    return text;
}

std::string features_text(const Json& result) {
    const Json& samples = result["samples"];
    std::string text = fmt::format("{}, {}", result["clip"]["features"].get<std::string>(),
                                   counted(samples["feature_count"].get<std::size_t>(), "column"));
    if (!samples["up_axis"].is_null())
        text += fmt::format(", {} up", samples["up_axis"].get<std::string>());
    if (const double smoothing = samples["smoothing_s"]; smoothing > 0)
        text += fmt::format(", smoothed over {:g} s", smoothing);
    return text;
}

} // namespace tool
