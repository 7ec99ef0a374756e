// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace stltsa::clip {

/// Reads the whole file; throws Status::io with the system's reason if it cannot be read.
std::string read_file(const std::string& path);

} // namespace stltsa::clip
