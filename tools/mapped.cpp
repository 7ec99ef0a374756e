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

Json distances_json(const Mapped& mapped) {
    std::vector<double> sorted = mapped.distance.values;
    std::ranges::sort(sorted);
    return {{"median", quantile(sorted, 0.5)},
            {"p90", quantile(sorted, 0.9)},
            {"largest", sorted.back()}};
}

/// Stretches of rows beyond the limit.
Json beyond_json(const Mapped& mapped) {
    Json stretches = Json::array();
    std::int64_t count = 0;
    for (std::int64_t r = 0; r < mapped.distance.rows; ++r) {
        if (mapped.distance(r, 0) <= limit)
            continue;
        ++count;
        if (stretches.empty() || stretches.back()["end"] != r)
            stretches.push_back({{"begin", r}, {"end", r + 1}});
        else
            stretches.back()["end"] = r + 1;
    }
    return {{"count", count},
            {"share", static_cast<double>(count) / static_cast<double>(mapped.distance.rows)},
            {"stretches", stretches}};
}

Json positive_or_null(double value) {
    return value > 0 ? Json(value) : Json(nullptr);
}

} // namespace

std::int64_t whole_of(const stltsa_model* model, std::int32_t key) {
    std::int64_t value = 0;
    check(stltsa_model_get_int(model, key, &value));
    return value;
}

Json mapping_json(const char* direction, const Arguments& arguments, const stltsa_model* model,
                  const Mapped& mapped, double fps) {
    double support = 0;
    check(stltsa_model_get_real(model, STLTSA_MODEL_SUPPORT, &support));
    const auto path = [](const std::string& name) {
        return name == "-" ? Json(nullptr) : Json(name);
    };
    return {{"format", "stltsa-mapping/1"},
            {"library", stltsa_version()},
            {"direction", direction},
            {"model",
             {{"path", path(arguments.model)},
              {"frames", whole_of(model, STLTSA_MODEL_FRAMES)},
              {"dimension", whole_of(model, STLTSA_MODEL_DIMENSION)},
              {"features", whole_of(model, STLTSA_MODEL_FEATURES)},
              {"support", support}}},
            {"input", path(arguments.input)},
            {"rows", mapped.values.rows},
            {"fps", positive_or_null(fps)},
            {"distance", distances_json(mapped)},
            {"beyond", beyond_json(mapped)},
            {"warnings", Json::array()}};
}

Json mapped_json(const Mapped& mapped) {
    Json rows = Json::array();
    for (std::int64_t r = 0; r < mapped.values.rows; ++r) {
        Json row = Json::array();
        for (std::int64_t c = 0; c < mapped.values.cols; ++c)
            row.push_back(mapped.values(r, c));
        rows.push_back(std::move(row));
    }
    return {{"coords", rows}, {"distance", mapped.distance.values}, {"nearest", mapped.nearest}};
}

} // namespace tool
