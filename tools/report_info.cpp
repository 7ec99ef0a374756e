// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "report.hpp"
#include "style.hpp"
#include "table.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string sentence(const Json& facts, const std::string& title) {
    const std::string frames = counted(facts["frames"].get<std::size_t>(), "frame");
    const std::string format = upper(facts["format"]);
    if (facts["fps"].is_null())
        return fmt::format("{}: {} of {}, frame rate unknown", title, frames, format);
    return fmt::format("{}: {} of {} at {:.6g} a second, {:.3f} s", title, frames, format,
                       facts["fps"].get<double>(), facts["duration_s"].get<double>());
}

std::string joints_text(const Json& joints) {
    if (joints.empty())
        return "none: the columns are bare numbers";
    const auto ends = std::ranges::count_if(
        joints, [](const Json& joint) { return joint["end_site"].get<bool>(); });
    return fmt::format("{} (with {})", joints.size(),
                       counted(static_cast<std::size_t>(ends), "end site"));
}

} // namespace

std::string info_report(const Json& clip, const std::string& title, bool colors) {
    const Json& facts = clip["clip"];
    Facts lines;
    if (!facts["path"].is_null())
        lines.add("path", facts["path"]);
    lines.add("joints", joints_text(clip["joints"]));
    lines.add("channels", clip["channels"]["count"].dump());
    lines.add("features", fmt::format("{}, {}", facts["features"].get<std::string>(),
                                      counted(clip["feature_count"].get<std::size_t>(), "column")));
    if (!clip["up_axis"].is_null())
        lines.add("up axis", clip["up_axis"]);
    if (const auto tpose = facts["dropped_start_frames"].get<std::size_t>(); tpose > 0)
        lines.add("T-pose", counted(tpose, "frame") + " at the start, which other commands drop");
    return bold(sentence(facts, title), colors) + "\n\n" + lines.text() +
           listed("note:", facts["notes"]);
}

} // namespace tool
