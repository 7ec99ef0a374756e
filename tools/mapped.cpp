// SPDX-License-Identifier: BSD-3-Clause
#include "mapped.hpp"

#include <algorithm>
#include <cmath>

namespace tool {
namespace {

/// Distances are in units of this: beyond it a row is unlike what the model knows.
constexpr double limit = 1;

/// The value below which a share of the sorted values lies.
double quantile(const std::vector<double>& sorted, double share) {
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(share * last))];
}

Json distances_json(const stltsa::Mapped& mapped) {
    std::vector<double> sorted = mapped.distance;
    std::ranges::sort(sorted);
    return {{"median", quantile(sorted, 0.5)},
            {"p90", quantile(sorted, 0.9)},
            {"largest", sorted.back()}};
}

/// Stretches of rows beyond the limit.
Json beyond_json(const stltsa::Mapped& mapped) {
    Json stretches = Json::array();
    std::int64_t count = 0;
    for (std::size_t r = 0; r < mapped.distance.size(); ++r) {
        if (mapped.distance[r] <= limit)
            continue;
        ++count;
        if (stretches.empty() || stretches.back()["end"] != r)
            stretches.push_back({{"begin", r}, {"end", r + 1}});
        else
            stretches.back()["end"] = r + 1;
    }
    return {{"count", count},
            {"share", static_cast<double>(count) / static_cast<double>(mapped.distance.size())},
            {"stretches", stretches}};
}

Json positive_or_null(double value) {
    return value > 0 ? Json(value) : Json(nullptr);
}

} // namespace

Json mapping_json(const char* direction, const Arguments& arguments, const stltsa::Model& model,
                  const stltsa::Mapped& mapped, double fps) {
    const auto path = [](const std::string& name) {
        return name == "-" ? Json(nullptr) : Json(name);
    };
    return {{"format", "stltsa-mapping/1"},
            {"library", stltsa::version()},
            {"direction", direction},
            {"model",
             {{"path", path(arguments.model)},
              {"frames", model.integer(STLTSA_MODEL_FRAMES)},
              {"dimension", model.integer(STLTSA_MODEL_DIMENSION)},
              {"features", model.integer(STLTSA_MODEL_FEATURES)},
              {"support", model.real(STLTSA_MODEL_SUPPORT)}}},
            {"input", path(arguments.input)},
            {"rows", mapped.distance.size()},
            {"fps", positive_or_null(fps)},
            {"distance", distances_json(mapped)},
            {"beyond", beyond_json(mapped)},
            {"warnings", Json::array()}};
}

Json mapped_json(const stltsa::Mapped& mapped) {
    Json rows = Json::array();
    for (std::int64_t r = 0; r < mapped.values.rows; ++r)
        rows.push_back(mapped.values.row(r));
    return {{"coords", rows}, {"distance", mapped.distance}, {"nearest", mapped.nearest}};
}

} // namespace tool
