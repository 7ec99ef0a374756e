// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string_view>

namespace stltsa {

/// Takes bytes piece by piece, so that what is long is never all in memory.
using Sink = std::function<void(std::string_view piece)>;

} // namespace stltsa
