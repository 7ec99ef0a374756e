// SPDX-License-Identifier: BSD-3-Clause
#include "batch/summary.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "terminal/text.hpp"

namespace tool::batch {
namespace {

constexpr const char* numbers_head =
    "frames,segments,cycles,repetitions,period_s,fps,duration_s,confidence";

std::string number(const nlohmann::json& value) {
    return value.is_null() ? "" : value.dump();
}

/// Confidence of the longest segment that moves.
std::string confidence_of(const nlohmann::json& segments) {
    const nlohmann::json* longest = nullptr;
    const auto length = [](const nlohmann::json& s) {
        return s["end_s"].get<double>() - s["begin_s"].get<double>();
    };
    for (const nlohmann::json& segment : segments)
        if (segment["kind"] != "rest" && (longest == nullptr || length(segment) > length(*longest)))
            longest = &segment;
    return longest == nullptr ? "" : number((*longest)["confidence"]);
}

} // namespace

Row row_of(const std::string& path, const nlohmann::json& result) {
    const nlohmann::json& clip = result.at("clip");
    const auto count = [&](const char* parts) { return result.at(parts).size(); };
    Row row{path, "done", "", "", "", false};
    row.numbers = fmt::format("{},{},{},{},{},{},{},{}", number(clip.at("frames")),
                              count("segments"), count("cycles"), count("repetitions"),
                              number(result.at("period_s")), number(clip.at("fps")),
                              number(clip.at("duration_s")), confidence_of(result.at("segments")));
    if (result.at("reason").is_string())
        row.reason = result.at("reason").get<std::string>();
    return row;
}

Row failed_row(const std::string& path, const std::string& status, const std::string& error) {
    return {path, status, error, ",,,,,,,", "", false};
}

std::string summary_csv(const std::vector<Row>& rows) {
    std::string text = fmt::format("path,status,error,{},reason\n", numbers_head);
    for (const Row& row : rows)
        text += fmt::format("{},{},{},{},{}\n", csv_cell(row.path), row.status, csv_cell(row.error),
                            row.numbers, csv_cell(row.reason));
    return text;
}

} // namespace tool::batch
