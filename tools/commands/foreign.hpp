// SPDX-License-Identifier: BSD-3-Clause
// Files that the Python package reads: C3D, TRC, MOT, STO, AMASS. The command that pip installs
// names its interpreter in STLTSA_PYTHON.
#pragma once

#include <optional>
#include <string>

#include <stltsa.hpp>

namespace tool {

/// The arrays of a clip, as `python -m stltsa.readers` writes them, if the file has such a format
/// and STLTSA_PYTHON is set; a stretch may follow the path. `fps`: the rate that the user gave;
/// empty: none. Throws Failure with the message of the Python package if it cannot read the file.
std::optional<std::string> read_by_python(const std::string& path, const std::string& fps);

/// The clip of these arrays, or the stretch of it that the path names.
stltsa::Clip clip_of(const std::string& arrays, const std::string& path,
                     const stltsa::Options& options);

/// The table of labels of a C3D file, or of a stretch of it, for labels_in(). `fps`: the rate that
/// the user gave; empty: none. Throws Failure if the package cannot read the file.
std::string events_by_python(const std::string& path, const std::string& fps);

/// Whether the file's name is that of such a format, and whether the package can be asked.
bool is_foreign(const std::string& path);
bool has_python();

} // namespace tool
