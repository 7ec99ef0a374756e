// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/name_groups.hpp"

#include <algorithm>
#include <map>

#include "clip/features/subject_words.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr std::string_view separators = "_.-|/ ";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Where a part of a name ends and the next one begins.
struct Cut {
    std::size_t end = 0, next = 0;
    bool is_colon = false;
};

/// Behind the first part: at a colon, or else at any other separator or at a letter after a number,
/// as in "P1LHEE". None if nothing follows.
std::optional<Cut> cut_of(std::string_view text) {
    const auto goes_on = [&](std::size_t at) { return !trim(text.substr(at)).empty(); };
    if (const std::size_t colon = text.find(':'); colon != text.npos && goes_on(colon + 1)) {
        if (trim(text.substr(0, colon)).empty())
            return std::nullopt;
        return Cut{colon, colon + 1, true};
    }
    std::size_t end = 0;
    while (end < text.size() && separators.find(text[end]) == separators.npos &&
           !(end > 1 && is_letter(text[0]) && is_digit(text[end - 1]) && is_letter(text[end])))
        ++end;
    std::size_t next = end;
    while (next < text.size() && next - end < 3 && separators.find(text[next]) != separators.npos &&
           (next == end || text[next] == ' ' || text[next - 1] == ' ')) // "Anna - LHEE"
        ++next;
    return end < text.size() && goes_on(next) ? std::optional(Cut{end, next, false}) : std::nullopt;
}

} // namespace

NameLevel next_level(std::span<const std::string> names, const std::vector<PartOfName>& members) {
    NameLevel level;
    std::map<std::string_view, std::size_t> known;
    for (const PartOfName& member : members) {
        const std::string_view name = names[member.index], left = name.substr(member.at);
        const std::optional<Cut> cut = cut_of(left);
        if (!cut) {
            level.alone.push_back(member);
            continue;
        }
        const std::size_t next = member.at + cut->next;
        const auto [place, is_new] =
            known.emplace(trim(left.substr(0, cut->end)), level.groups.size());
        if (is_new)
            level.groups.push_back({std::string(name.substr(0, next)), cut->is_colon, {}});
        level.groups[place->second].members.push_back({member.index, next});
    }
    return level;
}

NameGroup with_shared_parts(std::span<const std::string> names, NameGroup group) {
    constexpr std::size_t a_body = 3; // a part that fewer points share may be one of the body
    for (std::size_t i = 0; i < most_parts && group.members.size() >= a_body; ++i) {
        NameLevel below = next_level(names, group.members);
        if (below.groups.size() != 1 || !below.alone.empty())
            break;
        group = std::move(below.groups[0]);
    }
    return group;
}

void Leadings::add(std::string leading, std::size_t index) {
    if (leading.empty())
        return;
    lengths_.insert(leading.size());
    known_.emplace(std::move(leading), index);
}

std::optional<std::size_t> Leadings::of(std::string_view name) const {
    for (const std::size_t length : lengths_)
        if (length <= name.size())
            if (const auto found = known_.find(name.substr(0, length)); found != known_.end())
                return found->second;
    return std::nullopt;
}

std::string_view without_separator(std::string_view leading) {
    std::string_view name = trim(leading);
    while (!name.empty() && (name.back() == ':' || separators.find(name.back()) != name.npos))
        name.remove_suffix(1);
    return name;
}

std::string_view without_path(std::string_view name) {
    return name.substr(name.find_last_of(":|/") + 1);
}

std::string left_of(std::span<const std::string> names, const PartOfName& part) {
    return std::string(trim(std::string_view(names[part.index]).substr(part.at)));
}

std::string last_part_first(std::string_view name) {
    std::size_t at = name.find_last_of(separators);
    if (at == name.npos || at == 0 || name.find(':') != name.npos)
        return std::string(name);
    if (const std::size_t before = name.find_last_of(separators, at - 1);
        before != name.npos && before > 0 && is_numbered_subject(name.substr(before + 1)))
        at = before; // "nose_mouse_1"
    return std::string(name.substr(at + 1)) + '_' + std::string(name.substr(0, at));
}

} // namespace stltsa::clip
