// SPDX-License-Identifier: BSD-3-Clause
// Motion and storage files of OpenSim and SIMM: joint coordinates, forces, or anything over time.
#include <algorithm>
#include <map>

#include "clip/csv/cells.hpp"
#include "clip/csv/point_columns.hpp"
#include "clip/csv/table.hpp"
#include "clip/csv/time_column.hpp"
#include "clip/opensim/header.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// Cells of several numbers, separated by commas; the file says so.
struct DataType {
    std::string_view name;
    std::vector<std::string> parts; ///< what is after the name of each column
};

std::vector<std::string> parts_of(std::string_view type) {
    const DataType types[] = {
        {"Vec3", {"_x", "_y", "_z"}},
        {"UnitVec3", {"_x", "_y", "_z"}},
        {"Quaternion", {"_w", "_x", "_y", "_z"}},
        {"SpatialVec", {"_rx", "_ry", "_rz", "_tx", "_ty", "_tz"}},
    };
    for (const DataType& known : types)
        if (equals_ignoring_case(known.name, type))
            return known.parts;
    return {};
}

class MotHeader {
  public:
    explicit MotHeader(TextCursor& in) {
        for (std::string_view line = in.line(); !ends_header(line); line = in.line()) {
            if (line.empty())
                in.fail(Status::format, "a MOT or STO file has a line endheader, and the names of "
                                        "the columns below it");
            take(line);
        }
        names_ = header_cells(in.line());
        if (names_.empty())
            in.fail(Status::format, "there are no names of columns below endheader");
        for (const std::string& name : names_)
            in.check_name(name);
        written_ = std::ssize(names_);
    }

    /// Value of a key, in lower case; empty: the header does not have it.
    std::string said(const std::string& key) const {
        const auto found = said_.find(key);
        return found == said_.end() ? std::string() : found->second;
    }

    /// One for each column of numbers.
    std::vector<std::string> names(const std::vector<std::string>& parts) const {
        if (parts.empty())
            return names_;
        std::vector<std::string> all = {names_[0]};
        for (std::size_t c = 1; c < names_.size(); ++c)
            for (const std::string& part : parts)
                all.push_back(names_[c] + part);
        return all;
    }

    /// Columns as the file counts them.
    std::int64_t written() const { return written_; }

  private:
    /// "nRows=100"; of SIMM, "datarows 100".
    void take(std::string_view line) {
        std::string_view rest = trim(line);
        const std::string key = to_lower(trim(next_word(rest, "=,;")));
        const std::string_view separators = "=,; \t";
        rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
        while (!rest.empty() && separators.find(rest.back()) != separators.npos)
            rest.remove_suffix(1);
        said_[key == "datarows"      ? "nrows"
              : key == "datacolumns" ? "ncolumns"
                                     : key] = std::string(rest);
    }

    std::map<std::string, std::string> said_;
    std::vector<std::string> names_;
    std::int64_t written_ = 0;
};

/// The unit of the angles, which is no part of the names.
void note_angles(Clip& clip, const std::string& in_degrees) {
    if (equals_ignoring_case(in_degrees, "yes"))
        clip.notes.emplace_back("angles are in degrees (inDegrees)");
    else if (equals_ignoring_case(in_degrees, "no"))
        clip.notes.emplace_back("angles are in radians (inDegrees)");
}

} // namespace

Clip parse_mot(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    TextCursor in(bytes, name);
    const MotHeader header(in);
    const std::vector<std::string> parts = parts_of(header.said("datatype"));
    std::string apart; // the same text, so that lines keep their numbers
    if (!parts.empty()) {
        const std::size_t begin = bytes.size() - in.bytes_left();
        apart = bytes;
        std::replace(apart.begin() + static_cast<std::ptrdiff_t>(begin), apart.end(), ',', '\t');
        in = TextCursor(apart, name);
        MotHeader again(in);
    }
    Clip clip;
    const TableFacts facts = read_rows(in, clip, {header.names(parts)}, options);
    note_other_count(clip, "nRows", header.said("nrows"), clip.values.rows());
    note_other_count(clip, "nColumns", header.said("ncolumns"), header.written());
    note_angles(clip, header.said("indegrees"));
    extract_time(clip, facts, name, options, [&] {
        if (equals_ignoring_case(header.said("datatype"), "Vec3"))
            take_points(clip, name, options);
        else
            take_columns_of_subject(clip, name, options);
    });
    return clip;
}

} // namespace stltsa::clip
