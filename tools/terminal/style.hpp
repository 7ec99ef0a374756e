// SPDX-License-Identifier: BSD-3-Clause
// Colors on terminals, plain text elsewhere. All text from outside passes through here before it
// reaches a terminal.
#pragma once

#include <string>
#include <string_view>

namespace tool {

/// Whether a stream gets colors: it obeys codes, and the user did not refuse them (--no-color, or
/// NO_COLOR set; no-color.org).
bool colors_wanted(int descriptor, bool allowed);

/// Whether a stream is a terminal that obeys codes, not a dumb one.
bool obeys_codes(int descriptor);

/// Text with marks for shown().
std::string bold(std::string_view text);
std::string dim(std::string_view text);

/// Replaces marks by terminal codes, or removes them. Other control characters, which a file name
/// may contain, and bytes that are not UTF-8 become '?'; line ends and tabs stay.
std::string shown(std::string_view text, bool colors);

enum class Tone { error, warning };

/// "stltsa: text" on stderr.
void print_message(std::string_view text, Tone tone, bool colors_allowed);

} // namespace tool
