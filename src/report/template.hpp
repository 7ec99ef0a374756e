// SPDX-License-Identifier: BSD-3-Clause
// The pages without their data, which embed.py makes from the folder page.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stltsa::report {

/// In pieces, because compilers need not accept longer literals.
struct Template {
    std::span<const std::string_view> before, after; ///< the data

    std::size_t size() const;
};

Template report_template();
Template comparison_template();

/// The page. `json`: its data, in which no text ends the element of HTML.
std::string filled(Template page, const std::string& json);

} // namespace stltsa::report
