// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace stltsa::clip {

/// The ASF file that belongs to an AMC file, looked for in the same folder.
std::string find_skeleton(const std::string& amc_path);

} // namespace stltsa::clip
