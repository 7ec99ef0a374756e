// SPDX-License-Identifier: BSD-3-Clause
// What map and unmap have in common: rows with their distance from what the model knows.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <stltsa.hpp>

#include "arguments.hpp"

namespace tool {

struct Mapping {
    const Arguments& arguments; ///< of map, else of unmap
    const stltsa::Model& model;
    stltsa::Mapped rows;
    double fps = 0; ///< rows a second; 0: unknown
    std::vector<std::string> warnings;

    bool is_map() const { return arguments.command == Command::map; }
};

struct Distances {
    double median = 0;
    double p90 = 0;
    double largest = 0;
    std::int64_t beyond = 0; ///< rows that are unlike what the model knows
    std::vector<std::pair<std::int64_t, std::int64_t>> stretches; ///< of those rows, [begin, end)
};
Distances distances_of(const stltsa::Mapped& rows);

/// The object of schema stltsa-mapping/1.
std::string mapping_json(const Mapping& mapping);

} // namespace tool
