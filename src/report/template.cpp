// SPDX-License-Identifier: BSD-3-Clause
#include "report/template.hpp"

namespace stltsa::report {
namespace {

/// JSON inside a `script` element of HTML, which "</script" or "<!--" in a name would break.
std::string in_html(const std::string& json) {
    std::string text;
    text.reserve(json.size());
    for (const char c : json)
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text;
}

} // namespace

std::size_t Template::size() const {
    std::size_t sum = 0;
    for (const auto& pieces : {before, after})
        for (const std::string_view piece : pieces)
            sum += piece.size();
    return sum;
}

std::string filled(Template page, const std::string& json) {
    std::string text;
    for (const std::string_view piece : page.before)
        text += piece;
    text += in_html(json);
    for (const std::string_view piece : page.after)
        text += piece;
    return text;
}

} // namespace stltsa::report
