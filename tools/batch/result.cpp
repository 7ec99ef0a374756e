// SPDX-License-Identifier: BSD-3-Clause
#include "batch/result.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include "exit_status.hpp"

namespace tool::batch {
namespace {

namespace fs = std::filesystem;

/// No text within the JSON has it: quotes in texts follow a backslash.
constexpr std::string_view member_begin = ",\"batch\":", member_end = "}\n";

std::string text_of(const std::string& place) {
    std::ifstream file(place, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The source that the text names; empty if its end is damaged.
std::string source_in(std::string_view origin) {
    if (!origin.ends_with(member_end))
        return "";
    origin.remove_suffix(member_end.size());
    const auto read = nlohmann::json::parse(origin, nullptr, false);
    const auto source = read.is_object() ? read.find("source") : read.end();
    return source != read.end() && source->is_string() ? source->get<std::string>() : "";
}

} // namespace

std::string source_of(const std::string& file, const std::string& out) {
    const fs::path path = fs::absolute(file);
    const fs::path folder = fs::weakly_canonical(path.parent_path());
    return (folder / path.filename()).lexically_relative(fs::canonical(out)).string();
}

std::string with_origin(const std::string& result, const Origin& origin) {
    std::string text = result.substr(0, result.size() - 1); // without the brace
    text += member_begin;
    text += origin.dump(-1, ' ', false, Origin::error_handler_t::replace);
    text.pop_back();
    const auto sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
    return fmt::format("{},\"checksum\":\"{:08x}\"}}{}", text, sum, member_end);
}

std::optional<nlohmann::json> kept_result(const std::string& place, const Origin& origin) {
    const std::string text = text_of(place);
    const std::size_t at = text.rfind(member_begin);
    if (at == text.npos)
        return std::nullopt;
    const std::string source = source_in(std::string_view(text).substr(at + member_begin.size()));
    Origin of_source = origin; // the same clip may have moved
    of_source["source"] = source;
    if (text == with_origin(text.substr(0, at) + '}', of_source))
        return nlohmann::json::parse(text);
    std::error_code none;
    const fs::path folder = fs::path(place).parent_path();
    if (!source.empty() && source != origin["source"] && fs::exists(folder / source, none))
        throw Failure(Exit::failed,
                      fmt::format("its result, {}, is that of another clip, {}: give another --out",
                                  place, (folder / source).lexically_normal().string()));
    return std::nullopt;
}

} // namespace tool::batch
