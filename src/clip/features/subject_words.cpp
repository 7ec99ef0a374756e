// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/subject_words.hpp"

#include <algorithm>
#include <span>

#include "base/side_name.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view numbered[] = {
    "track",   "individual", "ind",    "indiv",  "subject", "subj",     "sub",   "animal",
    "person",  "people",     "human",  "player", "actor",   "skeleton", "man",   "participant",
    "patient", "performer",  "dancer", "child",  "woman",   "infant",   "baby",  "mouse",
    "mice",    "rat",        "fish",   "fly",    "bird",    "cow",      "pig",   "zebrafish",
    "horse",   "dog",        "cat",    "monkey", "macaque", "marmoset", "sheep", "bee",
    "mother",  "father",     "user",   "agent",  "swimmer", "runner"};
constexpr std::string_view unlabeled[] = {"unlabeled", "unlabelled", "unidentified", "unknown",
                                          "unnamed",   "uname",      "undefined",    "unassigned"};
constexpr std::string_view versions[] = {
    "raw",  "filtered", "filt",  "smooth",   "smoothed",  "interpolated", "predicted",
    "pred", "gt",       "truth", "ref",      "reference", "model",        "virtual",
    "calc", "static",   "cam",   "camera",   "view",      "mean",         "std",
    "sd",   "median",   "min",   "max",      "global",    "local",        "world",
    "pos",  "position", "orig",  "original", "old",       "new",          "pose"};
constexpr std::string_view places[] = {
    "left",      "right", "front", "rear", "hind",   "fore",   "upper",  "lower",    "top",
    "bottom",    "bot",   "up",    "low",  "side",   "inner",  "outer",  "medial",   "lateral",
    "med",       "lat",   "ant",   "post", "prox",   "dist",   "distal", "proximal", "anterior",
    "posterior", "sup",   "inf",   "mid",  "middle", "center", "centre", "com",      "origin",
    "mcp",       "pip",   "dip",   "cmc",  "tip"};
constexpr std::string_view midline[] = {
    "head",   "skull",   "face",    "nose",   "snout", "mouth",    "chin",  "jaw",  "forehead",
    "neck",   "sternum", "chest",   "thorax", "torso", "trunk",    "spine", "back", "sacrum",
    "pelvis", "waist",   "abdomen", "lumbar", "tail",  "tailbase", "beak"};
constexpr std::string_view whole[] = {"body", "center", "centre", "centroid", "root"};
constexpr std::string_view limbs[] = {
    "eye",     "ear",   "shoulder", "clavicle", "scapula", "arm",   "forearm", "upperarm",
    "humerus", "ulna",  "radius",   "elbow",    "wrist",   "hand",  "finger",  "thumb",
    "palm",    "hip",   "thigh",    "femur",    "leg",     "upleg", "knee",    "shank",
    "shin",    "tibia", "calf",     "ankle",    "foot",    "heel",  "toe",     "paw",
    "hoof",    "wing",  "fin",      "limb"};

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// In lower case. A word begins after a character that is no letter, and at a capital after a small
/// letter.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!is_letter(text[i]))
            continue;
        const bool goes_on =
            i > 0 && is_letter(text[i - 1]) && !(text[i] < 'a' && text[i - 1] >= 'a');
        if (!goes_on)
            words.emplace_back();
        words.back() += to_lower(text.substr(i, 1));
    }
    return words;
}

bool is_any(std::string_view word, Words words) {
    return std::ranges::find(words, word) != words.end();
}

/// "thigh", "thighs", "lthigh".
bool is_part(std::string_view word, Words parts) {
    if (is_any(word, parts))
        return true;
    if (word.size() > 3 && word.back() == 's')
        return is_part(word.substr(0, word.size() - 1), parts);
    return word.size() > 3 && (word[0] == 'l' || word[0] == 'r') && is_any(word.substr(1), parts);
}

bool has_part(const std::vector<std::string>& words, Words parts) {
    return std::ranges::any_of(words,
                               [&](const std::string& word) { return is_part(word, parts); });
}

bool is_place(const std::string& word) {
    return word == "l" || word == "r" || is_any(word, places);
}

/// Whether a name with a side says of what it is: "LHEE", unlike "left", "LF" and "left_front".
bool says_of_what(std::string_view name, const std::vector<std::string>& words) {
    constexpr std::ptrdiff_t least_letters = 4;
    return std::ranges::count_if(name, is_letter) >= least_letters &&
           !std::ranges::all_of(words, is_place);
}

} // namespace

bool is_numbered_subject(std::string_view leading) {
    const std::string text = to_lower(trim(leading));
    const auto end = std::ranges::find_if_not(text, is_letter);
    const auto number =
        std::find_if(end, text.end(), [](char c) { return is_letter(c) || is_digit(c); });
    const std::string_view word(text.begin(), end), after(number, text.end());
    if (!after.empty())
        return is_any(word, numbered) &&
               (std::ranges::all_of(after, is_digit) || (after.size() == 1 && is_letter(after[0])));
    return end == text.end() && text.size() > 1 && leading.back() < 'a' && // "mouseA"
           leading[leading.size() - 2] >= 'a' && is_any(word.substr(0, word.size() - 1), numbered);
}

bool is_unlabeled(std::string_view leading) {
    const std::vector<std::string> words = words_of(leading);
    return leading.starts_with('*') || (!words.empty() && is_any(words[0], unlabeled));
}

bool is_side_word(std::string_view leading) {
    constexpr std::string_view sides[] = {"l", "r", "left", "right"};
    return is_any(to_lower(leading), sides);
}

bool is_body_part(std::string_view leading) {
    const std::vector<std::string> words = words_of(leading);
    return !words.empty() && (has_part(words, midline) || has_part(words, limbs) ||
                              std::ranges::all_of(words, [](const std::string& word) {
                                  return is_any(word, places); // people may be L and M
                              }));
}

bool is_version(std::string_view leading) {
    const std::vector<std::string> words = words_of(leading);
    return !words.empty() && is_any(words[0], versions);
}

BodyNames body_names(const std::vector<std::string>& names) {
    BodyNames found;
    bool left = false, right = false;
    const std::vector<Sided> sides = sides_of(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::vector<std::string> words = words_of(names[i]);
        const bool sided = sides[i].side != Side::neither && says_of_what(names[i], words);
        left = left || (sided && sides[i].side == Side::left);
        right = right || (sided && sides[i].side == Side::right);
        const bool on_midline = sided || has_part(words, midline) || has_part(words, whole);
        found.more_than_a_limb += on_midline ? 1 : 0;
        found.points += on_midline || has_part(words, limbs) ? 1 : 0;
    }
    found.has_both_sides = left && right;
    return found;
}

} // namespace stltsa::clip
