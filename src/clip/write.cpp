// SPDX-License-Identifier: BSD-3-Clause
#include "clip/write.hpp"

#include <filesystem>
#include <system_error>

#include "clip/files/read_file.hpp"
#include "clip/files/replace_file.hpp"
#include "clip/files/write_file.hpp"
#include "clip/formats.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

/// Writes an AMC file and its skeleton beside it, under the same name: both or neither. Another
/// skeleton of that name belongs to somebody's clips, and stays.
void write_with_skeleton(const std::string& amc, std::string_view bytes, const std::string& asf) {
    if (!regular_or_new(amc))
        return write_file(amc, bytes); // a pipe or device has no place beside it
    const std::string path = fs::path(amc).replace_extension(".asf").string();
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        write_file(path, asf);
        try {
            return write_file(amc, bytes);
        } catch (...) {
            fs::remove(path, ignored);
            throw;
        }
    }
    if (read_file(path, {}) != asf)
        fail(Status::io,
             "{}: exists and is another skeleton, but that of {} would be written there: choose "
             "another name for the clip",
             path, amc);
    write_file(amc, bytes);
}

} // namespace

void write(const Clip& clip, const std::string& path) {
    if (path.empty())
        fail(Status::argument, "the path is empty: give the name of a file");
    const std::string suffix = fs::path(path).extension().string();
    std::string known;
    for (const FormatRow& row : formats()) {
        if (row.write == nullptr)
            continue;
        if (equals_ignoring_case(suffix, row.suffixes[0])) {
            const std::string bytes = row.write(clip);
            return row.needs_skeleton ? write_with_skeleton(path, bytes, clip.skeleton->asf)
                                      : write_file(path, bytes);
        }
        known += format_text("{}{}", known.empty() ? "" : ", ", row.suffixes[0]);
    }
    fail(Status::argument, "{}: unknown suffix; use one of {}", path, known);
}

} // namespace stltsa::clip
