// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include <fmt/format.h>

#include "report.hpp"
#include "style.hpp"
#include "table.hpp"
#include "text.hpp"

namespace tool {
namespace {

std::string sentence(const Json& mapping, const std::string& title) {
    const Json& path = mapping["model"]["path"];
    const std::string model = path.is_null() ? "standard input" : path.get<std::string>();
    const std::string rows = counted(mapping["rows"].get<std::size_t>(),
                                     mapping["direction"] == "map" ? "frame" : "point");
    const auto beyond = mapping["beyond"]["count"].get<std::size_t>();
    return fmt::format("{} on {}: {}, {} beyond what the model knows", title,
                       std::filesystem::path(model).filename().string(), rows,
                       beyond == 0 ? "none" : std::to_string(beyond));
}

std::string rows_text(const Json& mapping) {
    const auto rows = mapping["rows"].get<std::size_t>();
    const Json& fps = mapping["fps"];
    if (fps.is_null())
        return fmt::format("{}, rate unknown", rows);
    return fmt::format("{}, {:.6g} a second ({:.2f} s)", rows, fps.get<double>(),
                       static_cast<double>(rows) / fps.get<double>());
}

/// "12-40, 77-78"; the first ones where there are many.
std::string stretches_text(const Json& stretches) {
    constexpr std::size_t most = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, stretches.size()); ++i)
        text += fmt::format("{}{}-{}", i == 0 ? "" : ", ", stretches[i]["begin"].dump(),
                            stretches[i]["end"].dump());
    if (stretches.size() > most)
        text += fmt::format(" and {} more (--json has all)", stretches.size() - most);
    return text;
}

constexpr const char* legend = "  distance: from what the model was fitted to, 1 being as far as "
                               "its own kind goes\n";

} // namespace

std::string mapping_report(const Json& mapping, const std::string& title, bool colors) {
    const Json& distance = mapping["distance"];
    const Json& model = mapping["model"];
    Facts facts;
    facts.add("model",
              fmt::format("{}, {}, {}", counted(model["frames"].get<std::size_t>(), "sample"),
                          counted(model["features"].get<std::size_t>(), "feature"),
                          counted(model["dimension"].get<std::size_t>(), "coordinate")));
    facts.add(mapping["direction"] == "map" ? "frames" : "points", rows_text(mapping));
    facts.add("distance",
              fmt::format("median {:.2f}, 90th percentile {:.2f}, largest {:.2f}",
                          distance["median"].get<double>(), distance["p90"].get<double>(),
                          distance["largest"].get<double>()));
    if (mapping["beyond"]["count"] > 0)
        facts.add("beyond", stretches_text(mapping["beyond"]["stretches"]));
    return bold(wrapped(sentence(mapping, title), 80), colors) + "\n\n" + facts.text() +
           dim(legend, colors) + listed("warning:", mapping["warnings"]);
}

} // namespace tool
