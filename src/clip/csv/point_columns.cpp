// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/point_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "base/checkpoint.hpp"
#include "clip/arrays/arrays.hpp"
#include "clip/features/point_names.hpp"
#include "clip/features/subjects.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

constexpr std::int64_t none = -1;

/// The columns of one point, or of another quantity that is named so.
struct Point {
    std::string name;                                      ///< as in the file
    std::array<std::int64_t, 3> columns{none, none, none}; ///< of x, y, z
    std::int64_t confidence = none;
    std::string unit;
    bool is_set_apart = true; ///< the axes in all names

    /// 2 or 3; 0: coordinates are absent.
    int space() const {
        return columns[0] == none || columns[1] == none ? 0 : columns[2] == none ? 2 : 3;
    }
};

/// What a file's columns are.
struct Columns {
    std::vector<Point> points;
    std::vector<std::string> quantities;  ///< names of triples of other quantities
    std::vector<std::string> others;      ///< names of columns that belong to no point
    std::vector<std::string> names;       ///< of all columns, with the axis last
    std::vector<std::int64_t> of_subject; ///< all but those of other subjects
};

/// Programs count columns of the same name: "heel_x", "heel_x.1" (pandas, R), "heel_x_1" (MATLAB).
std::vector<std::string> without_counts(std::vector<std::string> names) {
    const std::set<std::string, std::less<>> known(names.begin(), names.end());
    for (std::string& name : names) {
        const std::size_t end = name.find_last_not_of("0123456789");
        if (end == name.npos || end + 1 == name.size() || (name[end] != '.' && name[end] != '_'))
            continue;
        const std::string_view first = std::string_view(name).substr(0, end);
        if (known.contains(first) && (!coordinate_of(first, AxisPlace::last).point.empty() ||
                                      !point_of_confidence(first).empty()))
            name.resize(end);
    }
    return names;
}

/// Collects columns by the names of their points. Points of the same name are told apart by their
/// order: the second x is of the second of them, or begins it if an axis of some is absent.
class PointFinder {
  public:
    explicit PointFinder(const std::vector<std::string>& names, AxisPlace place) {
        found_.names = place == AxisPlace::last ? without_counts(names) : names;
        std::vector<std::pair<Coordinate, std::size_t>> coordinates;
        for (std::size_t c = 0; c < names.size(); ++c)
            // "visibility" ends as an axis.
            if (Coordinate coordinate = coordinate_of(found_.names[c], place);
                coordinate.point.empty() || !point_of_confidence(found_.names[c]).empty()) {
                rest_.push_back(c);
            } else {
                ++by_name_[to_lower(coordinate.point)].of_axis[coordinate.axis];
                coordinates.emplace_back(std::move(coordinate), c);
            }
        for (const auto& [coordinate, c] : coordinates)
            add(coordinate, c);
        for (const std::size_t c : rest_)
            if (!add_confidence(c))
                found_.others.push_back(found_.names[c]);
        sort_out();
    }

    Columns columns() && { return std::move(found_); }

  private:
    /// Points of one name.
    struct Namesakes {
        std::vector<std::size_t> points;
        std::array<std::size_t, 3> of_axis{}, taken{}; ///< columns
        std::size_t with_confidence = 0;

        bool have_all_axes() const {
            return of_axis[0] == of_axis[1] && (of_axis[2] == 0 || of_axis[2] == of_axis[0]);
        }
    };

    void add(const Coordinate& coordinate, std::size_t c) {
        Namesakes& same = by_name_[to_lower(coordinate.point)];
        const std::size_t axis = coordinate.axis;
        std::size_t place = same.points.size();
        if (same.have_all_axes())
            place = same.taken[axis]++;
        else if (place > 0 && all_[same.points.back()].columns[axis] == none)
            --place;
        if (place == same.points.size()) {
            same.points.push_back(all_.size());
            all_.emplace_back().name = coordinate.point;
        }
        Point& point = all_[same.points[place]];
        point.columns[axis] = static_cast<std::int64_t>(c);
        point.is_set_apart = point.is_set_apart && coordinate.is_set_apart;
        point.unit = unit_of(found_.names[c]);
        found_.names[c] = coordinate.name;
    }

    bool add_confidence(std::size_t c) {
        const std::string_view name = point_of_confidence(found_.names[c]);
        const auto same = name.empty() ? by_name_.end() : by_name_.find(to_lower(name));
        if (same == by_name_.end() || same->second.with_confidence == same->second.points.size())
            return false;
        all_[same->second.points[same->second.with_confidence++]].confidence =
            static_cast<std::int64_t>(c);
        return true;
    }

