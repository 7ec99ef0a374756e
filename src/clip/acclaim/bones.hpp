// SPDX-License-Identifier: BSD-3-Clause
// The contents of the sections of an ASF file.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "clip/clip.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

/// Three angles about fixed axes, in the file's unit, and the order of the axes.
struct AsfAxis {
    Vec3 angles{};
    std::array<int, 3> order{0, 1, 2};
};

struct AsfBone {
    std::string name;
    std::int64_t line = 0;
    Vec3 direction{};
    double length = 0;
    AsfAxis axis;
    std::vector<Channel> dof;
};

struct AsfLink {
    std::string parent, child;
    std::int64_t line = 0;
};

struct AsfSections {
    bool degrees = true;
    AsfBone root; ///< direction: its position; dof: its order
    std::vector<AsfBone> bones;
    std::vector<AsfLink> links;
};

AsfSections read_asf_sections(TextCursor& in);

} // namespace stltsa::clip
