// SPDX-License-Identifier: BSD-3-Clause
// The names of kinds of units and segments, and the letters of labels.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stltsa {

struct KindName {
    std::int64_t kind;
    const char* name;
};
/// Values of motion::UnitKind and STLTSA_UNIT_*.
inline constexpr KindName unit_kinds[] = {{1, "preparing"}, {2, "initial"}, {3, "cyclic"},
                                          {4, "final"},     {5, "wind-up"}, {6, "action"},
                                          {8, "hold"}};
/// Values of motion::SegmentKind and STLTSA_SEGMENT_*.
inline constexpr KindName segment_kinds[] = {
    {1, "cyclic"}, {2, "repetitions"}, {3, "action"}, {4, "rest"}};

/// "unknown" for another kind.
constexpr const char* name_of(std::span<const KindName> kinds, std::int64_t kind) {
    for (const KindName& row : kinds)
        if (row.kind == kind)
            return row.name;
    return "unknown";
}

constexpr std::optional<std::int64_t> kind_of(std::span<const KindName> kinds,
                                              std::string_view name) {
    for (const KindName& row : kinds)
        if (row.name == name)
            return row.kind;
    return std::nullopt;
}

/// A, B, ... Z, AA, AB, ... for 0, 1, ...; empty below 0.
inline std::string letters_of(std::int64_t label) {
    std::string letters;
    for (std::int64_t rest = label; rest >= 0; rest = rest / 26 - 1)
        letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
    return letters;
}

/// The reverse; empty for other texts, and for more than four letters.
inline std::optional<std::int64_t> label_of(std::string_view letters) {
    if (letters.empty() || letters.size() > 4)
        return std::nullopt;
    std::int64_t label = 0;
    for (const char c : letters) {
        if (c < 'A' || c > 'Z')
            return std::nullopt;
        label = 26 * label + (c - 'A' + 1);
    }
    return label - 1;
}

} // namespace stltsa
