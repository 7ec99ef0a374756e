// SPDX-License-Identifier: BSD-3-Clause
// The one rule for which person or animal a point is of, by the names of all points.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// A person or an animal.
struct Subject {
    std::string name;
    std::string leading; ///< what names of its points begin with, with the separator; may be empty
};

/// Whether names are those of points, or of columns of any quantity. Columns need more evidence:
/// sensors on one body have columns of the same names, as people have.
enum class Named { points, columns };

struct SubjectsOfNames {
    std::vector<Subject> subjects;              ///< in the order of their first names
    std::vector<std::optional<std::size_t>> of; ///< of each name, by index; none: no subject's
    bool doubtful = false;                      ///< they may as well be parts of one body
};

/// Several subjects are known by what names begin with:
/// - what the file states, as individuals or as prefixes of labels;
/// - a colon after it, as in "Anna:LHEE", behind a first part that all share ("scene:Anna:LHEE");
/// - a numbered word, as in "mouse1_nose"; here also at the end, as in "nose_mouse1";
/// - nearly the same names behind any separator, if these are names of a body: "Anna_LHEE",
///   "Ben_LHEE". Not for parts of a body and sides: "Thigh_1", "Shank_1", "L_HEE", "R_HEE".
/// Points whose names do not begin so are a subject of their own if they have the same names as
/// those of another, and so are points if each name is there more than once.
SubjectsOfNames subjects_of_names(std::span<const std::string> names,
                                  std::span<const Subject> stated, Named kind);

} // namespace stltsa::clip
