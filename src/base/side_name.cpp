// SPDX-License-Identifier: BSD-3-Clause
#include "base/side_name.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace stltsa {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 3> words = {
    {{"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}}};

/// Contacts of a foot with the ground, as systems and laboratories name them.
constexpr std::string_view strike_names[] = {"footstrike",  "heelstrike",  "initialcontact",
                                             "footcontact", "heelcontact", "groundcontact",
                                             "footdown",    "touchdown",   "fs",
                                             "hs",          "ic",          "fc",
                                             "hc",          "td"};
constexpr std::string_view leave_names[] = {"footoff", "toeoff", "liftoff", "footup",
                                            "fo",      "to",     "lo"};

/// Letters of the longest of them and of a side.
constexpr std::size_t longest_event = 20;

/// Longer names have no other side: the names that it might have could fill the memory.
constexpr std::size_t longest = 256;

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Whether a letter ends before a place, or begins at it: also of another European alphabet, as in
/// "réception" and "Rückfuß", which have no sides (UTF-8, U+00C0 to U+052F).
bool is_other_letter(char lead) {
    const auto byte = static_cast<unsigned char>(lead);
    return byte >= 0xC3 && byte <= 0xD4;
}

bool letter_before(std::string_view name, std::size_t at) {
    return at > 0 && (is_letter(name[at - 1]) || (at > 1 && is_other_letter(name[at - 2])));
}

bool letter_at(std::string_view name, std::size_t at) {
    return at < name.size() && (is_letter(name[at]) || is_other_letter(name[at]));
}

/// "RHS" of "eRHS": programs of BTS begin the names of events so.
std::string_view without_event_mark(std::string_view name) {
    const bool has_mark = name.size() > 1 && name[0] == 'e' && name[1] >= 'A' && name[1] <= 'Z';
    return name.substr(has_mark ? 1 : 0);
}

/// What letters in lower case say that are the name of an event, but for its side.
std::optional<FootEvent> event_beside(Side side, std::string_view letters) {
    const bool is_strike = std::ranges::find(strike_names, letters) != std::end(strike_names);
    if (!is_strike && std::ranges::find(leave_names, letters) == std::end(leave_names))
        return std::nullopt;
    return FootEvent{is_strike, side};
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

Side side_of_letter(char letter) {
    return letter == 'l' || letter == 'L' ? Side::left : Side::right;
}

/// Whether a word begins at a place: at a capital after lowercase letters, or after a non-letter.
bool begins_word(std::string_view name, std::size_t at) {
    if (!letter_before(name, at))
        return true;
    const bool after_small = name[at - 1] >= 'a' && name[at - 1] <= 'z';
    return after_small && name[at] >= 'A' && name[at] <= 'Z';
}

/// Whether the letter at a place may stand for a side: it is a word, or before one in capitals.
bool may_be_side(std::string_view name, std::size_t at, bool within_words) {
    const bool ends = !letter_at(name, at + 1);
    if (within_words)
        return begins_word(name, at) || ends;
    const bool before_word = at + 1 < name.size() && name[at + 1] >= 'A' && name[at + 1] <= 'Z';
    const std::size_t begin = name.size() - without_event_mark(name).size();
    return (at == begin || !letter_before(name, at)) && (ends || before_word);
}

/// Whether a letter that may state a side does so, judged by the characters that follow it: yes in
/// LHS, LToe and "toe_l", no in L5 (a vertebra), LAND and RUN. In words in capitals, a vowel
/// follows L or R; in abbreviations it seldom does, but for ON and OFF of muscles.
bool is_side_letter(std::string_view name, std::size_t at) {
    constexpr std::string_view not_after = "AEIOU0123456789";
    constexpr std::string_view abbreviations[] = {"ON", "OFF"};
    std::size_t end = at + 1;
    while (end < name.size() && is_letter(name[end]))
        ++end;
    for (const std::string_view word : abbreviations)
        if (name.substr(at + 1, end - at - 1) == word)
            return true;
    if (at + 1 == name.size() || not_after.find(name[at + 1]) == not_after.npos)
        return true;
    return at + 2 < name.size() && name[at + 2] >= 'a' && name[at + 2] <= 'z' &&
           is_letter(name[at + 1]);
}

} // namespace

std::optional<FootEvent> foot_event(std::string_view name) {
    std::array<char, longest_event> lower{}; // on the stack: names of sides need no memory
    std::size_t count = 0;
    for (const char c : without_event_mark(name)) {
        if (is_letter(c) && count == lower.size())
            return std::nullopt;
        if (is_letter(c))
            lower[count++] = static_cast<char>(c | 0x20);
    }
    const std::string_view letters(lower.data(), count);
    std::optional<FootEvent> event = event_beside(Side::neither, letters);
    for (const Side side : {Side::left, Side::right}) {
        const std::string_view word = words[0][static_cast<std::size_t>(side)];
        for (const std::string_view stated : {word, word.substr(0, 1)}) {
            if (!event && letters.starts_with(stated))
                event = event_beside(side, letters.substr(stated.size()));
            if (!event && letters.ends_with(stated))
                event = event_beside(side, letters.substr(0, count - stated.size()));
        }
    }
    return event;
}

Side side_of_name(std::string_view name) {
    if (const auto event = foot_event(name))
        return event->side;
    Side of_words = Side::neither, of_letters = Side::neither;
    bool words_differ = false, letters_differ = false;
    const auto add = [](Side found, Side& side, bool& differ) {
        differ = differ || (side != Side::neither && side != found);
        side = found;
    };
    for (const auto& pair : words)
        for (const std::size_t side : {0U, 1U})
            for (std::size_t at = name.find(pair[side]); at != name.npos;
                 at = name.find(pair[side], at + 1))
                if (begins_word(name, at))
                    add(static_cast<Side>(side), of_words, words_differ);
    for (std::size_t at = 0; at < name.size(); ++at)
        if (other_letter(name[at]) != 0 && may_be_side(name, at, false) && is_side_letter(name, at))
            add(side_of_letter(name[at]), of_letters, letters_differ);
    if (of_words != Side::neither)
        return words_differ ? Side::neither : of_words;
    return letters_differ ? Side::neither : of_letters;
}

std::vector<OtherSide> other_sides(std::string_view name, bool within_words) {
    std::vector<OtherSide> names;
    if (name.size() > longest)
        return names;
    for (const auto& pair : words)
        for (const std::size_t side : {0U, 1U})
            if (const std::size_t at = name.find(pair[side]); at != name.npos)
                names.push_back({replaced(name, at, pair[side].size(), pair[1 - side]),
                                 static_cast<Side>(side)});
    for (std::size_t at = 0; at < name.size(); ++at)
        if (const char other = other_letter(name[at]);
            other != 0 && may_be_side(name, at, within_words))
            names.push_back(
                {replaced(name, at, 1, std::string_view(&other, 1)), side_of_letter(name[at])});
    return names;
}

std::vector<Sided> sides_of(std::span<const std::string> names) {
    std::map<std::string_view, std::vector<std::size_t>> places;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::vector<std::size_t>& same = places[names[i]];
        order.push_back(same.size());
        same.push_back(i);
    }
    const auto sided = [&](std::size_t i) -> Sided {
        for (const OtherSide& other : other_sides(names[i], true))
            if (const auto found = places.find(other.name);
                found != places.end() && found->second.size() > order[i])
                return {other.side, found->second[order[i]]};
        return {side_of_name(names[i]), i};
    };
    std::vector<Sided> sides;
    for (std::size_t i = 0; i < names.size(); ++i)
        sides.push_back(sided(i));
    return sides;
}

} // namespace stltsa
