// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "clip/formats.hpp"
#include "clip/read_file.hpp"
#include "clip/text_cursor.hpp"

namespace stltsa::clip {
namespace {

std::optional<Format> format_of_suffix(const std::string& path) {
    struct Suffix {
        std::string_view text;
        Format format;
    };
    constexpr Suffix suffixes[] = {{".bvh", Format::bvh},
                                   {".amc", Format::amc},
                                   {".csv", Format::csv},
                                   {".tsv", Format::csv},
                                   {".npy", Format::npy}};
    const std::string suffix = std::filesystem::path(path).extension().string();
    for (const Suffix& known : suffixes)
        if (equals_ignoring_case(suffix, known.text))
            return known.format;
    return std::nullopt;
}

bool is_utf16(std::string_view bytes) {
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

/// First word of the first line that is no comment.
std::string_view first_word(std::string_view bytes) {
    if (is_utf16(bytes))
        return {};
    TextCursor in(bytes, "");
    std::string_view line = in.line();
    while (!line.empty() && trim(line)[0] == '#')
        line = in.line();
    return next_word(line);
}

/// Text formats hold no NUL; a file that does is another format, or damaged.
void check_is_text(std::string_view bytes, const std::string& name) {
    if (!is_utf16(bytes) && bytes.find('\0') != bytes.npos)
        fail(Status::format, "{}: not a text file; BVH, AMC, CSV and NPY are read", name);
}

void set_amc_rate(Clip& clip, const ReadOptions& options) {
    if (clip.fps > 0 || options.fps > 0)
        return;
    clip.fps = amc_fps;
    clip.notes.push_back(format_text(
        "AMC files carry no frame rate: {} a second assumed (set option fps for another)",
        amc_fps));
}

Clip parse_format(std::string_view bytes, Format format, const std::string& name,
                  const ReadOptions& options) {
    switch (format) {
    case Format::bvh:
        return parse_bvh(bytes, name);
    case Format::amc: {
        if (options.skeleton.empty())
            fail(Status::argument,
                 "{}: an AMC clip needs its skeleton: set option skeleton to the ASF file", name);
        Clip clip = parse_amc(bytes, name, options);
        set_amc_rate(clip, options);
        return clip;
    }
    case Format::csv:
        return parse_csv(bytes, name, options);
    case Format::npy:
        return parse_npy(bytes, name);
    case Format::matrix:
        break;
    }
    fail(Status::argument, "format {} cannot be parsed", static_cast<int>(format));
}

} // namespace

Format sniff(std::string_view bytes) {
    if (bytes.starts_with("\x93NUMPY"))
        return Format::npy;
    const std::string_view word = first_word(bytes);
    if (equals_ignoring_case(word, "HIERARCHY"))
        return Format::bvh;
    return word.starts_with(':') ? Format::amc : Format::csv;
}

Clip parse(std::string_view bytes, Format format, const std::string& name,
           const ReadOptions& options) {
    const std::string shown = name.empty() ? "clip" : name;
    if (format != Format::npy)
        check_is_text(bytes, shown);
    Clip clip = parse_format(bytes, format, shown, options);
    clip.path = name;
    clip.format = format;
    if (format != Format::amc && !options.skeleton.empty())
        clip.notes.push_back("option skeleton is not used: it belongs to AMC clips");
    if (options.fps > 0) {
        clip.fps = options.fps;
        clip.frame_time = 0;
    }
    return clip;
}

Clip read(const std::string& path, const ReadOptions& options) {
    const std::string bytes = read_file(path, options.progress);
    const auto known = format_of_suffix(path);
    const Format format = known ? *known : sniff(bytes);
    if (equals_ignoring_case(std::filesystem::path(path).extension().string(), ".asf"))
        fail(Status::format, "{}: an ASF file is a skeleton without motion: open an AMC file",
             path);
    ReadOptions with_skeleton = options;
    const bool search = format == Format::amc && options.skeleton.empty();
    if (search)
        with_skeleton.skeleton = find_skeleton(path);
    Clip clip = parse(bytes, format, path, with_skeleton);
    if (search)
        clip.notes.push_back("skeleton found beside the clip: " + with_skeleton.skeleton);
    return clip;
}

} // namespace stltsa::clip
