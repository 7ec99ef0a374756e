// SPDX-License-Identifier: BSD-3-Clause
// What map and unmap have in common: rows with their distance from what the model knows.
#pragma once

#include <cstdint>
#include <vector>

#include "arguments.hpp"
#include "grid.hpp"
#include "library.hpp"

namespace tool {

/// Room for what the library maps, and what it says of each row.
struct Mapped {
    Grid values;
    Grid distance;
    std::vector<std::int64_t> nearest;

    Mapped(std::int64_t rows, std::int64_t cols)
        : values(rows, cols), distance(rows, 1), nearest(static_cast<std::size_t>(rows)) {}

    stltsa_out values_out() { return out_of(values); }
    stltsa_out distance_out() { return out_of(distance); }
};

std::int64_t whole_of(const stltsa_model* model, std::int32_t key);

/// The object of schema stltsa-mapping/1; fps: rows a second, 0: unknown.
Json mapping_json(const char* direction, const Arguments& arguments, const stltsa_model* model,
                  const Mapped& mapped, double fps);

/// Row by row: the member "curve" of that object.
Json mapped_json(const Mapped& mapped);

} // namespace tool
