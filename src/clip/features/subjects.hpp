// SPDX-License-Identifier: BSD-3-Clause
// Several people or animals in one file: one is chosen, and they are never merged.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/name_groups.hpp"
#include "clip/features/subject_names.hpp"

namespace stltsa::clip {

/// The one of the subjects, named once each, that is wanted; if none is wanted, the only one.
/// Throws Status::argument with `file` before a text that lists them.
std::string one_subject(const std::vector<std::string>& subjects, const std::string& wanted,
                        const std::string& file);

/// Points of one subject.
struct SubjectPoints {
    std::string subject;             ///< empty: the names of the points say nothing about subjects
    std::vector<std::size_t> points; ///< indices of its points
    std::string note;                ///< which subject it is, and what is left out; may be empty
    Leadings leadings;               ///< of all subjects, if one of several was taken
    std::size_t taken = 0;           ///< its index there

    /// Whether a name begins as those of another subject.
    bool is_of_other(std::string_view name) const;
};

/// Takes the points of the one subject that is wanted from the names of all points, without their
/// axes, or of columns. If no subject is wanted, and there is only one, all points are taken.
/// `stated`: subjects that the file names apart from these. Throws as one_subject.
SubjectPoints points_of_subject(const std::vector<std::string>& names, const std::string& wanted,
                                const std::string& file, const std::vector<Subject>& stated = {},
                                Named kind = Named::points);

/// The same for a clip, which then has the name of the subject and the note. If the rows of a
/// subject have been chosen before, all points are taken.
SubjectPoints take_subject(Clip& clip, const std::vector<std::string>& names,
                           const std::string& wanted, const std::string& file,
                           const std::vector<Subject>& stated = {}, Named kind = Named::points);

/// What a note says about the subject that was taken; empty if it is the only one.
std::string subject_note(const std::vector<std::string>& subjects, const std::string& taken);

} // namespace stltsa::clip
