// SPDX-License-Identifier: BSD-3-Clause
// Shared by map and unmap: rows with their distances from the fitted rows.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <stltsa.hpp>

#include "arguments/arguments.hpp"

namespace tool {

struct Mapping {
    const Arguments& arguments; ///< of map or unmap
    const stltsa::Model& model;
    stltsa::Mapped rows;
    double fps = 0; ///< rows per second; 0: unknown
    std::vector<std::string> warnings;
    std::vector<std::string> notes = {}; ///< assumptions

    bool is_map() const { return arguments.command == Command::map; }
};

struct Distances {
    double median = 0;
    double p90 = 0;
    double largest = 0;
    std::int64_t beyond = 0; ///< number of rows outside the model's range
    std::vector<std::pair<std::int64_t, std::int64_t>> stretches; ///< of such rows, [begin, end)
};
Distances distances_of(const stltsa::Mapped& rows);

/// What frames usually are whose median distance is this, as "another style of the motion"; empty:
/// the motion of the model.
std::string motion_at(double median);

/// The object of schema stltsa-mapping/1.
std::string mapping_json(const Mapping& mapping);

} // namespace tool
