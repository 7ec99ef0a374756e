// SPDX-License-Identifier: BSD-3-Clause
#include "capi/batch/result.hpp"

#include <filesystem>
#include <new>
#include <string_view>

#include <zlib.h>

#include "base/formula.hpp"
#include "base/json.hpp"
#include "capi/batch/clips.hpp"
#include "capi/options/flags.hpp"
#include "capi/options/table.hpp"
#include "clip/files/read_file.hpp"
#include "clip/stretch.hpp"
#include "clip/text/number.hpp"

namespace stltsa::capi::batch {
namespace {

namespace fs = std::filesystem;

/// No text within the JSON has it: quotes in texts follow a backslash.
constexpr std::string_view member_begin = ",\"batch\":";

/// The folder, without links and dots.
fs::path real(const fs::path& folder) {
    std::error_code error;
    fs::path found = fs::canonical(folder.empty() ? "." : folder, error);
    if (error == std::errc::not_enough_memory)
        throw std::bad_alloc();
    return found;
}

std::string source_of(const fs::path& file, const std::string& folder) {
    return (real(file.parent_path()) / file.filename()).lexically_relative(real(folder)).string();
}

/// Those that were set, as typed in the command; results do not depend on the number of threads.
JsonObject options_json(const stltsa_options& options) {
    JsonObject object;
    for (const stltsa_option_info& row : options_table())
        if (row.key != STLTSA_OPT_THREADS && is_set(&options, row.key))
            object.set(flag_name(row).c_str(), typed_value(options, row));
    return object;
}

std::string cell(std::string_view object, std::string_view name) {
    const std::string_view value = json_member(object, name);
    return value == "null" ? "" : std::string(value);
}

double number(std::string_view object, std::string_view name) {
    return clip::parse_number(json_member(object, name)).value_or(0);
}

/// Confidence of the longest segment that moves.
std::string confidence_of(std::string_view result) {
    std::string_view longest;
    double most = 0;
    for (const std::string_view segment : json_parts(json_member(result, "segments"))) {
        const double length = number(segment, "end_s") - number(segment, "begin_s");
        if (json_member(segment, "kind") != "\"rest\"" && length > most) {
            longest = segment;
            most = length;
        }
    }
    return cell(longest, "confidence");
}

} // namespace

Origin origin_of(const std::string& clip, const std::string& folder,
                 const stltsa_options& options) {
    const std::string file = clip::split_stretch(clip).path;
    const auto skeleton = options.texts.find(STLTSA_OPT_SKELETON);
    const Content content =
        content_of(file, skeleton == options.texts.end() ? "" : skeleton->second);
    const std::string rest = JsonObject("bytes", static_cast<std::int64_t>(content.bytes), "crc32",
                                        format_text("{:08x}", content.crc32), "options",
                                        options_json(options), "library", stltsa_version())
                                 .text();
    return {Json(source_of(file, folder)).text(), rest.substr(1, rest.size() - 2)};
}

std::string with_origin(const std::string& result, const Origin& origin) {
    const std::string text =
        format_text("{}{}{{\"source\":{},{}", std::string_view(result).substr(0, result.size() - 1),
                    member_begin, origin.source, origin.rest);
    const auto sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
    return format_text("{},\"checksum\":\"{:08x}\"}}}}\n", text, sum);
}

std::optional<std::string> kept_result(const std::string& place, const Origin& origin) {
    std::error_code none;
    if (!fs::exists(place, none))
        return std::nullopt;
    const std::string text = clip::read_file(place);
    const std::size_t at = text.rfind(member_begin);
    if (at == text.npos)
        return std::nullopt;
    Origin of_source = origin; // the same clip may have moved
    of_source.source =
        json_member(std::string_view(text).substr(at + member_begin.size()), "source");
    if (text == with_origin(text.substr(0, at) + '}', of_source))
        return text;
    const std::string source = json_string(of_source.source);
    const fs::path other = fs::path(place).parent_path() / source;
    if (!source.empty() && of_source.source != origin.source && fs::exists(other, none))
        fail(Status::io,
             "its result, {}, is that of another clip, {}: give another folder of results", place,
             other.lexically_normal().string());
    return std::nullopt;
}

std::string row_of(const std::string& path, std::string_view result) {
    const std::string_view clip = json_member(result, "clip");
    const auto count = [&](const char* of) { return json_parts(json_member(result, of)).size(); };
    return format_text("{},done,,{},{},{},{},{},{},{},{},{}\n", csv_cell(path),
                       cell(clip, "frames"), count("segments"), count("cycles"),
                       count("repetitions"), cell(result, "period_s"), cell(clip, "fps"),
                       cell(clip, "duration_s"), confidence_of(result),
                       csv_cell(json_string(json_member(result, "reason"))));
}

std::string failed_row(const std::string& path, stltsa_status status, const std::string& error) {
    return format_text("{},{},{},,,,,,,,,\n", csv_cell(path), stltsa_status_name(status),
                       csv_cell(error));
}

} // namespace stltsa::capi::batch
