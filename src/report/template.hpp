// SPDX-License-Identifier: BSD-3-Clause
// The pages without their data, which embed.py makes from the folder page.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stltsa::report {

/// What comes before and after the data, in pieces: compilers limit the length of literals.
struct Template {
    std::span<const std::string_view> before, after;

    std::size_t size() const;
};

Template report_template();
Template comparison_template();

/// The page with its data as JSON. No name in them can end the script element.
std::string filled(Template page, const std::string& json);

} // namespace stltsa::report
