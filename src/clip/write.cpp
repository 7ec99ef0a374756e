// SPDX-License-Identifier: BSD-3-Clause
#include "clip/write.hpp"

#include <filesystem>

#include "clip/text_cursor.hpp"

namespace stltsa::clip {
namespace {

using Formatter = std::string (*)(const Clip& clip);

Formatter formatter_of(const std::string& path) {
    if (path.empty())
        fail(Status::argument, "the path is empty: give the name of a file");
    struct Suffix {
        std::string_view text;
        Formatter formatter;
    };
    constexpr Suffix suffixes[] = {
        {".bvh", format_bvh}, {".amc", format_amc}, {".csv", format_csv}, {".npy", format_npy}};
    const std::string suffix = std::filesystem::path(path).extension().string();
    for (const Suffix& known : suffixes)
        if (equals_ignoring_case(suffix, known.text))
            return known.formatter;
    fail(Status::argument, "{}: the suffix tells the format: .bvh, .amc, .csv or .npy is needed",
         path);
}

} // namespace

void write(const Clip& clip, const std::string& path) {
    write_file(path, formatter_of(path)(clip));
}

} // namespace stltsa::clip
