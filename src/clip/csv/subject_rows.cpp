// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/subject_rows.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "clip/csv/cells.hpp"
#include "clip/csv/time_names.hpp"
#include "clip/features/subjects.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

bool is_any(std::string_view name, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(
        words, [name](std::string_view word) { return equals_ignoring_case(trim(name), word); });
}

std::optional<std::int64_t> frame_column(const Clip& clip) {
    for (std::size_t c = 0; c < clip.channel_names.size(); ++c)
        if (is_frame_name(clip.channel_names[c]))
            return static_cast<std::int64_t>(c);
    return std::nullopt;
}

/// A frame number that two rows have.
std::optional<double> repeated(const Matrix& values, std::int64_t column) {
    std::set<double> seen;
    for (std::int64_t i = 0; i < values.rows(); ++i)
        if (!std::isnan(values(i, column)) && !seen.insert(values(i, column)).second)
            return values(i, column);
    return std::nullopt;
}

std::vector<std::string> distinct(const std::vector<std::string>& all) {
    std::vector<std::string> names;
    std::set<std::string_view> known;
    for (const std::string& name : all)
        if (!name.empty() && known.insert(name).second)
            names.push_back(name);
    return names;
}

void keep_rows(Clip& clip, const std::vector<std::string>& subjects,
               std::vector<std::int64_t>& lines, const std::string& file,
               const ReadOptions& options) {
    const std::vector<std::string> names = distinct(subjects);
    clip.subject = one_subject(names, options.subject, file);
    if (std::string note = subject_note(names, clip.subject); !note.empty())
        clip.notes.push_back(std::move(note));
    Matrix rows = Matrix::unset(std::ranges::count(subjects, clip.subject), clip.values.cols());
    std::vector<std::int64_t> kept;
    for (std::int64_t i = 0; i < clip.values.rows(); ++i)
        if (subjects[static_cast<std::size_t>(i)] == clip.subject) {
            std::copy_n(clip.values.row(i), rows.cols(), rows.row(std::ssize(kept)));
            kept.push_back(lines[static_cast<std::size_t>(i)]);
        }
    clip.values = std::move(rows);
    lines.swap(kept);
}

} // namespace

bool names_subject(std::string_view column) {
    return is_any(column, {"track",         "track_id",  "track_name", "individual", "individuals",
                           "individual_id", "subject",   "subjects",   "subject_id", "animal",
                           "animals",       "animal_id", "person",     "person_id",  "player",
                           "participant",   "actor",     "id",         "object_id",  "body_id",
                           "instance"});
}

void take_rows_of_subject(Clip& clip, std::optional<std::size_t> column,
                          const std::vector<std::string>& subjects,
                          std::vector<std::int64_t>& lines, const std::string& file,
                          const ReadOptions& options) {
    const auto frames = frame_column(clip);
    if (!column) {
        const auto has = [&](std::string_view name) {
            return std::ranges::any_of(clip.channel_names,
                                       [&](const auto& other) { return is_any(other, {name}); });
        };
        const auto frame =
            frames && has("x") && has("y") ? repeated(clip.values, *frames) : std::nullopt;
        if (frame)
            fail(Status::format,
                 "{}: several rows, each with the x and y of one point, are of frame {:g}: "
                 "expected one row for each frame, with columns for all points, such as heel_x",
                 file, *frame);
        return;
    }
    const bool has_names = std::ranges::any_of(
        subjects, [](const std::string& name) { return !name.empty() && !parse_cell(name); });
    if (has_names || (frames && repeated(clip.values, *frames)))
        keep_rows(clip, subjects, lines, file, options);
    if (const auto frame = frames ? repeated(clip.values, *frames) : std::nullopt)
        fail(Status::format,
             "{}: several rows of one subject are of frame {:g}: expected one row for each frame, "
             "with all points",
             file, *frame);
}

} // namespace stltsa::clip
