// SPDX-License-Identifier: BSD-3-Clause
#include "reports/json.hpp"

namespace tool {

Json json_or_null(const std::string& text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json json_or_null(double value) {
    return value > 0 ? Json(value) : Json(nullptr);
}

Json json_rows(const stltsa::Matrix& table) {
    std::vector<std::vector<double>> rows;
    for (std::int64_t r = 0; r < table.rows; ++r)
        rows.emplace_back(table.row(r).begin(), table.row(r).end());
    return rows;
}

Json json_frames(const stltsa::Info& samples) {
    std::vector<std::int64_t> frames;
    for (std::int64_t i = 0; i < samples.integer(STLTSA_INFO_ROWS); ++i)
        frames.push_back(samples.integer(STLTSA_INFO_FIRST_FRAME) +
                         i * samples.integer(STLTSA_INFO_FRAME_STEP));
    return frames;
}

std::string with_member(std::string object, const char* name, const Json& value) {
    object.pop_back(); // the brace
    return object + ',' + Json(name).text() + ':' + value.text() + '}';
}

} // namespace tool
