// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/completions.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "exit_status.hpp"

namespace tool {
namespace {

/// What follows a flag.
enum class Value { none, file, word, number };

struct Flag {
    std::vector<std::string> names; ///< with their dashes
    std::string text;               ///< first sentence of the description
    Value value = Value::none;
    std::vector<std::string> words; ///< those that can be given
};

struct CommandFlags {
    std::string name;
    std::string text;
    std::vector<Flag> flags;
};

std::vector<std::string> split(std::string text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != std::string::npos; text.erase(0, end + 1)) {
        end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string::npos)
            break;
    }
    return parts;
}

std::string first_sentence(const std::string& text) {
    const std::size_t end = std::min({text.find('\n'), text.find(". "), text.find(';')});
    std::string sentence = text.substr(0, end);
    if (sentence.ends_with('.'))
        sentence.pop_back();
    return sentence;
}

/// A value's name lists what it can be: "auto|N", "temporal|spatial".
Flag flag_of(const CLI::Option& option) {
    Flag flag;
    flag.names = dashed_names(option);
    flag.text = first_sentence(option.get_description());
    if (option.get_items_expected_max() == 0)
        return flag;
    flag.value = Value::number;
    for (const std::string& part : split(option.get_type_name(), '|'))
        if (part == "FILE")
            flag.value = Value::file;
        else if (std::ranges::none_of(part, [](char c) { return c >= 'A' && c <= 'Z'; }))
            flag.words.push_back(part);
    if (flag.value == Value::number && !flag.words.empty())
        flag.value = Value::word;
    return flag;
}

std::vector<CommandFlags> commands_of(const CLI::App& app) {
    std::vector<CommandFlags> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        CommandFlags entry{command->get_name(), first_sentence(command->get_description()), {}};
        for (const CLI::Option* option :
             command->get_options([](const CLI::Option* each) { return each->nonpositional(); }))
            entry.flags.push_back(flag_of(*option));
        commands.push_back(std::move(entry));
    }
    return commands;
}

std::string names_of(const std::vector<CommandFlags>& commands) {
    std::string names;
    for (const CommandFlags& command : commands)
        names += command.name + ' ';
    return names + "help";
}

// ---- bash ----

/// The patterns of flags in a case, with what completes their values.
std::string bash_values(const std::vector<CommandFlags>& commands) {
    std::map<std::string, std::vector<std::string>> flags; // by what completes the value
    for (const CommandFlags& command : commands)
        for (const Flag& flag : command.flags) {
            if (flag.value == Value::none)
                continue;
            const std::string action = flag.value == Value::file
                                           ? "-f"
                                           : fmt::format("-W '{}'", fmt::join(flag.words, " "));
            for (const std::string& name : flag.names)
                if (std::ranges::find(flags[action], name) == flags[action].end())
                    flags[action].push_back(name);
        }
    std::string text;
    for (const auto& [action, names] : flags)
        text += fmt::format(
            "        {})\n            mapfile -t COMPREPLY < <(compgen {} -- \"$word\")\n"
            "            return ;;\n",
            fmt::join(names, "|"), action);
    return text;
}

std::string bash(const std::vector<CommandFlags>& commands) {
    std::string flags;
    for (const CommandFlags& command : commands) {
        std::string names;
        for (const Flag& flag : command.flags)
            names += fmt::format(" {}", fmt::join(flag.names, " "));
        flags += fmt::format("        {}) words='{}' ;;\n", command.name, names.substr(1));
    }
    return fmt::format(R"(# Completions of stltsa for bash.
_stltsa() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} words
    if [ "$COMP_CWORD" -eq 1 ] || {{ [ "$COMP_CWORD" -eq 2 ] && [ "$before" = help ]; }}; then
        mapfile -t COMPREPLY < <(compgen -W '{}' -- "$word")
        return
    fi
    case $before in
{}    esac
    case $word in
    -*)
        case ${{COMP_WORDS[1]}} in
{}        esac
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word") ;;
    *)
        mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    esac
}}
complete -o filenames -F _stltsa stltsa
)",
                       names_of(commands), bash_values(commands), flags);
}

// ---- zsh and fish ----

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

/// For single quotes of zsh.
std::string zsh_quoted(std::string text) {
    for (const char* c : {"[", "]", ":"})
        text = replaced(std::move(text), c, std::string("\\") + c);
    return replaced(std::move(text), "'", "'\\''");
}

std::string zsh(const std::vector<CommandFlags>& commands) {
    std::string list;
    std::string cases;
    for (const CommandFlags& command : commands) {
        list += fmt::format("        '{}:{}'\n", command.name, zsh_quoted(command.text));
        cases += fmt::format("    {})\n        _arguments \\\n", command.name);
        for (const Flag& flag : command.flags) {
            const std::string value = flag.value == Value::none   ? ""
                                      : flag.value == Value::file ? ":file:_files"
                                      : flag.words.empty()
                                          ? ":number:"
                                          : fmt::format(":value:({})", fmt::join(flag.words, " "));
            for (const std::string& name : flag.names)
                cases +=
                    fmt::format("            '{}[{}]{}' \\\n", name, zsh_quoted(flag.text), value);
        }
        cases += "            '*:file:_files' ;;\n";
    }
    return fmt::format(R"(#compdef stltsa
# Completions of stltsa for zsh.
_stltsa() {{
    local -a commands
    commands=(
{}        'help:Explains a command'
    )
    if (( CURRENT == 2 )) || [[ $words[2] == help ]]; then
        _describe command commands
        return
    fi
    local command=$words[2]
    shift words
    (( CURRENT-- ))
    case $command in
{}    esac
}}
_stltsa "$@"
)",
                       list, cases);
}

std::string fish_quoted(const std::string& text) {
    return replaced(replaced(text, "\\", "\\\\"), "'", "\\'");
}

std::string fish(const std::vector<CommandFlags>& commands) {
    std::string text = "# Completions of stltsa for fish.\n";
    for (const CommandFlags& command : commands)
        text += fmt::format("complete -c stltsa -n __fish_use_subcommand -f -a {} -d '{}'\n",
                            command.name, fish_quoted(command.text));
    text += "complete -c stltsa -n __fish_use_subcommand -f -a help -d 'Explains a command'\n";
    text += fmt::format("complete -c stltsa -n '__fish_seen_subcommand_from help' -f -a '{}'\n",
                        names_of(commands));
    for (const CommandFlags& command : commands)
        for (const Flag& flag : command.flags) {
            text +=
                fmt::format("complete -c stltsa -n '__fish_seen_subcommand_from {}'", command.name);
            for (const std::string& name : flag.names)
                text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
            if (flag.value == Value::file)
                text += " -r -F";
            else if (!flag.words.empty())
                text += fmt::format(" -x -a '{}'", fmt::join(flag.words, " "));
            else if (flag.value == Value::number)
                text += " -x";
            text += fmt::format(" -d '{}'\n", fish_quoted(flag.text));
        }
    return text;
}

} // namespace

std::vector<std::string> dashed_names(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames())
        names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        names.push_back("--" + name);
    return names;
}

std::string completions(const CLI::App& app, const std::string& shell) {
    const std::vector<CommandFlags> commands = commands_of(app);
    if (shell == "bash")
        return bash(commands);
    if (shell == "zsh")
        return zsh(commands);
    if (shell == "fish")
        return fish(commands);
    throw Failure(Exit::usage, "completions: give one of bash, zsh, fish");
}

} // namespace tool
