// SPDX-License-Identifier: BSD-3-Clause
#include "clip/formats.hpp"

#include <algorithm>
#include <filesystem>

#include "clip/c3d/file.hpp"
#include "clip/opensim/header.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {

// Each is defined in the source of its format.
Clip parse_bvh(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_amc(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_csv(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_npy(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_c3d(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_trc(std::string_view bytes, const std::string& name, const ReadOptions& options);
Clip parse_mot(std::string_view bytes, const std::string& name, const ReadOptions& options);
std::string format_bvh(const Clip& clip);
std::string format_amc(const Clip& clip);
std::string format_csv(const Clip& clip);
std::string format_npy(const Clip& clip);
std::string format_glb(const Clip& clip);

namespace {

/// First word of the first line that is not a comment.
std::string_view first_word(std::string_view bytes) {
    if (is_utf16(bytes))
        return {};
    TextCursor in(bytes, "");
    std::string_view line = in.line();
    while (!line.empty() && trim(line)[0] == '#')
        line = in.line();
    return next_word(line);
}

bool is_bvh(std::string_view bytes) {
    return equals_ignoring_case(first_word(bytes), "HIERARCHY");
}

bool is_amc(std::string_view bytes) {
    return first_word(bytes).starts_with(':');
}

bool is_npy(std::string_view bytes) {
    return bytes.starts_with("\x93NUMPY");
}

bool is_trc(std::string_view bytes) {
    return starts_with_ignoring_case(first_word(bytes), "PathFileType");
}

/// One of the first lines ends the header.
bool is_mot(std::string_view bytes) {
    constexpr int most_lines = 64;
    if (is_utf16(bytes))
        return false;
    TextCursor in(bytes, "");
    for (int i = 0; i < most_lines; ++i)
        if (ends_header(in.line()))
            return true;
    return false;
}

} // namespace

std::span<const FormatRow> formats() {
    static constexpr FormatRow rows[] = {
        {Format::bvh, "bvh", {".bvh"}, true, false, is_bvh, parse_bvh, format_bvh},
        {Format::amc, "amc", {".amc"}, true, true, is_amc, parse_amc, format_amc},
        {Format::csv, "csv", {".csv", ".tsv"}, true, false, nullptr, parse_csv, format_csv},
        {Format::npy, "npy", {".npy"}, false, false, is_npy, parse_npy, format_npy},
        {Format::matrix, "matrix", {}, false, false, nullptr, nullptr, nullptr},
        {Format::points, "points", {}, false, false, nullptr, nullptr, nullptr},
        {Format::skeleton, "skeleton", {}, false, false, nullptr, nullptr, nullptr},
        {Format::glb, "glb", {".glb"}, false, false, nullptr, nullptr, format_glb},
        {Format::c3d, "c3d", {".c3d"}, false, false, c3d::is_c3d, parse_c3d, nullptr},
        {Format::trc, "trc", {".trc"}, true, false, is_trc, parse_trc, nullptr},
        {Format::mot, "mot", {".mot", ".sto"}, true, false, is_mot, parse_mot, nullptr},
    };
    return rows;
}

const FormatRow* find_format(Format format) {
    for (const FormatRow& row : formats())
        if (row.format == format)
            return &row;
    return nullptr;
}

const FormatRow* find_format(const std::string& path) {
    const std::string suffix = to_lower(std::filesystem::path(path).extension().string());
    for (const FormatRow& row : formats())
        if (!suffix.empty() && std::ranges::find(row.suffixes, suffix) != row.suffixes.end())
            return &row;
    return nullptr;
}

} // namespace stltsa::clip
