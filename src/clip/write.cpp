// SPDX-License-Identifier: BSD-3-Clause
#include "clip/write.hpp"

#include <filesystem>

#include "clip/files/write_file.hpp"
#include "clip/formats.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

void write(const Clip& clip, const std::string& path) {
    if (path.empty())
        fail(Status::argument, "the path is empty: give the name of a file");
    const std::string suffix = std::filesystem::path(path).extension().string();
    std::string known;
    for (const FormatRow& row : formats()) {
        if (row.write == nullptr)
            continue;
        if (equals_ignoring_case(suffix, row.suffixes[0]))
            return write_file(path, row.write(clip));
        known += format_text("{}{}", known.empty() ? "" : ", ", row.suffixes[0]);
    }
    fail(Status::argument, "{}: unknown suffix; use one of {}", path, known);
}

} // namespace stltsa::clip
