// SPDX-License-Identifier: BSD-3-Clause
#include "commands/mapped.hpp"

#include <algorithm>
#include <cmath>

#include "reports/json.hpp"

namespace tool {
namespace {

/// Distances are relative to the model's reach: beyond 1 a row is outside its range.
constexpr double limit = 1;

/// The quantile of sorted values.
double quantile(const std::vector<double>& sorted, double share) {
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(share * last))];
}

Json path_json(const std::string& path) {
    return path == "-" ? Json(nullptr) : Json(path);
}

Json model_json(const Mapping& mapping) {
    const stltsa::Model& model = mapping.model;
    return JsonObject("path", path_json(mapping.arguments.model), "frames",
                      model.info().integer(STLTSA_INFO_ROWS), "dimension",
                      model.info().integer(STLTSA_INFO_DIMENSION), "features",
                      model.info().integer(STLTSA_INFO_FEATURE_COUNT), "reach",
                      model.info().real(STLTSA_INFO_REACH));
}

Json beyond_json(const Distances& distances, std::size_t rows) {
    std::vector<Json> stretches;
    for (const auto& [begin, end] : distances.stretches)
        stretches.push_back(JsonObject("begin", begin, "end", end));
    const double share = static_cast<double>(distances.beyond) / static_cast<double>(rows);
    return JsonObject("count", distances.beyond, "share", share, "stretches", stretches, "verdict",
                      json_or_null(motion_at(distances.median)));
}

} // namespace

Distances distances_of(const stltsa::Mapped& rows) {
    std::vector<double> sorted = rows.distance;
    std::ranges::sort(sorted);
    Distances result{quantile(sorted, 0.5), quantile(sorted, 0.9), sorted.back(), 0, {}};
    for (std::size_t i = 0; i < rows.distance.size(); ++i) {
        if (rows.distance[i] <= limit)
            continue;
        const auto r = static_cast<std::int64_t>(i);
        ++result.beyond;
        if (result.stretches.empty() || result.stretches.back().second != r)
            result.stretches.emplace_back(r, r);
        ++result.stretches.back().second;
    }
    return result;
}

// Of 1392 pairs of short moves, the median distance was 0.4 to 1 for another take of the same
// motion, for another style of it 1.7, 2.3 and 3.3 (quartiles), and for another motion 3.1, 5.3
// and 9.4.
std::string motion_at(double median) {
    constexpr double style = 3;
    constexpr double other = 9;
    if (median <= limit)
        return "";
    if (median <= style)
        return "another style of the motion";
    return median <= other ? "another style of the motion, or another motion" : "another motion";
}

std::string mapping_json(const Mapping& mapping) {
    const stltsa::Mapped& rows = mapping.rows;
    const Distances distances = distances_of(rows);
    JsonObject object(
        "format", "stltsa-mapping/1", "library", stltsa::version(), "direction",
        mapping.is_map() ? "map" : "unmap", "model", model_json(mapping), "input",
        path_json(mapping.arguments.input), "rows", static_cast<std::int64_t>(rows.distance.size()),
        "fps", json_or_null(mapping.fps), "distance",
        JsonObject("median", distances.median, "p90", distances.p90, "largest", distances.largest),
        "beyond", beyond_json(distances, rows.distance.size()), "warnings", mapping.warnings,
        "notes", mapping.notes);
    if (mapping.arguments.curve)
        object.set("curve", JsonObject("coords", json_rows(rows.values), "distance", rows.distance,
                                       "nearest", rows.nearest));
    return object.text();
}

} // namespace tool
