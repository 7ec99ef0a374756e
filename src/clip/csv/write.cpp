// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "base/formula.hpp"
#include "clip/clip.hpp"
#include "clip/csv/cells.hpp"
#include "clip/features/point_names.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Appends a name so that it is read back as one cell with any separator and is not a formula.
void append_name(std::string& text, std::string_view name) {
    const auto plain = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '.' || c == '_' || c == '-';
    };
    if (!name.empty() && !is_formula(name) && std::all_of(name.begin(), name.end(), plain)) {
        text += name;
        return;
    }
    text += '"';
    for (const char c : text_cell(name)) {
        text += c == '\n' || c == '\r' ? ' ' : c; // a quoted cell ends with its line
        text += c == '"' ? "\"" : "";
    }
    text += '"';
}

/// A line of numbers would not be read as a header.
bool can_be_header(const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(),
                       [](const std::string& name) { return !is_gap(name) && !parse_cell(name); });
}

/// The name of a column. Points without names get names, so that they are read back as points.
std::string column_name(const Clip& clip, std::int64_t column) {
    const std::string given =
        clip.channel_names.empty() ? "" : clip.channel_names[static_cast<std::size_t>(column)];
    const bool has_point = clip.space > 0 && given.size() > 1 && !point_name(given).empty();
    if (clip.space == 0 || has_point)
        return clip.channel_names.empty() ? format_text("{}", column + 1) : given;
    return format_text("p{}_{}", column / clip.space + 1,
                       "xyz"[static_cast<std::size_t>(column % clip.space)]);
}

/// Gives every column a name if any column has one.
std::string header(const Clip& clip, bool with_time) {
    std::vector<std::string> names;
    if (with_time)
        names.emplace_back("time");
    for (std::int64_t c = 0; c < clip.values.cols(); ++c)
        names.push_back(column_name(clip, c));
    std::string text;
    if (!can_be_header(names))
        return text;
    for (const std::string& name : names) {
        text += text.empty() ? "" : ",";
        append_name(text, name);
    }
    // The reader drops an empty last cell, so another one follows it.
    return text + (trim(names.back()).empty() ? ",\n" : "\n");
}

} // namespace

std::string format_csv(const Clip& clip) {
    // The reader gets the frame rate from the steps of time, so a single row cannot give it.
    const bool with_time = clip.fps > 0 && clip.frames() > 1;
    std::string text = header(clip, with_time);
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        if (with_time) {
            append_number(text, static_cast<double>(i) / clip.fps);
            text += ',';
        }
        for (std::int64_t c = 0; c < clip.values.cols(); ++c) {
            text += c == 0 ? "" : ",";
            if (!std::isnan(clip.values(i, c))) // an empty cell is a missing value
                append_number(text, clip.values(i, c));
        }
        text += '\n';
        checkpoint(work_of_number * clip.values.cols());
    }
    return text;
}

} // namespace stltsa::clip
