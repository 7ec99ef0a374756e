// SPDX-License-Identifier: BSD-3-Clause
// Files that the Python package reads: C3D, TRC, MOT, STO, AMASS. The command that pip installs
// names its interpreter in STLTSA_PYTHON.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <stltsa.hpp>

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

/// The clip of these bytes; `typed`: the options as typed.
stltsa::Clip parse_foreign(const ForeignClip& foreign, const std::string& path,
                           const std::map<std::int32_t, std::string>& typed);

/// Whether the file's name is that of such a format, and whether the package can be asked.
bool is_foreign(const std::string& path);
bool has_python();

} // namespace tool