    /// Axes with a letter before them, such as "Leg.rx" of rotations, as tables of poses have them,
    /// of quaternions, velocities and accelerations. An "ankle_rx" beside "ankle_lx" is the right
    /// ankle, and "a" may be followed by "b".
    bool has_other_axes(const Point& point) const {
        constexpr std::string_view letters = "rqvwa", beside = "l   b";
        std::string name = to_lower(point.name);
        const std::size_t letter = name.empty() ? letters.npos : letters.find(name.back());
        if (point.is_set_apart || name.size() < 2 || letter == letters.npos ||
            std::isalnum(static_cast<unsigned char>(name[name.size() - 2])) != 0)
            return false;
        name.back() = beside[letter];
        return !by_name_.contains(name);
    }

    void sort_out() {
        for (Point& point : all_)
            if (point.space() == 0) {
                for (const std::int64_t column : point.columns)
                    if (column != none)
                        found_.others.push_back(found_.names[static_cast<std::size_t>(column)]);
            } else if (is_other_quantity(point.name) || is_other_unit(point.unit) ||
                       has_other_axes(point)) {
                found_.quantities.push_back(std::move(point.name));
            } else {
                found_.points.push_back(std::move(point));
            }
    }

    Columns found_;
    std::vector<Point> all_; ///< in the order of their first columns
    std::map<std::string, Namesakes> by_name_;
    std::vector<std::size_t> rest_;
};

/// The place of the axes is the one that more columns have.
Columns find_points(const std::vector<std::string>& names) {
    Columns best = PointFinder(names, AxisPlace::last).columns();
    for (const AxisPlace place : {AxisPlace::counted, AxisPlace::first})
        if (Columns found = PointFinder(names, place).columns();
            found.points.size() > best.points.size())
            best = std::move(found);
    return best;
}

/// Whether the last word of a file's name is one for angles, as of "walk_rot.csv".
bool is_named_after_angles(const std::string& file) {
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    std::string stem = to_lower(std::filesystem::path(file).stem().string());
    while (!stem.empty() && !is_letter(stem.back()))
        stem.pop_back();
    const auto before = std::find_if_not(stem.rbegin(), stem.rend(), is_letter);
    return is_angle(std::string_view(before.base(), stem.end()));
}

std::size_t coordinates_of(const Columns& found) {
    return found.points.size() * static_cast<std::size_t>(found.points[0].space());
}

/// Why columns that are named as points may be something else; empty: they are points. Fewer than
/// three points must have all columns, three or more must have most of the columns.
std::string doubt(const Columns& found, const std::string& file) {
    const auto count = [&](auto holds) { return std::ranges::count_if(found.points, holds); };
    const std::int64_t all = std::ssize(found.points);
    const std::int64_t with_confidence =
        count([](const Point& point) { return point.confidence != none; });
    if (is_named_after_angles(file))
        return "the name of the file is that of angles";
    if (count([&](const Point& point) { return point.space() == found.points[0].space(); }) < all)
        return "some have 2 coordinates, and some 3";
    if (with_confidence > 0 && with_confidence < all)
        return "only some have a confidence";
    if (!found.others.empty() &&
        (all < least_points || found.others.size() >= coordinates_of(found)))
        return "there are as many other columns, or fewer than 3 points: " +
               in_quotes(found.others[0]);
    if (!found.quantities.empty() && all < least_points)
        return "there are other quantities, and fewer than 3 points: " +
               in_quotes(found.quantities[0]);
    if (all < least_points && count([](const Point& point) { return !point.is_set_apart; }) > 0)
        return "fewer than 3 points need names such as 'heel_x'";
    return {};
}

void note_left_out(const Columns& found, Clip& clip) {
    if (!found.quantities.empty())
        clip.notes.push_back(format_text("{} columns of other quantities than positions are left "
                                         "out, the first are those of {}",
                                         3 * found.quantities.size(), found.quantities.front()));
    const std::size_t count = found.others.size();
    if (count > 0)
        clip.notes.push_back(
            format_text("no coordinates of points, so left out: {} {}",
                        count == 1 ? "column" : format_text("{} columns, the first is", count),
                        in_quotes(found.others.front())));
}

void note_unit(const Columns& found, Clip& clip) {
    const std::string& unit = found.points[0].unit;
    if (!unit.empty() &&
        std::ranges::all_of(found.points, [&](const Point& point) { return point.unit == unit; }))
        clip.notes.push_back("unit of the positions, by the names of the columns: " + unit);
}

Matrix columns_of(const Matrix& values, const std::vector<std::int64_t>& columns) {
    Matrix result = Matrix::unset(values.rows(), std::ssize(columns));
    for (std::int64_t i = 0; i < values.rows(); ++i) {
        std::transform(columns.begin(), columns.end(), result.row(i),
                       [row = values.row(i)](std::int64_t column) { return row[column]; });
        checkpoint(result.cols());
    }
    return result;
}

