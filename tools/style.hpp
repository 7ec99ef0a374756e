// SPDX-License-Identifier: BSD-3-Clause
// Colors on terminals, plain text everywhere else. Nothing from outside reaches a terminal but
// through here.
#pragma once

#include <string>
#include <string_view>

namespace tool {

/// Whether a stream gets colors: a terminal that is not dumb, and the user did not say no
/// (--no-color, or NO_COLOR set; no-color.org).
bool colors_wanted(int descriptor, bool allowed);

/// Text with marks that shown() knows.
std::string bold(std::string_view text);
std::string dim(std::string_view text);

/// Marks become a terminal's codes, or nothing. Other control characters, which a file's name can
/// have, and bytes that are not UTF-8 become '?'; lines stay lines.
std::string shown(std::string_view text, bool colors);

enum class Tone { error, warning };

/// "stltsa: text" on stderr.
void print_message(std::string_view text, Tone tone, bool colors_allowed);

} // namespace tool
