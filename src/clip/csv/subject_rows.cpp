// SPDX-License-Identifier: BSD-3-Clause
#include "clip/csv/subject_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "clip/csv/cells.hpp"
#include "clip/features/subjects.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// More rows than this share of those given are not made up.
constexpr std::int64_t most_missing = 1;

bool is_any(std::string_view name, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(
        words, [name](std::string_view word) { return equals_ignoring_case(trim(name), word); });
}

std::optional<std::int64_t> frame_column(const Clip& clip) {
    for (std::size_t c = 0; c < clip.channel_names.size(); ++c)
        if (is_any(clip.channel_names[c],
                   {"frame", "frames", "frame_idx", "frame_index", "frame_number", "frameno"}))
            return static_cast<std::int64_t>(c);
    return std::nullopt;
}

/// Whether two rows have one frame number.
bool repeats(const Matrix& values, std::int64_t column) {
    std::set<double> seen;
    for (std::int64_t i = 0; i < values.rows(); ++i)
        if (!std::isnan(values(i, column)) && !seen.insert(values(i, column)).second)
            return true;
    return false;
}

std::vector<std::string> distinct(const std::vector<std::string>& all) {
    std::vector<std::string> names;
    std::set<std::string_view> known;
    for (const std::string& name : all)
        if (!name.empty() && known.insert(name).second)
            names.push_back(name);
    return names;
}

/// The rows at their frames; a frame without a row has its number and no other values.
Matrix spread(Matrix& rows, std::int64_t column, const std::string& file) {
    const std::int64_t last = rows.rows() - 1;
    for (std::int64_t i = 0; i <= last; ++i) {
        const double frame = rows(i, column), before = i > 0 ? rows(i - 1, column) : frame - 1;
        if (frame == before)
            fail(Status::format,
                 "{}: several rows of one subject are of frame {:g}: expected one row for each "
                 "frame, with all points",
                 file, frame);
        if (!(frame > before) || frame != std::floor(frame))
            return std::move(rows); // no frame numbers
    }
    const double count = rows(last, column) - rows(0, column) + 1;
    if (!(count <= static_cast<double>((1 + most_missing) * rows.rows())))
        fail(Status::format,
             "{}: frames {:g} to {:g} have {} rows of this subject: more frames are missing than "
             "there are; cut the recording at its breaks",
             file, rows(0, column), rows(last, column), rows.rows());
    Matrix all(static_cast<std::int64_t>(count), rows.cols());
    std::int64_t next = 0;
    for (std::int64_t i = 0; i < all.rows(); ++i) {
        const double frame = rows(0, column) + static_cast<double>(i);
        if (rows(next, column) == frame)
            std::copy_n(rows.row(next++), rows.cols(), all.row(i));
        else
            std::fill_n(all.row(i), rows.cols(), std::numeric_limits<double>::quiet_NaN());
        all(i, column) = frame;
    }
    return all;
}

void keep_rows(Clip& clip, const std::vector<std::string>& subjects, const std::string& file,
               const ReadOptions& options) {
    const std::vector<std::string> names = distinct(subjects);
    clip.subject = one_subject(names, options.subject, file);
    if (std::string note = subject_note(names, clip.subject); !note.empty())
        clip.notes.push_back(std::move(note));
    Matrix rows = Matrix::unset(std::ranges::count(subjects, clip.subject), clip.values.cols());
    for (std::int64_t i = 0, next = 0; i < clip.values.rows(); ++i)
        if (subjects[static_cast<std::size_t>(i)] == clip.subject)
            std::copy_n(clip.values.row(i), rows.cols(), rows.row(next++));
    clip.values = std::move(rows);
}

} // namespace

bool names_subject(std::string_view column) {
    return is_any(column,
                  {"track", "track_id", "track_name", "individual", "individuals", "individual_id",
                   "subject", "animal", "animal_id", "person", "person_id", "player"});
}

void take_rows_of_subject(Clip& clip, std::optional<std::size_t> column,
                          const std::vector<std::string>& subjects, const std::string& file,
                          const ReadOptions& options) {
    if (!column)
        return;
    const auto frames = frame_column(clip);
    const bool has_names = std::ranges::any_of(
        subjects, [](const std::string& name) { return !name.empty() && !parse_cell(name); });
    if (has_names || (frames && repeats(clip.values, *frames)))
        keep_rows(clip, subjects, file, options);
    if (!frames)
        return;
    const std::int64_t count = clip.values.rows();
    clip.values = spread(clip.values, *frames, file);
    if (const std::int64_t missing = clip.values.rows() - count; missing > 0)
        clip.notes.push_back(format_text("frames without a row, taken as missing: {} of {}",
                                         missing, clip.values.rows()));
}

} // namespace stltsa::clip
