// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string_view>

namespace stltsa {

/// Takes bytes in pieces, so that long files are never in memory as a whole.
using Sink = std::function<void(std::string_view piece)>;

} // namespace stltsa
