// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/subject_names.hpp"

#include <algorithm>
#include <map>

#include "base/text.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/subject_groups.hpp"
#include "clip/features/subject_words.hpp"

namespace stltsa::clip {
namespace {

using Names = std::span<const std::string>;

constexpr auto fewest_names = static_cast<std::size_t>(least_points);

/// A subject with its points.
struct Owner {
    Subject subject;
    std::vector<std::size_t> points;
};
using Owners = std::vector<Owner>;

/// Points of which each name is there several times: which of them each is, if they are subjects or
/// may be. Each subject may be a block, or have its point beside those of the others.
struct Copies {
    std::vector<std::size_t> of; ///< from 0
    std::size_t count = 1;       ///< 1: there are none
    bool doubtful = false;       ///< the points may be those of a left and a right limb
};

Copies copies_of(Names names, const std::vector<std::size_t>& points) {
    std::map<std::string_view, std::size_t> seen, in_block;
    std::vector<std::size_t> blocks, turns;
    std::size_t block = 0;
    Copies copies;
    for (const std::size_t i : points) {
        const std::string_view name = names[i];
        turns.push_back(seen[name]++);
        copies.count = std::max(copies.count, turns.back() + 1);
        const auto place = in_block.find(name);
        if (place != in_block.end() && place->second == block)
            ++block;
        in_block[name] = block;
        blocks.push_back(block);
    }
    std::vector<std::string> repeated;
    for (const auto& [name, count] : seen)
        if (count > 1)
            repeated.emplace_back(name);
    const BodyNames body = body_names(repeated);
    const bool whole = 2 * body.points >= repeated.size() && body.more_than_a_limb > 0;
    if (repeated.size() < fewest_names || 2 * repeated.size() < seen.size())
        return {};
    copies.doubtful = !whole && repeated.size() < many_names;
    copies.of = block + 1 == copies.count ? blocks : turns;
    return copies;
}

/// How much of what the groups begin with is the same, up to a colon or the like.
std::size_t shared_path(const std::vector<NameGroup>& groups) {
    std::optional<std::string_view> shared;
    for (const NameGroup& group : groups) {
        const std::string_view leading = group.leading;
        if (!shared)
            shared = leading.substr(0, without_separator(leading).size());
        const auto differ = std::ranges::mismatch(*shared, leading);
        shared = shared->substr(0, static_cast<std::size_t>(differ.in1 - shared->begin()));
    }
    return shared.value_or("").find_last_of(":|/") + 1;
}

Owners owners_of(const SubjectGroups& found) {
    const std::size_t path = shared_path(found.groups);
    Owners owners;
    for (const NameGroup& group : found.groups) {
        const std::string_view leading = group.leading;
        const std::string_view own =
            without_separator(leading.substr(std::min(path, leading.size())));
        Owner& owner = owners.emplace_back();
        owner.subject = {std::string(own.empty() ? without_separator(leading) : own),
                         found.by_end ? std::string() : group.leading};
        for (const PartOfName& member : group.members)
            owner.points.push_back(member.index);
    }
    return owners;
}

/// Those of stated subjects: the points that begin as is stated, and all others if there is one
/// subject of which none do. Empty: none do of any.
Owners stated_owners(Names names, std::span<const Subject> stated) {
    Owners owners;
    Leadings leadings;
    for (const Subject& subject : stated) {
        leadings.add(subject.leading, owners.size());
        owners.push_back({subject, {}});
    }
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const auto owner = leadings.of(names[i]))
            owners[*owner].points.push_back(i);
        else if (!is_unlabeled(names[i]) && names[i].find(':') == std::string::npos)
            left.push_back(i);
    const auto has_none = [](const Owner& owner) { return owner.points.empty(); };
    const std::int64_t without = std::ranges::count_if(owners, has_none);
    if (without == std::ssize(owners))
        return {};
    if (without == 1)
        std::ranges::find_if(owners, has_none)->points = std::move(left);
    std::erase_if(owners, has_none);
    return owners;
}

/// Each subject of which all names are there several times is several.
Owners apart(Names names, Owners owners, bool& doubtful) {
    Owners all;
    for (Owner& owner : owners) {
        const Copies copies = copies_of(names, owner.points);
        if (copies.count == 1 || (copies.doubtful && owners.size() > 1)) {
            all.push_back(std::move(owner));
            continue;
        }
        doubtful = doubtful || copies.doubtful;
        Owners several(copies.count);
        for (std::size_t c = 0; c < copies.count; ++c)
            several[c].subject.name = format_text("{}{}{}", owner.subject.name,
                                                  owner.subject.name.empty() ? "" : " ", c + 1);
        for (std::size_t p = 0; p < owner.points.size(); ++p)
            several[copies.of[p]].points.push_back(owner.points[p]);
        all.insert(all.end(), several.begin(), several.end());
    }
    return all;
}

std::vector<std::size_t> indices(Names names) {
    std::vector<std::size_t> all(names.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    return all;
}

} // namespace

SubjectsOfNames subjects_of_names(Names names, std::span<const Subject> stated, Named kind) {
    SubjectsOfNames found;
    if (names.empty())
        return found;
    Owners owners = stated.size() > 1 ? stated_owners(names, stated) : Owners();
    if (owners.empty()) {
        const SubjectGroups groups = subject_groups(names, kind);
        owners = owners_of(groups);
        found.doubtful = groups.doubtful;
    }
    if (owners.empty()) // one, or several without names
        owners.push_back({{stated.size() == 1 ? stated[0].name : "", ""}, indices(names)});
    if (kind == Named::points)
        owners = apart(names, std::move(owners), found.doubtful);
    if (owners.size() == 1 && owners[0].subject.name.empty())
        owners.clear();
    std::ranges::sort(owners, {}, [](const Owner& owner) { return owner.points[0]; });
    found.of.resize(names.size());
    for (std::size_t s = 0; s < owners.size(); ++s) {
        for (const std::size_t i : owners[s].points)
            found.of[i] = s;
        if (owners[s].subject.name.empty())
            owners[s].subject.name = "unnamed";
        found.subjects.push_back(std::move(owners[s].subject));
    }
    return found;
}

} // namespace stltsa::clip
