// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/name_groups.hpp"

#include <algorithm>
#include <map>

#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr std::string_view separators = "_.-|/ ";

/// Where the separator of the first part is: a colon, or else any other. npos: there is none with
/// something behind it.
std::size_t end_of_part(std::string_view text) {
    const auto goes_on = [&](std::size_t at) {
        return at != text.npos && !trim(text.substr(at + 1)).empty();
    };
    const std::size_t colon = text.find(':');
    if (goes_on(colon))
        return trim(text.substr(0, colon)).empty() ? text.npos : colon;
    std::size_t end = text.find_first_of(separators);
    if (end != text.npos && goes_on(end) && text[end] == ' ') // "Anna - LHEE"
        if (const std::size_t next = text.find_first_not_of(' ', end);
            separators.find(text[next]) != separators.npos && goes_on(next))
            end = next;
    return goes_on(end) ? end : text.npos;
}

} // namespace

NameLevel next_level(std::span<const std::string> names, const std::vector<PartOfName>& members) {
    NameLevel level;
    std::map<std::string_view, std::size_t> known;
    for (const PartOfName& member : members) {
        const std::string_view name = names[member.index], left = name.substr(member.at);
        const std::size_t end = end_of_part(left);
        if (end == left.npos) {
            level.alone.push_back(member);
            continue;
        }
        const std::size_t next = member.at + end + 1;
        const auto [place, is_new] = known.emplace(trim(left.substr(0, end)), level.groups.size());
        if (is_new)
            level.groups.push_back({std::string(name.substr(0, next)), left[end] == ':', {}});
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
        if (length < name.size())
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

std::string_view last_part(std::string_view name) {
    constexpr std::string_view digits = "0123456789";
    std::size_t at = name.find_last_of(separators);
    if (at != name.npos && at > 0 && name.find_first_not_of(digits, at + 1) == name.npos)
        at = name.find_last_of(separators, at - 1);
    return at == name.npos || at == 0 ? std::string_view() : name.substr(at + 1);
}

} // namespace stltsa::clip
