// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/progress.hpp"

namespace stltsa::clip {

/// Reads the whole file; throws Status::io with the system's reason if it cannot be read.
/// `progress` is called after each chunk, and ten times a second during a wait for the writer of a
/// pipe.
std::string read_file(const std::string& path, const Progress& progress);

} // namespace stltsa::clip
