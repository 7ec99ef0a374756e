// SPDX-License-Identifier: BSD-3-Clause
// Several people or animals in one file: one is chosen, and they are never merged.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// The subject that the name of a point begins with: "Viktor" of "Viktor:LHEE". Empty: none.
std::string_view subject_of(std::string_view point);

/// The one of the subjects, named once each, that is wanted; if none is wanted, the only one.
/// Throws Status::argument with `file` before a text that lists them.
std::string one_subject(const std::vector<std::string>& subjects, const std::string& wanted,
                        const std::string& file);

/// Points of one subject.
struct SubjectPoints {
    std::string subject;             ///< empty: the names of the points say nothing about subjects
    std::vector<std::size_t> points; ///< indices of its points
    std::string note;                ///< which subject it is, and what is left out; may be empty
};

/// Takes the points of the one subject that is wanted from the names of all points, without their
/// axes. If no subject is wanted, and there is only one, all points are taken. Throws as
/// one_subject.
SubjectPoints points_of_subject(const std::vector<std::string>& names, const std::string& wanted,
                                const std::string& file);

/// The same for a clip, which then has the name of the subject and the note. If the rows of a
/// subject have been chosen before, all points are taken.
std::vector<std::size_t> take_subject(Clip& clip, const std::vector<std::string>& names,
                                      const std::string& wanted, const std::string& file);

/// What a note says about the subject that was taken; empty if it is the only one.
std::string subject_note(const std::vector<std::string>& subjects, const std::string& taken);

} // namespace stltsa::clip
