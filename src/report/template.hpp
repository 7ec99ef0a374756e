// SPDX-License-Identifier: BSD-3-Clause
// The page without its data, which embed.py makes from the folder page.
#pragma once

#include <string_view>

namespace stltsa::report {

std::string_view before_data();
std::string_view after_data();

} // namespace stltsa::report
