// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/choices.hpp"

#include <sstream>

#include "base/names.hpp"

namespace tool {

Choices choices_in(const std::string& text) {
    Choices choices;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::size_t equals = word.find('=');
        choices.emplace_back(word.substr(0, equals), std::stoll(word.substr(equals + 1)));
    }
    return choices;
}

std::vector<std::string> unit_names() {
    std::vector<std::string> names;
    for (const stltsa::KindName& row : stltsa::unit_kinds)
        names.emplace_back(row.name);
    return names;
}

std::string named(const stltsa::Info& info, std::int32_t key) {
    for (const stltsa::InfoKey& row : stltsa::info_table())
        if (row.key == key)
            for (const auto& [name, value] : choices_in(row.choices))
                if (value == info.integer(key))
                    return name;
    return std::to_string(info.integer(key));
}

} // namespace tool
