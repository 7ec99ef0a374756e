// SPDX-License-Identifier: BSD-3-Clause
// One row for each clip of a batch.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace tool::batch {

struct Row {
    std::string name;
    std::string status;  ///< "done", or the name of the library's status
    std::string numbers; ///< the columns from frames to confidence
    std::string message; ///< the error, or why nothing repeats
    bool kept = false;   ///< from an earlier run
    bool failed = false;
};

/// The row of a clip whose result is this JSON.
Row row_of(const std::string& name, const nlohmann::json& result);

Row failed_row(const std::string& name, const std::string& status, const std::string& message);

/// As CSV with a line of names.
std::string summary_csv(const std::vector<Row>& rows);

} // namespace tool::batch
