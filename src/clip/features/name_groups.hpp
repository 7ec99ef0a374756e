// SPDX-License-Identifier: BSD-3-Clause
// Names, grouped by what they begin with.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// Names are taken apart so far: names of many parts would take too long.
constexpr std::size_t most_parts = 6;

/// A name of which a beginning has been taken off.
struct PartOfName {
    std::size_t index = 0; ///< of the name
    std::size_t at = 0;    ///< where what is left begins
};

/// Names that begin alike.
struct NameGroup {
    std::string leading;   ///< with the separator; what is left of each name is behind it
    bool by_colon = false; ///< the separator
    std::vector<PartOfName> members;
};

/// Names of one beginning, by their next part.
struct NameLevel {
    std::vector<NameGroup> groups;
    std::vector<PartOfName> alone; ///< names without a separator
};

NameLevel next_level(std::span<const std::string> names, const std::vector<PartOfName>& members);

/// The group with all parts that its members share: "Anna_Smith_" of "Anna_Smith_LHEE" and
/// "Anna_Smith_RHEE".
NameGroup with_shared_parts(std::span<const std::string> names, NameGroup group);

/// Beginnings of names, by index.
class Leadings {
  public:
    void add(std::string leading, std::size_t index);
    /// The longest that a name begins with.
    std::optional<std::size_t> of(std::string_view name) const;

  private:
    std::map<std::string, std::size_t, std::less<>> known_;
    std::set<std::size_t, std::greater<>> lengths_;
};

/// What a group begins with, without the separator.
std::string_view without_separator(std::string_view leading);

/// Behind the last colon, or what else is between the steps of a path.
std::string_view without_path(std::string_view name);

/// What is left of a name.
std::string left_of(std::span<const std::string> names, const PartOfName& part);

/// The name with its last part before the others: "mouse1_nose" of "nose_mouse1". The same name if
/// it has a colon or no separator.
std::string last_part_first(std::string_view name);

} // namespace stltsa::clip
