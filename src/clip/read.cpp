// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "clip/acclaim/find_skeleton.hpp"
#include "clip/csv/bids.hpp"
#include "clip/features/subjects.hpp"
#include "clip/files/read_file.hpp"
#include "clip/formats.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Text formats do not contain NUL; a file that does has another format, or is damaged.
void check_is_text(std::string_view bytes, const FormatRow& row, const std::string& name) {
    if (row.is_text && !is_utf16(bytes) && bytes.find('\0') != bytes.npos)
        fail(Status::format, "{}: not a text file, unlike {} files", name, row.name);
}

/// Files that only the Python package reads, with what reads them there.
struct Other {
    std::string_view suffix, how;
};
constexpr Other others[] = {{".npz", "stltsa.read_clip"}, {".nc", "stltsa.decompose of a dataset"}};

const Other* find_other(const std::string& path) {
    const std::string suffix = to_lower(std::filesystem::path(path).extension().string());
    const Other* const found = std::ranges::find(others, suffix, &Other::suffix);
    return found == std::end(others) ? nullptr : found;
}

/// Parses a file of no known format, such as a spreadsheet or a video, as CSV, and says so if it
/// fails.
Clip parse_unknown(std::string_view bytes, const std::string& path, const ReadOptions& options) {
    try {
        return parse(bytes, Format::csv, path, options);
    } catch (const Error& error) {
        if (error.status() != Status::format)
            throw;
        fail(Status::format,
             "{} (read as CSV because neither its name nor its first bytes match a known format: "
             "{})",
             error.what(), suffixes_read());
    }
}

const FormatRow& readable(Format format) {
    const FormatRow* row = find_format(format);
    if (row == nullptr || row->read == nullptr)
        fail(Status::argument, "format is {}; expected 0 or the STLTSA_FORMAT_* of a file format",
             static_cast<int>(format));
    return *row;
}

} // namespace

std::string suffixes_read() {
    std::string text;
    for (const FormatRow& row : formats())
        for (const std::string_view suffix : row.suffixes)
            if (row.read != nullptr && !suffix.empty())
                text += (text.empty() ? "" : ", ") + std::string(suffix);
    return text;
}

bool is_clip_name(const std::string& path) {
    const FormatRow* const row = find_format(path);
    return row != nullptr ? row->read != nullptr : find_other(path) != nullptr;
}

Format sniff(std::string_view bytes) {
    for (const FormatRow& row : formats())
        if (row.sniff != nullptr && row.sniff(bytes))
            return row.format;
    return Format::csv;
}

Clip parse(std::string_view bytes, Format format, const std::string& name,
           const ReadOptions& options) {
    const std::string shown = name.empty() ? "clip" : name;
    const FormatRow& row = readable(format);
    check_is_text(bytes, row, shown);
    if (row.needs_skeleton && options.skeleton.empty())
        fail(Status::argument,
             "{}: an AMC clip needs its skeleton: set option skeleton to the path of the ASF file",
             shown);
    Clip clip = row.read(bytes, shown, options);
    clip.path = name;
    clip.format = format;
    if (!row.needs_skeleton && !options.skeleton.empty())
        clip.notes.push_back("option skeleton is not used: it applies to AMC clips only");
    if (!options.subject.empty() && clip.subject.empty())
        one_subject({}, options.subject, shown);
    if (options.fps) {
        if (clip.fps > 0 && clip.fps != *options.fps)
            clip.notes.push_back(format_text("option fps: {:.6g} frames a second instead of the "
                                             "file's {:.6g}",
                                             *options.fps, clip.fps));
        clip.fps = *options.fps;
        clip.frame_time = 0;
    }
    return clip;
}

Clip read(const std::string& given, const ReadOptions& options) {
    const std::string path = motion_file(given);
    const std::string bytes = read_file(path);
    const FormatRow* known = find_format(path);
    if (known != nullptr && known->read == nullptr)
        fail(Status::format, "{}: {} files are only written: open the clip that it was made from",
             path, known->suffixes[0]);
    if (const Other* const other = find_other(path); other != nullptr)
        fail(Status::format,
             "{}: only the Python package reads {} files ({}); or export the points as CSV", path,
             other->suffix, other->how);
    const Format format = known != nullptr ? known->format : sniff(bytes);
    if (equals_ignoring_case(std::filesystem::path(path).extension().string(), ".asf"))
        fail(Status::format, "{}: an ASF file is a skeleton without motion: open an AMC file",
             path);
    ReadOptions with_others = options;
    const bool search = readable(format).needs_skeleton && options.skeleton.empty();
    if (search)
        with_others.skeleton = find_skeleton(path);
    if (is_bids_motion(path)) {
        with_others.channels = find_beside(path, "_channels.tsv");
        with_others.sidecar = find_beside(path, "_motion.json");
    }
    Clip clip = known == nullptr && format == Format::csv ? parse_unknown(bytes, path, with_others)
                                                          : parse(bytes, format, path, with_others);
    if (search)
        clip.notes.push_back("skeleton found beside the clip: " + with_others.skeleton);
    return clip;
}

Clip read_at_own_rate(const std::string& path, const ReadOptions& options) {
    ReadOptions without = options;
    without.fps.reset();
    try {
        Clip clip = read(path, without);
        if (clip.fps > 0 || !options.fps)
            return clip;
    } catch (const Error& error) {
        if (!options.fps || error.status() != Status::format)
            throw;
    }
    return read(path, options);
}

} // namespace stltsa::clip
