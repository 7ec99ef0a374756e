// SPDX-License-Identifier: BSD-3-Clause
// Header-only, so that fmt is not a run-time dependency and exports no symbols.
#define FMT_HEADER_ONLY
#include <fmt/format.h>

#include "base/text.hpp"

namespace stltsa {

std::string format_arguments(fmt::string_view text, fmt::format_args arguments) {
    return fmt::vformat(text, arguments);
}

} // namespace stltsa
