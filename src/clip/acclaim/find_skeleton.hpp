// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace stltsa::clip {

/// Finds the ASF file of an AMC file in the same folder.
std::string find_skeleton(const std::string& amc_path);

} // namespace stltsa::clip