/// Keeps the points of one subject. Columns of the others go, whatever they are.
void choose_subject(Columns& found, Clip& clip, const std::string& file, const ReadOptions& options,
                    const std::vector<Subject>& stated) {
    std::vector<std::string> names;
    for (const Point& point : found.points)
        names.push_back(point.name);
    const SubjectPoints chosen = take_subject(clip, names, options.subject, file, stated);
    std::vector<bool> goes;
    for (const std::string& name : found.names)
        goes.push_back(chosen.is_of_other(name));
    const auto mark = [&](const Point& point, bool as) {
        for (const std::int64_t column :
             {point.columns[0], point.columns[1], point.columns[2], point.confidence})
            if (column != none)
                goes[static_cast<std::size_t>(column)] = as;
    };
    for (const Point& point : found.points)
        mark(point, true);
    std::vector<Point> points;
    for (const std::size_t i : chosen.points) {
        mark(found.points[i], false);
        points.push_back(std::move(found.points[i]));
    }
    found.points = std::move(points);
    const auto is_of_other = [&](const std::string& name) { return chosen.is_of_other(name); };
    std::erase_if(found.others, is_of_other);
    std::erase_if(found.quantities, is_of_other);
    for (std::size_t c = 0; c < goes.size(); ++c)
        if (!goes[c])
            found.of_subject.push_back(static_cast<std::int64_t>(c));
}

/// Makes the clip one of points, with x, y and z beside each other.
void keep_points(const Columns& found, Clip& clip, const ReadOptions& options) {
    std::vector<std::int64_t> coordinates, confidence;
    clip.space = found.points[0].space();
    for (const Point& point : found.points) {
        coordinates.insert(coordinates.end(), point.columns.begin(),
                           point.columns.begin() + clip.space);
        if (point.confidence != none)
            confidence.push_back(point.confidence);
    }
    const Matrix sure = columns_of(clip.values, confidence);
    clip.channel_names = found.names;
    keep_columns(clip, coordinates);
    if (confidence.empty())
        return;
    const std::int64_t dropped =
        drop_unsure(clip.values, clip.space, sure.view(), options.min_confidence);
    clip.notes.push_back(format_text("columns of confidence: {} of {} positions are below {:g} and "
                                     "taken as missing",
                                     dropped, sure.rows() * sure.cols(), options.min_confidence));
}

/// Says that columns are taken as they are that may be coordinates, and how to name these.
void note_unclear_axes(Clip& clip) {
    for (const AxisPlace place :
         {AxisPlace::numbered, AxisPlace::numbered_from_1, AxisPlace::between}) {
        const Columns found = PointFinder(clip.channel_names, place).columns();
        if (std::ssize(found.points) < least_points || !doubt(found, {}).empty())
            continue;
        const auto first = static_cast<std::size_t>(found.points[0].columns[0]);
        return clip.notes.push_back(format_text(
            "{} columns such as {} are not taken as coordinates of points: if they are, name them "
            "as in {}",
            coordinates_of(found), in_quotes(clip.channel_names[first]),
            in_quotes(found.names[first])));
    }
}

} // namespace

void keep_columns(Clip& clip, const std::vector<std::int64_t>& columns) {
    clip.values = columns_of(clip.values, columns);
    std::vector<std::string> names;
    for (const std::int64_t column : columns)
        names.push_back(clip.channel_names[static_cast<std::size_t>(column)]);
    clip.channel_names = std::move(names);
}

void take_columns_of_subject(Clip& clip, const std::string& file, const ReadOptions& options,
                             const std::vector<Subject>& stated) {
    std::vector<std::string> names;
    for (const std::string& column : clip.channel_names) {
        const std::string point = coordinate_of(column, AxisPlace::last).point;
        names.push_back(point.empty() ? column : point);
    }
    const auto chosen =
        take_subject(clip, names, options.subject, file, stated, Named::columns).points;
    if (chosen.size() < names.size())
        keep_columns(clip, {chosen.begin(), chosen.end()});
}

void take_points(Clip& clip, const std::string& file, const ReadOptions& options,
                 const std::vector<Subject>& stated) {
    Columns found = find_points(clip.channel_names);
    if (found.points.empty() && !found.quantities.empty())
        clip.notes.push_back("columns named as coordinates are of other quantities than positions, "
                             "by their names or units: " +
                             in_quotes(found.quantities[0]));
    if (found.points.empty() && found.quantities.empty())
        note_unclear_axes(clip);
    if (found.points.empty())
        return take_columns_of_subject(clip, file, options, stated);
    choose_subject(found, clip, file, options, stated);
    if (const std::string why = doubt(found, file); !why.empty()) {
        clip.notes.push_back(format_text("{} columns are named as coordinates, but not taken as "
                                         "those of points: {}",
                                         coordinates_of(found), why));
        if (found.of_subject.size() < found.names.size())
            keep_columns(clip, found.of_subject);
        return;
    }
    keep_points(found, clip, options);
    note_left_out(found, clip);
    note_unit(found, clip);
}

} // namespace stltsa::clip
