// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/bids.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>

#include "clip/clip.hpp"
#include "clip/csv/cells.hpp"
#include "clip/features/point_names.hpp"
#include "clip/files/names_in.hpp"
#include "clip/files/read_file.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view motion_ending = "_motion.tsv";

/// Whether a folder is one inside a dataset: sub-01, ses-01 or motion.
bool is_inside_dataset(const std::string& name) {
    return name.starts_with("sub-") || name.starts_with("ses-") || name == "motion";
}

/// Adds the motion files of a folder and of those below it.
void collect_motion(const std::string& folder, int depth, std::vector<std::string>& found) {
    for (const std::string& name : names_in(folder, Listed::files))
        if (is_bids_motion(name))
            found.push_back(folder + '/' + name);
    if (depth > 0)
        for (const std::string& name : names_in(folder, Listed::folders))
            if (is_inside_dataset(name))
                collect_motion(folder + '/' + name, depth - 1, found);
}

/// "sub-01", "task-walk", ... of a name.
std::set<std::string> entities_of(std::string_view name) {
    std::set<std::string> entities;
    while (!name.empty()) {
        const std::size_t end = std::min(name.find('_'), name.size());
        if (name.substr(0, end).find('-') != name.npos)
            entities.emplace(name.substr(0, end));
        name.remove_prefix(std::min(end + 1, name.size()));
    }
    return entities;
}

/// The file of the folder that applies and has the most entities; empty: none.
std::string most_specific(const std::string& folder, const std::set<std::string>& own,
                          std::string_view ending) {
    std::string best;
    std::size_t most = 0;
    for (const std::string& name : names_in(folder, Listed::files)) {
        const std::set<std::string> entities = entities_of(name);
        const bool applies = ('_' + name).ends_with(ending) && std::ranges::includes(own, entities);
        if (applies && (best.empty() || entities.size() > most)) {
            best = name;
            most = entities.size();
        }
    }
    return best;
}

/// The columns of a table of channels, by their places in its header; npos: absent.
class ChannelTable {
  public:
    ChannelTable(TextCursor& in, const std::vector<std::string_view>& header) : in_(in) {
        for (std::size_t i = 0; i < titles.size(); ++i) {
            const auto found = std::ranges::find_if(header, [&](std::string_view cell) {
                return equals_ignoring_case(cell, titles[i]);
            });
            if (found == header.end() && titles[i] != "units")
                in.fail(Status::format,
                        "a table of channels needs the columns name, component, "
                        "type and tracked_point, but there is no {}",
                        titles[i]);
            places_[i] = static_cast<std::size_t>(found - header.begin());
        }
    }

    /// The name of the column that the row describes.
    std::string name_of(const std::vector<std::string_view>& row) const {
        const auto cell = [&](std::size_t i) {
            const std::string_view text = places_[i] < row.size() ? row[places_[i]] : "";
            return std::string(is_gap(text) ? "" : text);
        };
        const std::string type = to_lower(cell(2)), point = cell(3).empty() ? cell(0) : cell(3);
        if (type == "latency")
            return "time (s)";
        const std::string axis = cell(1).empty() ? "" : '_' + cell(1);
        const std::string unit = cell(4).empty() ? "" : " (" + cell(4) + ')';
        const std::string name =
            type == "pos" ? point + axis + unit : point + '_' + type + axis + unit;
        in_.check_name(name);
        return name;
    }

  private:
    static constexpr std::array<std::string_view, 5> titles = {"name", "component", "type",
                                                               "tracked_point", "units"};
    TextCursor& in_;
    std::array<std::size_t, 5> places_{};
};

/// The number of a member of the outermost object of a JSON text.
std::optional<double> json_number(std::string_view text, std::string_view member) {
    int depth = 0;
    std::string_view last; // the last string
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            const std::size_t begin = ++i;
            while (i < text.size() && text[i] != '"')
                i += text[i] == '\\' ? 2 : 1;
            last = text.substr(begin, std::min(i, text.size()) - begin);
        } else if (c == ':' && depth == 1 && last == member) {
            const std::size_t end = std::min(text.find_first_of(",}", i), text.size());
            return parse_number(trim(text.substr(i + 1, end - i - 1)));
        } else if (c == '{' || c == '[') {
            ++depth;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return std::nullopt;
}

} // namespace

bool is_bids_motion(const std::string& path) {
    return fs::path(path).filename().string().ends_with(motion_ending);
}

std::string motion_file(const std::string& path) {
    std::error_code ignored;
    if (!fs::is_directory(path, ignored))
        return path;
    constexpr int levels = 3; // sub-01/ses-01/motion
    std::vector<std::string> found;
    collect_motion(path.ends_with('/') ? path.substr(0, path.size() - 1) : path, levels, found);
    if (found.empty())
        return path; // reading it fails, with a text that says what to do
    if (found.size() == 1)
        return found[0];
    constexpr std::size_t most = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
        list += (i == 0 ? "" : ", ") + found[i];
    fail(Status::argument, "{}: this folder holds {} motion files: give one of {}{}", path,
         found.size(), list, found.size() > most ? ", ..." : "");
}

std::string find_beside(const std::string& motion_path, std::string_view ending) {
    const std::set<std::string> own = entities_of(fs::path(motion_path).filename().string());
    fs::path folder = fs::path(motion_path).parent_path();
    for (;;) {
        const std::string shown = folder.empty() ? "." : folder.string();
        if (const std::string name = most_specific(shown, own, ending); !name.empty())
            return (folder / name).string();
        if (!is_inside_dataset(folder.filename().string()) || folder.parent_path() == folder)
            return {};
        folder = folder.parent_path();
    }
}

std::vector<std::string> channel_names(const std::string& path, const Progress& progress) {
    const std::string bytes = read_file(path, progress);
    TextCursor in(bytes, path, progress);
    const auto cells_of = [&](std::string_view line) {
        auto cells = split_cells(line, '\t');
        if (!cells)
            in.fail(Status::format, "a quote is not closed at the end of its cell");
        return *std::move(cells);
    };
    const ChannelTable table(in, cells_of(in.line()));
    std::vector<std::string> names;
    for (std::string_view line = in.line(); !line.empty(); line = in.line())
        names.push_back(table.name_of(cells_of(line)));
    if (names.empty())
        in.fail(Status::format, "the table of channels has no rows");
    return names;
}

double sampling_frequency(const std::string& path, const Progress& progress) {
    const std::string text = read_file(path, progress);
    const double rate = json_number(text, "SamplingFrequency").value_or(0);
    return rate >= lowest_fps && rate <= highest_fps ? rate : 0;
}

} // namespace stltsa::clip
