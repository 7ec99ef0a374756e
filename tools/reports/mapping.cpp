// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "reports/report.hpp"
#include "reports/table.hpp"
#include "terminal/style.hpp"
#include "terminal/text.hpp"
#include "terminal/width.hpp"

namespace tool {
namespace {

std::string sentence(const Mapping& mapping, const std::string& title, std::int64_t beyond) {
    const std::string& path = mapping.arguments.model;
    const std::string model =
        path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
    const auto rows = static_cast<std::int64_t>(mapping.rows.distance.size());
    return fmt::format("{} on {}: {}, {} outside the model's range", title, model,
                       counted(rows, mapping.is_map() ? "frame" : "point"),
                       beyond == 0 ? "none" : std::to_string(beyond));
}

std::string rows_text(std::size_t rows, double fps) {
    if (!(fps > 0))
        return fmt::format("{}, rate unknown", rows);
    return fmt::format("{}, {:.6g} per second ({:.2f} s)", rows, fps,
                       static_cast<double>(rows) / fps);
}

/// "12-40, 77-78"; only the first ones if there are many.
std::string stretches_text(const Distances& distances) {
    constexpr std::size_t most = 12;
    const auto& stretches = distances.stretches;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, stretches.size()); ++i)
        text += fmt::format("{}{}-{}", i == 0 ? "" : ", ", stretches[i].first, stretches[i].second);
    if (stretches.size() > most)
        text += fmt::format(" and {} more (--json lists all)", stretches.size() - most);
    return text;
}

std::string beyond_text(double median) {
    const std::string what = motion_at(median);
    return fmt::format("{:.1f} times the model's range at the median, as {}{} usually is", median,
                       what, what.find(',') == what.npos ? "" : ",");
}

} // namespace

std::string mapping_report(const Mapping& mapping, const std::string& title) {
    const Distances distances = distances_of(mapping.rows);
    const stltsa::Model& model = mapping.model;
    Facts facts;
    facts.add("model",
              fmt::format("{}, {}, {}", counted(model.info().integer(STLTSA_INFO_ROWS), "sample"),
                          counted(model.info().integer(STLTSA_INFO_FEATURE_COUNT), "feature"),
                          counted(model.info().integer(STLTSA_INFO_DIMENSION), "coordinate")));
    facts.add(mapping.is_map() ? "frames" : "points",
              rows_text(mapping.rows.distance.size(), mapping.fps));
    facts.add("distance", fmt::format("median {:.2f}, 90th percentile {:.2f}, largest {:.2f} "
                                      "(above 1: outside the model's range)",
                                      distances.median, distances.p90, distances.largest));
    if (distances.beyond > 0)
        facts.add("outside", stretches_text(distances));
    if (!motion_at(distances.median).empty())
        facts.add("how far", beyond_text(distances.median));
    return bold(wrapped(sentence(mapping, title, distances.beyond),
                        terminal_columns(STDOUT_FILENO))) +
           "\n\n" + facts.text() + listed("note:", mapping.notes) +
           listed("warning:", mapping.warnings);
}

} // namespace tool
