// SPDX-License-Identifier: BSD-3-Clause
// The table of formats: everything that depends on a format comes from it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "clip/clip.hpp"

namespace stltsa::clip {

/// One format. To add one, write its row in formats.cpp, its reader and writer, and its
/// STLTSA_FORMAT_* in stltsa.h.
struct FormatRow {
    Format format;    ///< the value of STLTSA_FORMAT_*
    const char* name; ///< in JSON and messages
    /// In lower case, with the dot; "" for none. Files are written with the first.
    std::array<std::string_view, 2> suffixes;
    bool is_text;        ///< files do not contain NUL
    bool needs_skeleton; ///< ReadOptions::skeleton must name an ASF file
    /// Whether the bytes begin like this format; null: used if no other format matches.
    bool (*sniff)(std::string_view bytes);
    /// Parses a file's bytes; `name` is for messages. Sets all of Clip except path and format; fps
    /// is the file's own rate, or 0. Null: the format has no files, or they are only written.
    Clip (*read)(std::string_view bytes, const std::string& name, const ReadOptions& options);
    /// The bytes of a file. Reading it gives the same bits. Null: the format has no files.
    std::string (*write)(const Clip& clip);
};

/// All formats.
std::span<const FormatRow> formats();

/// The row of a format, or of a path's suffix, ignoring case; null if there is none.
const FormatRow* find_format(Format format);
const FormatRow* find_format(const std::string& path);

} // namespace stltsa::clip
