// SPDX-License-Identifier: BSD-3-Clause
#include "clip/write.hpp"

#include <filesystem>
#include <functional>
#include <system_error>

#include "base/progress.hpp"
#include "base/sink.hpp"
#include "clip/files/read_file.hpp"
#include "clip/files/replace_file.hpp"
#include "clip/files/write_file.hpp"
#include "clip/formats.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

using Content = std::function<void(const Sink&)>;

/// Writes an AMC file and its skeleton beside it, under the same name: both or neither. Another
/// skeleton of that name belongs to somebody's clips, and stays.
void write_with_skeleton(const std::string& amc, const Content& content, const std::string& asf) {
    if (!regular_or_new(amc))
        return write_file(amc, content); // a pipe or device has no place beside it
    // Follows a dangling link, so that removing the file leaves the link.
    const std::string path = followed(fs::path(amc).replace_extension(".asf").string());
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        write_file(path, asf);
        try {
            return write_file(amc, content);
        } catch (...) {
            fs::remove(path, ignored);
            throw;
        }
    }
    if (!fs::is_regular_file(path, ignored)) // reading a pipe would wait
        fail(Status::io,
             "{}: is not a regular file, but the skeleton of {} would be written there: choose "
             "another name for the clip",
             path, amc);
    if (read_file(path) != asf)
        fail(Status::io,
             "{}: exists and is another skeleton, but that of {} would be written there: choose "
             "another name for the clip",
             path, amc);
    write_file(amc, content);
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
            report_progress(Stage::write, 0);
            const std::string bytes = row.write(clip);
            const Content content = [&](const Sink& sink) {
                constexpr std::size_t piece = 1 << 20;
                for (std::size_t at = 0; at < bytes.size(); at += piece) {
                    report_progress(Stage::write,
                                    static_cast<double>(at) / static_cast<double>(bytes.size()));
                    sink(std::string_view(bytes).substr(at, piece));
                }
            };
            return row.needs_skeleton ? write_with_skeleton(path, content, clip.skeleton->asf)
                                      : write_file(path, content);
        }
        known += format_text("{}{}", known.empty() ? "" : ", ", row.suffixes[0]);
    }
    fail(Status::argument, "{}: unknown suffix; use one of {}", path, known);
}

} // namespace stltsa::clip
