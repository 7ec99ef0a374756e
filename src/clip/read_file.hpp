// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/progress.hpp"

namespace stltsa::clip {

/// Reads the whole file; Status::io with the system's reason where it cannot be read. `progress` is
/// asked whether to go on after a signal.
std::string read_file(const std::string& path, const Progress& progress);

} // namespace stltsa::clip
