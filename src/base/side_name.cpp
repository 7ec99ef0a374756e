// SPDX-License-Identifier: BSD-3-Clause
#include "base/side_name.hpp"

#include <array>

namespace stltsa {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 3> words = {
    {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}}};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Whether the letter at a place may stand for a side: it is a word, or before one in capitals.
bool may_be_side(std::string_view name, std::size_t at, bool first_letter) {
    const bool begins = at == 0 || !is_letter(name[at - 1]);
    const bool ends = at + 1 == name.size() || !is_letter(name[at + 1]);
    const bool before_word = at + 1 < name.size() && name[at + 1] >= 'A' && name[at + 1] <= 'Z';
    return begins && (ends || before_word || (first_letter && at == 0));
}

std::string replaced(std::string_view name, std::size_t at, std::size_t length,
                     std::string_view by) {
    return std::string(name.substr(0, at)).append(by).append(name.substr(at + length));
}

char other_letter(char side) {
    switch (side) {
    case 'l':
        return 'r';
    case 'r':
        return 'l';
    case 'L':
        return 'R';
    case 'R':
        return 'L';
    default:
        return 0;
    }
}

} // namespace

std::vector<std::string> other_side_names(std::string_view name, bool first_letter) {
    std::vector<std::string> names;
    for (const auto& pair : words)
        for (const std::size_t side : {0U, 1U})
            if (const std::size_t at = name.find(pair[side]); at != name.npos)
                names.push_back(replaced(name, at, pair[side].size(), pair[1 - side]));
    for (std::size_t at = 0; at < name.size(); ++at)
        if (const char other = other_letter(name[at]);
            other != 0 && may_be_side(name, at, first_letter))
            names.push_back(replaced(name, at, 1, std::string_view(&other, 1)));
    return names;
}

} // namespace stltsa
