// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <map>

#include <fmt/format.h>

#include "arguments/choices.hpp"
#include "arguments/marks.hpp"
#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string sentence(const stltsa::Clip& clip, const std::string& title) {
    const std::string frames = counted(clip.frames(), "frame");
    const std::string format = upper(named(clip.info(), STLTSA_INFO_FORMAT));
    if (!(clip.fps() > 0))
        return fmt::format("{}: {}, {}, frame rate unknown", title, format, frames);
    return fmt::format("{}: {}, {} at {:.6g} per second, {:.3f} s", title, format, frames,
                       clip.fps(), static_cast<double>(clip.frames()) / clip.fps());
}

std::string joints_text(const stltsa::Clip& clip) {
    const std::vector<stltsa::Joint> joints = clip.joints();
    if (joints.empty())
        return clip.info().integer(STLTSA_INFO_FEATURES) == STLTSA_FEATURES_POINTS
                   ? "none: the file has points"
                   : "none: the file is a plain matrix";
    return fmt::format(
        "{} (with {})", joints.size(),
        counted(std::ranges::count(joints, 1, &stltsa::Joint::is_end_site), "end site"));
}

} // namespace

std::string info_report(const stltsa::Clip& clip, const std::string& title) {
    const stltsa::Info info = clip.info();
    Facts lines;
    if (const std::string path = info.text(STLTSA_INFO_PATH); !path.empty())
        lines.add("path", one_line(path));
    lines.add("joints", joints_text(clip));
    lines.add("channels", std::to_string(info.integer(STLTSA_INFO_CHANNELS)));
    lines.add("features", fmt::format("{}, {}", named(info, STLTSA_INFO_FEATURES),
                                      counted(clip.feature_count(), "column")));
    if (info.integer(STLTSA_INFO_UP_AXIS) > 0)
        lines.add("up axis", named(info, STLTSA_INFO_UP_AXIS));
    if (const std::string unit = info.text(STLTSA_INFO_LENGTH_UNIT); !unit.empty())
        lines.add("unit", one_line(unit));
    std::map<std::string, std::int64_t> events;
    for (const stltsa::FileEvent& event : clip.events())
        ++events[name_of(event)];
    for (const auto& [name, count] : events)
        lines.add(name == events.begin()->first ? "events" : "",
                  fmt::format("{} of {}", count, one_line(name)));
    if (const std::int64_t tpose = info.integer(STLTSA_INFO_FIRST_FRAME); tpose > 0)
        lines.add("T-pose",
                  counted(tpose, "frame") + " at the start, dropped by the other commands");
    return bold(sentence(clip, title)) + "\n\n" + lines.text() +
           listed("note:", info.texts(STLTSA_INFO_NOTE));
}

} // namespace tool
