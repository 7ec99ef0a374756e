// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/option_flags.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "arguments/choices.hpp"
#include "arguments/number.hpp"
#include "exit_status.hpp"
#include "terminal/text.hpp"

namespace tool {
namespace {

using stltsa::OptionInfo;

/// Typed for what the library chooses.
constexpr const char* automatic = "auto";

const std::vector<OptionInfo>& table() {
    static const std::vector<OptionInfo> rows = stltsa::option_table();
    return rows;
}

const OptionInfo& describe(std::int32_t key) {
    const auto row = std::ranges::find(table(), key, &OptionInfo::key);
    if (row == table().end())
        throw Failure(Exit::failed, fmt::format("the library has no option {}", key));
    return *row;
}

/// keep_start: --keep-start
std::string flag_name(const OptionInfo& info) {
    std::string name = info.name;
    std::ranges::replace(name, '_', '-');
    return "--" + name;
}

bool is_switch(const OptionInfo& info) {
    return info.type == STLTSA_TYPE_INT && info.choices == nullptr && info.minimum == 0 &&
           info.maximum == 1;
}

bool counts_frames(std::int32_t key) {
    return key == STLTSA_OPT_NEIGHBORS || key == STLTSA_OPT_WINDOW || key == STLTSA_OPT_EXCLUSION;
}

std::string choice_names(const OptionInfo& info) {
    std::string names = info.automatic != 0 ? automatic : "";
    for (const auto& [name, value] : choices_in(info.choices))
        names += (names.empty() ? "" : "|") + name;
    return names;
}

std::string value_name(const OptionInfo& info) {
    if (info.choices != nullptr)
        return choice_names(info);
    if (info.type == STLTSA_TYPE_TEXT)
        return fmt::format("{}|{}", automatic, info.key == STLTSA_OPT_SUBJECT ? "NAME" : "FILE");
    const std::string number = counts_frames(info.key) ? "N|SECONDSs" : "N";
    return info.automatic != 0 ? fmt::format("{}|{}", automatic, number) : number;
}

/// The default.
std::string default_text(const OptionInfo& info) {
    if (info.automatic != 0)
        return " Default: auto.";
    if (info.choices != nullptr) {
        for (const auto& [name, value] : choices_in(info.choices))
            if (static_cast<double>(value) == info.standard)
                return fmt::format(" Default: {}.", name);
    } else if (is_switch(info)) {
        return info.standard != 0 ? " Default: on." : "";
    } else if (info.standard != 0) {
        return fmt::format(" Default: {}.", info.standard);
    }
    return "";
}

[[noreturn]] void refuse(const OptionInfo& info, const std::string& typed,
                         std::string_view wanted) {
    throw Failure(Exit::usage,
                  fmt::format("{} is given '{}': it takes {}", flag_name(info), typed, wanted));
}

/// Seconds of "1.2s"; nothing where there is no such suffix or none is allowed.
std::optional<double> seconds_in(const OptionInfo& info, const std::string& typed) {
    if (!counts_frames(info.key) || !typed.ends_with('s'))
        return std::nullopt;
    const auto seconds = number_in<double>(std::string_view(typed).substr(0, typed.size() - 1));
    if (!seconds || !(*seconds > 0) || !std::isfinite(*seconds))
        refuse(info, typed, "frames (36) or seconds (1.2s)");
    return seconds;
}

void set_whole(stltsa::Options& options, const OptionInfo& info, const std::string& typed) {
    if (info.choices != nullptr) {
        for (const auto& [name, value] : choices_in(info.choices))
            if (name == typed)
                return static_cast<void>(options.set(info.key, value));
        refuse(info, typed, choice_names(info));
    }
    const auto value = number_in<std::int64_t>(typed);
    if (!value)
        refuse(info, typed,
               counts_frames(info.key) ? "frames (36) or seconds (1.2s)" : "a whole number");
    options.set(info.key, *value);
}

void set_real(stltsa::Options& options, const OptionInfo& info, const std::string& typed) {
    const auto value = number_in<double>(typed);
    if (!value)
        refuse(info, typed, "a number");
    options.set(info.key, *value);
}

} // namespace

CLI::Option* add_option_flag(CLI::App& app, const OptionInfo& info, const std::string& text,
                             std::map<std::int32_t, std::string>& typed) {
    const std::int32_t key = info.key;
    const std::string flag = flag_name(info);
    const std::string help = text + default_text(info);
    if (is_switch(info)) {
        const std::string both = flag + ",!--no-" + flag.substr(2);
        const auto set = [&typed, key](std::int64_t count) { typed[key] = count > 0 ? "1" : "0"; };
        return app.add_flag_function(both, set, help)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    }
    const auto set = [&typed, key](const std::string& value) { typed[key] = value; };
    return app.add_option_function<std::string>(flag, set, help)->type_name(value_name(info));
}

void set_options(stltsa::Options& options, const std::map<std::int32_t, std::string>& typed) {
    for (const auto& [key, value] : typed) {
        const OptionInfo& info = describe(key);
        if (info.automatic != 0 && value == automatic)
            options.unset(key);
        else if (info.type == STLTSA_TYPE_TEXT)
            options.set(key, value);
        else if (info.type == STLTSA_TYPE_REAL)
            set_real(options, info, value);
        else if (!seconds_in(info, value))
            set_whole(options, info, value);
    }
}

void set_lengths(stltsa::Options& options, const std::map<std::int32_t, std::string>& typed,
                 double rate) {
    for (const auto& [key, value] : typed) {
        const OptionInfo& info = describe(key);
        const auto seconds = seconds_in(info, value);
        if (!seconds)
            continue;
        if (!(rate > 0))
            throw Failure(Exit::usage,
                          fmt::format("{} is given in seconds, and the clip's frame rate is "
                                      "unknown: give it with --fps, or the length in frames",
                                      flag_name(info)));
        // At least 1, the least number of frames.
        const double frames = std::max(1.0, std::round(*seconds * rate));
        const double most = std::min(frames, info.maximum);
        options.set(key, static_cast<std::int64_t>(most));
    }
}

std::string flag_of(std::int32_t key) {
    return flag_name(describe(key));
}

namespace {

/// Replaces words where they end, and where `fits` likes what is before them.
template <class Fits>
void replace_words(std::string& text, const std::string& words, const std::string& by, Fits fits) {
    const auto is_name = [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); };
    for (std::size_t at = 0; (at = text.find(words, at)) != text.npos; ++at) {
        const std::size_t end = at + words.size();
        if ((end == text.size() || !is_name(text[end])) && fits(text.substr(0, at)))
            text.replace(at, words.size(), by);
    }
}

/// "set --a"
bool ends_with_flag(const std::string& text) {
    return text.compare(text.find_last_of(' ') + 1, 2, "--") == 0; // npos + 1 is 0
}

} // namespace

std::string with_flags(std::string text) {
    const auto always = [](const std::string&) { return true; };
    for (const char* words : {"the option ", "option "})
        for (const OptionInfo& info : table())
            replace_words(text, std::string(words) + info.name, flag_name(info), always);
    for (const OptionInfo& info : table())
        replace_words(text, std::string(" or ") + info.name, " or " + flag_name(info),
                      ends_with_flag);
    return text;
}

} // namespace tool
