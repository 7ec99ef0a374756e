// SPDX-License-Identifier: BSD-3-Clause
// The table of formats: whatever depends on a format is read from it.
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
    const char* name; ///< in the JSON
    /// Of files, in lower case, with the dot, "" for none; the first is the one that is written.
    std::array<std::string_view, 2> suffixes;
    bool is_text;        ///< its files hold no NUL
    bool needs_skeleton; ///< ReadOptions::skeleton must name an ASF file
    /// Whether the bytes begin as this format does; none: they may be of it if of no other.
    bool (*sniff)(std::string_view bytes);
    /// Gets the file's bytes and the name for messages. Sets all of Clip but path and format; fps
    /// is the file's own, 0 where it has none. None: the format has no files.
    Clip (*read)(std::string_view bytes, const std::string& name, const ReadOptions& options);
    /// The bytes of a file. Numbers read back to the same bits.
    std::string (*write)(const Clip& clip);
};

/// All formats.
std::span<const FormatRow> formats();

/// The row of a value, or of a path's suffix, in any case; null: there is none.
const FormatRow* find_format(Format format);
const FormatRow* find_format(const std::string& path);

} // namespace stltsa::clip
