// SPDX-License-Identifier: BSD-3-Clause
#include "clip/features/subject_groups.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "base/side_name.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/subject_words.hpp"

namespace stltsa::clip {
namespace {

using Names = std::span<const std::string>;
using Groups = std::vector<NameGroup>;

constexpr auto fewest_names = static_cast<std::size_t>(least_points);

/// The names of one group, with which those of others are compared.
class Reference {
  public:
    /// `sure`: the group is one subject of several.
    Reference(std::vector<std::string> names, bool sure) : sure_(sure) {
        for (std::string& name : names)
            names_.insert(std::move(name));
    }

    bool is_sure() const { return sure_; }
    /// Of all that were like it.
    const std::unordered_set<std::string>& shared() const { return shared_; }

    /// Whether these are nearly the same names, or, if both are `sure`, those of fewer points.
    bool is_like(std::vector<std::string> names, bool sure) {
        std::unordered_set<std::string> common;
        for (std::string& name : names)
            if (names_.contains(name))
                common.insert(std::move(name));
        const auto [fewer, more] = std::minmax({names_.size(), names.size()});
        const bool like = sure_ && sure
                              ? !common.empty() && 2 * common.size() >= fewer
                              : common.size() >= fewest_names && 2 * common.size() >= more;
        if (like)
            shared_.merge(common);
        return like;
    }

  private:
    bool sure_;
    std::unordered_set<std::string> names_, shared_;
};

/// Finds groups of names that are those of one subject each, by what they begin with.
class GroupFinder {
  public:
    GroupFinder(Names names, Named kind) : names_(names), kind_(kind) {}

    Groups find() {
        std::vector<PartOfName> all;
        for (std::size_t i = 0; i < names_.size(); ++i)
            all.push_back({i, 0});
        return subjects_in(all, {}, 0);
    }

    /// Groups that have the same names, and may be subjects or not.
    Groups& doubtful() { return doubtful_; }

  private:
    enum class Role { subject, possible, part };

    Groups subjects_in(const std::vector<PartOfName>& members, const std::string& path,
                       std::size_t depth) {
        if (members.size() < 2 || depth == most_parts)
            return {};
        const NameLevel level = next_level(names_, members);
        Groups groups = level.groups;
        for (const PartOfName& member : level.alone)
            if (const std::string& name = names_[member.index]; // "mouse1" is its only point
                depth == 0 && is_numbered_subject(name))
                groups.push_back({name, false, {{member.index, name.size()}}});
        Groups found = subjects_among(groups, members, path, depth == 0);
        if (found.size() < 2) {
            for (NameGroup& group : groups)
                if (!group.by_colon)
                    group = with_shared_parts(names_, std::move(group));
            if (Groups more = subjects_among(groups, members, path, depth == 0); more.size() > 1)
                found = std::move(more);
        }
        Groups below;
        Leadings divided;
        for (const NameGroup& group : level.groups)
            if (const Groups within = subjects_in(group.members, group.leading, depth + 1);
                within.size() > 1) {
                below.insert(below.end(), within.begin(), within.end());
                divided.add(group.leading, 0);
            }
        std::erase_if(
            found, [&](const NameGroup& group) { return divided.of(group.leading).has_value(); });
        found.insert(found.end(), below.begin(), below.end());
        return found;
    }

    std::vector<std::string> left_of_all(const std::vector<PartOfName>& parts) const {
        std::vector<std::string> left;
        for (const PartOfName& part : parts)
            left.push_back(left_of(names_, part));
        return left;
    }

    bool is_sure(const NameGroup& group, Role role) const {
        return role == Role::subject || (group.by_colon && kind_ == Named::points);
    }

    std::vector<Role> roles_of(const Groups& groups, bool is_first) const {
        std::vector<std::string> leadings;
        for (const NameGroup& group : groups)
            leadings.emplace_back(without_separator(group.leading));
        const std::vector<Sided> sides = sides_of(leadings);
        const auto role_of = [&](std::size_t g) {
            const std::string_view last = without_path(leadings[g]);
            if (is_numbered_subject(last))
                return Role::subject;
            // What is of one side does not have two.
            const bool is_side =
                sides[g].partner != g &&
                (is_side_word(last) || !body_names(left_of_all(groups[g].members)).has_both_sides);
            if (is_side || is_unlabeled(last) || is_body_part(last) || is_other_quantity(last))
                return Role::part;
            if (groups[g].by_colon && is_first && kind_ == Named::points)
                return Role::subject;
            return groups[g].by_colon || kind_ == Named::points ? Role::possible : Role::part;
        };
        std::vector<Role> roles;
        for (std::size_t g = 0; g < groups.size(); ++g)
            roles.push_back(role_of(g));
        return roles;
    }

