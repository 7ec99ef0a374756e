// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/bids.hpp"

#include <algorithm>
#include <array>

#include "base/json.hpp"
#include "clip/clip.hpp"
#include "clip/csv/cells.hpp"
#include "clip/files/read_file.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

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
        std::string name = type == "pos" ? point + axis + unit : point + '_' + type + axis + unit;
        in_.check_name(name);
        return name;
    }

  private:
    static constexpr std::array<std::string_view, 5> titles = {"name", "component", "type",
                                                               "tracked_point", "units"};
    TextCursor& in_;
    std::array<std::size_t, 5> places_{};
};

} // namespace

std::vector<std::string> channel_names(const std::string& path) {
    const std::string bytes = read_file(path);
    TextCursor in(bytes, path);
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

double sampling_frequency(const std::string& path) {
    const std::string text = read_file(path);
    const double rate = parse_number(json_member(text, "SamplingFrequency")).value_or(0);
    return rate >= lowest_fps && rate <= highest_fps ? rate : 0;
}

} // namespace stltsa::clip
