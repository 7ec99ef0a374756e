// SPDX-License-Identifier: BSD-3-Clause
#include "report/template.hpp"

namespace stltsa::report {
namespace {

/// JSON within an element `script` of HTML, which "</script" or "<!--" in a name would end.
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

std::string filled(Template page, const std::string& json) {
    std::string text(page.before);
    text += in_html(json);
    text += page.after;
    return text;
}

} // namespace stltsa::report
