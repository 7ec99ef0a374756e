// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace stltsa::clip {

enum class Listed { files, folders, all };

/// The sorted names of the regular files, of the folders, or of all entries in a folder; none if it
/// cannot be listed. Not hidden ones: another program may be writing one.
std::vector<std::string> names_in(const std::string& folder, Listed wanted);

} // namespace stltsa::clip