    /// Subjects among groups of names that begin with `path`, and are all of `members`.
    Groups subjects_among(const Groups& groups, const std::vector<PartOfName>& members,
                          const std::string& path, bool is_first) {
        const std::vector<Role> roles = roles_of(groups, is_first);
        std::optional<std::size_t> first;
        const auto rank = [&](std::size_t g) {
            return std::pair(roles[g] == Role::subject, groups[g].members.size());
        };
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (roles[g] != Role::part && (!first || rank(g) > rank(*first)))
                first = g;
        if (!first)
            return {};
        Reference reference(left_of_all(groups[*first].members),
                            is_sure(groups[*first], roles[*first]));
        Groups sure, others; // the others only if all of them may be subjects
        bool has_parts = false;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            const bool like = g == *first || reference.is_like(left_of_all(groups[g].members),
                                                               is_sure(groups[g], roles[g]));
            if (roles[g] == Role::subject)
                sure.push_back(groups[g]);
            else if (like && roles[g] == Role::possible)
                others.push_back(groups[g]);
            has_parts = has_parts || (like && roles[g] == Role::part);
        }
        if (auto left = left_by(sure, others, members);
            kind_ == Named::points && reference.is_like(left_of_all(left), true))
            others.push_back({path, false, std::move(left)});
        if (sure.size() + others.size() < 2)
            return is_first && !sure.empty() && sure[0].by_colon ? sure : Groups();
        if (!has_parts && are_subjects(others, reference))
            sure.insert(sure.end(), others.begin(), others.end());
        return sure.size() > 1 || (is_first && !sure.empty() && sure[0].by_colon) ? sure : Groups();
    }

    /// The names that are of no group, and may be of a subject.
    std::vector<PartOfName> left_by(const Groups& sure, const Groups& others,
                                    const std::vector<PartOfName>& members) const {
        std::unordered_set<std::size_t> taken;
        for (const Groups* groups : {&sure, &others})
            for (const NameGroup& group : *groups)
                for (const PartOfName& member : group.members)
                    taken.insert(member.index);
        std::vector<PartOfName> left;
        std::ranges::copy_if(members, std::back_inserter(left), [&](const PartOfName& member) {
            return !taken.contains(member.index) && !is_unlabeled(left_of(names_, member));
        });
        return left;
    }

    /// Whether groups that share names are subjects: if not known by a colon, these are names of a
    /// body. Otherwise they may be parts of one body, or copies of it.
    bool are_subjects(const Groups& groups, const Reference& reference) {
        const std::vector<std::string> shared(reference.shared().begin(), reference.shared().end());
        const BodyNames body = body_names(shared);
        const bool of_body =
            reference.is_sure() || (2 * body.points >= shared.size() &&
                                    (kind_ == Named::columns || body.more_than_a_limb > 0));
        const bool versions = std::ranges::any_of(groups, [](const NameGroup& group) {
            return is_version(without_path(without_separator(group.leading)));
        });
        if (of_body && !versions)
            return true;
        if ((of_body || shared.size() >= many_names) && kind_ == Named::points && doubtful_.empty())
            doubtful_ = groups;
        return false;
    }

    Names names_;
    Named kind_;
    Groups doubtful_;
};

/// Of names that end alike, as "nose_mouse1" and "tail_mouse1". What is not a numbered word may be
/// the number of a marker on a part of the body.
SubjectGroups groups_by_end(Names names, Named kind) {
    std::vector<std::string> turned;
    for (const std::string& name : names)
        turned.push_back(last_part_first(name));
    Groups found = GroupFinder(turned, kind).find();
    const auto holds = [&](auto condition) {
        return found.size() > 1 && std::ranges::all_of(found, condition);
    };
    if (holds([](const NameGroup& group) {
            return is_numbered_subject(without_separator(group.leading));
        }))
        return {std::move(found), false, true};
    if (holds([](const NameGroup& group) { return group.members.size() >= many_names; }))
        return {std::move(found), true, true};
    return {};
}

} // namespace

SubjectGroups subject_groups(Names names, Named kind) {
    GroupFinder finder(names, kind);
    Groups found = finder.find();
    if (found.size() > 1)
        return {std::move(found), false, false};
    SubjectGroups by_end = groups_by_end(names, kind);
    if (!by_end.groups.empty() && !by_end.doubtful)
        return by_end;
    if (finder.doubtful().size() > 1)
        return {std::move(finder.doubtful()), true, false};
    return by_end.groups.empty() ? SubjectGroups{std::move(found), false, false} : by_end;
}

} // namespace stltsa::clip
