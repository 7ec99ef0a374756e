// SPDX-License-Identifier: BSD-3-Clause
#include "capi/options/flags.hpp"

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "base/text.hpp"
#include "capi/options/reader.hpp"
#include "capi/options/table.hpp"

namespace stltsa::capi {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + '\'';
}

/// "positions" of "positions=1 rotations6d=2" for 1.
std::string choice_of(const char* choices, double value) {
    std::istringstream all(choices);
    const std::string end = format_text("={}", value);
    for (std::string choice; all >> choice;)
        if (choice.ends_with(end))
            return choice.substr(0, choice.size() - end.size());
    return format_text("{}", value);
}

} // namespace

std::string flag_name(const stltsa_option_info& row) {
    std::string name = row.name;
    std::ranges::replace(name, '_', '-');
    return name;
}

std::string typed_value(const stltsa_options& options, const stltsa_option_info& row) {
    if (row.type == STLTSA_TYPE_TEXT)
        return options.texts.at(row.key);
    const double value = options.numbers.at(row.key);
    return row.choices == nullptr ? format_text("{}", value) : choice_of(row.choices, value);
}

std::string flags_of(const stltsa_options* options, int32_t calls,
                     std::initializer_list<int32_t> without) {
    std::string flags;
    for (const stltsa_option_info& row : options_table()) {
        if ((row.calls & calls) == 0 || row.key == STLTSA_OPT_THREADS ||
            std::ranges::count(without, row.key) > 0 || !is_set(options, row.key))
            continue;
        const std::string name = flag_name(row), value = typed_value(*options, row);
        const bool is_switch = row.type == STLTSA_TYPE_INT && row.choices == nullptr &&
                               row.minimum == 0 && row.maximum == 1;
        flags += is_switch ? format_text(" --{}{}", value == "0" ? "no-" : "", name)
                           : format_text(" --{} {}", name,
                                         row.type == STLTSA_TYPE_TEXT ? quoted(value) : value);
    }
    return flags;
}

} // namespace stltsa::capi
