// SPDX-License-Identifier: BSD-3-Clause
// One row for each clip of a batch.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace tool::batch {

struct Row {
    std::string path;
    std::string status;  ///< "done", or the name of the library's status
    std::string error;   ///< empty: done
    std::string numbers; ///< the columns from frames to confidence
    std::string reason;  ///< why nothing repeats
    bool kept = false;   ///< from an earlier run

    bool failed() const { return !error.empty(); }
};

/// The row of a clip whose result is this JSON.
Row row_of(const std::string& path, const nlohmann::json& result);

Row failed_row(const std::string& path, const std::string& status, const std::string& error);

/// As CSV with a line of names.
std::string summary_csv(const std::vector<Row>& rows);

} // namespace tool::batch
