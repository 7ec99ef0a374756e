// SPDX-License-Identifier: BSD-3-Clause
// What map and unmap have in common: rows with their distance from what the model knows.
#pragma once

#include <stltsa.hpp>

#include "arguments.hpp"
#include "json.hpp"

namespace tool {

/// The object of schema stltsa-mapping/1; fps: rows a second, 0: unknown.
Json mapping_json(const char* direction, const Arguments& arguments, const stltsa::Model& model,
                  const stltsa::Mapped& mapped, double fps);

/// Row by row: the member "curve" of that object.
Json mapped_json(const stltsa::Mapped& mapped);

} // namespace tool
