// SPDX-License-Identifier: BSD-3-Clause
// A stretch of a clip as typed after its path: walk.bvh:2.5s-9s, walk.bvh:cyclic.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/clip.hpp"
#include "clip/features/gaps.hpp"

namespace stltsa::clip {

struct Stretch {
    enum class Kind { range, cycle, segment, repetition, label, name };
    Kind kind = Kind::range;
    double begin = 0, end = -1; ///< range; end below 0: the clip's
    bool begin_in_seconds = false, end_in_seconds = false;
    std::int64_t number = 0; ///< cycle, segment, repetition: counted from 1; label: from 0
    std::string name;        ///< of a unit; "best", "representative"
};

/// "300-900", "2.5s-9s", "-9s", "300-", "cycle3", "segment2", "repetition1", "A", and the names of
/// units, "best" and "representative". Empty for other texts.
std::optional<Stretch> parse_stretch(std::string_view what);

/// The forms that there are, for messages.
inline constexpr std::string_view stretch_forms =
    "300-900, 2.5s-9s, cycle3, segment2, repetition1, A, best, representative, or a kind of unit "
    "such as cyclic or action";

/// A path and the text after its last colon. If a file has exactly this name, or none has the name
/// before the colon, it is all path.
struct StretchPath {
    std::string path;
    std::string what; ///< empty: the whole clip
};
StretchPath split_stretch(const std::string& text);

/// Frames of a range, rounded. Throws Status::argument if the clip does not have them.
Frames frames_of(const Stretch& range, const Clip& clip);

/// These frames of the clip, one stretch after another. No motion continues from one to the next.
Clip cut(const Clip& clip, const std::vector<Frames>& stretches);

} // namespace stltsa::clip
