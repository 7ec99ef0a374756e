// SPDX-License-Identifier: BSD-3-Clause
// Subjects by what the names of their points begin or end with.
#pragma once

#include "clip/features/name_groups.hpp"
#include "clip/features/subject_names.hpp"

namespace stltsa::clip {

/// So many names that several groups have are a whole set of markers, whatever they are.
constexpr std::size_t many_names = 8;

/// Groups of names, each of one subject.
struct SubjectGroups {
    std::vector<NameGroup> groups;
    bool doubtful = false; ///< they may as well be parts of one body
    bool by_end = false;   ///< the names do not begin with `leading`, but end with what it says
};

/// One group only if a colon says that there is a subject.
SubjectGroups subject_groups(std::span<const std::string> names, Named kind);

} // namespace stltsa::clip
