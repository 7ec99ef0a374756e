// SPDX-License-Identifier: BSD-3-Clause
// Files that the Python package reads: C3D, TRC, MOT, STO, AMASS. The command that pip installs
// names its interpreter in STLTSA_PYTHON.
#pragma once

#include <optional>
#include <string>

namespace tool {

/// A clip in a format that the library reads.
struct ForeignClip {
    double fps = 0;
    std::string bytes;
};

/// Lets the Python package read the file, if it does and STLTSA_PYTHON is set; a stretch may follow
/// the path. `fps`: the rate that the user gave; empty: none. Throws Failure with the sentence of
/// the Python package if it cannot.
std::optional<ForeignClip> read_by_python(const std::string& path, const std::string& fps);

} // namespace tool
