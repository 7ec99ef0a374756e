// SPDX-License-Identifier: BSD-3-Clause
// Words that tell people and animals from the parts of their bodies.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stltsa::clip {

/// Whether it names one of several subjects: "mouse1", "Person 2", "subject_A".
bool is_numbered_subject(std::string_view leading);

/// Whether it stands before points that the cameras saw and nobody named: "Unlabeled", "*12".
bool is_unlabeled(std::string_view leading);

/// Whether it is "left", "R" or the like.
bool is_side_word(std::string_view leading);

/// Whether it is a part of a body, or a place on one: "pelvis", "LThigh", "front".
bool is_body_part(std::string_view leading);

/// Whether it tells versions or views of the same points apart: "filtered", "cam1".
bool is_version(std::string_view leading);

/// How many of the names, each once, are those of points of a body.
struct BodyNames {
    std::size_t points = 0; ///< by a word, as "nose", or by the side, as "LASI" beside "RASI"
    std::size_t more_than_a_limb = 0; ///< of a side, or on the midline: an ankle may be of any leg
    bool has_both_sides = false;
};
BodyNames body_names(const std::vector<std::string>& names);

} // namespace stltsa::clip
