// SPDX-License-Identifier: BSD-3-Clause
// What makes a comparison of cycles doubtful.
#pragma once

#include <cstdint>
#include <string>

#include "results/compared.hpp"

namespace stltsa::results {

void warn_of_few(const std::string& name, std::int64_t cycles, Comparison& result);

/// Of different motions, another alignment that is as good, and bodies of different sizes.
void warn_of_likeness(Comparison& result);

} // namespace stltsa::results
