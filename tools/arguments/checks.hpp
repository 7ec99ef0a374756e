// SPDX-License-Identifier: BSD-3-Clause
// What the parser of the command line cannot check: options that do not go together.
#pragma once

#include "arguments/arguments.hpp"

namespace tool {

/// Throws Failure with Exit::usage.
void check_arguments(const Arguments& arguments);

} // namespace tool
