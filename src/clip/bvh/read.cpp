// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "clip/body/quaternion.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/bvh/form.hpp"
#include "clip/bvh/hierarchy.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

/// The text after "Frames:" or "Frame Time:" on the next line; blanks are optional.
std::string_view header_value(TextCursor& in, std::string_view first, std::string_view second) {
    const std::string_view line = trim(in.line());
    std::string_view remaining = line;
    for (const std::string_view word : {first, second, std::string_view(":")}) {
        if (!starts_with_ignoring_case(remaining, word))
            in.fail(Status::format, "'{}{}{}:' is expected here, not {}", first,
                    second.empty() ? "" : " ", second, in_quotes(line));
        remaining = trim(remaining.substr(word.size()));
    }
    return remaining;
}

std::int64_t read_frame_count(TextCursor& in) {
    const std::string_view text = header_value(in, "Frames", "");
    const auto frames = parse_integer(text);
    if (!frames || *frames < 0)
        in.fail(Status::format, "'Frames:' must be followed by the number of frames, not {}",
                in_quotes(text));
    if (*frames == 0)
        in.fail(Status::format, "the file has no frames, only a skeleton");
    return *frames;
}

/// A rate that the user gives needs no plausible Frame Time; parse() notes which one it replaces.
void read_rate(TextCursor& in, Clip& clip, bool given) {
    const std::string_view text = header_value(in, "Frame", "Time");
    const auto seconds = parse_number(text);
    if (!seconds || *seconds < 0 || !std::isfinite(*seconds))
        in.fail(Status::format, "'Frame Time:' must be followed by a number of seconds, not {}",
                in_quotes(text));
    if (!given && *seconds > 0 && (*seconds < shortest_frame_s || *seconds > longest_frame_s))
        in.fail(Status::format,
                "invalid Frame Time {:g} s; expected {:g} s to {:g} s: if {:g} is a rate, or "
                "milliseconds, set option fps to the number of frames a second",
                *seconds, shortest_frame_s, longest_frame_s, *seconds);
    clip.fps = rate_of(*seconds);
    if (clip.fps == 0 && !given)
        clip.notes.push_back("Frame Time is 0: the file has no frame rate");
    else
        clip.frame_time = *seconds;
}

/// Reads the rows as a stream of numbers: a row may span several lines, but begins on a new line.
class RowReader {
  public:
    RowReader(TextCursor& in, Clip& clip, std::int64_t frames, std::int64_t channels)
        : in_(in), clip_(clip), frames_(frames), channels_(channels) {}

    void read() {
        // A number takes at least two bytes: check the size before allocating.
        const auto most = static_cast<std::int64_t>(in_.bytes_left() / 2 + 1) / channels_;
        if (frames_ > most + 1)
            wrong_count();
        Matrix values(frames_, channels_);
        while (frame_ < frames_ && read_row(values.row(frame_)))
            ++frame_;
        std::vector<double> more(static_cast<std::size_t>(channels_));
        const bool one_more = frame_ == frames_ && read_row(more.data());
        if (frame_ == 0 || frame_ + 1 < frames_ || (one_more && !in_.word().empty()))
            wrong_count();
        clip_.values = one_more || frame_ < frames_ ? off_by_one(values, more) : std::move(values);
    }

  private:
    /// Some exporters count one frame more or less than they write.
    Matrix off_by_one(const Matrix& values, const std::vector<double>& more) {
        const std::int64_t rows = frame_ < frames_ ? frames_ - 1 : frames_ + 1;
        Matrix all = Matrix::unset(rows, channels_);
        std::copy_n(values.data(), frame_ * channels_, all.data());
        if (rows > frames_)
            std::ranges::copy(more, all.row(frames_));
        clip_.notes.push_back(
            format_text("the file declares {} frames, but has {}, which are read", frames_, rows));
        return all;
    }

    /// False at the end of the data.
    bool read_row(double* row) {
        for (std::int64_t c = 0; c < channels_; ++c) {
            const std::string_view word = in_.word();
            if (word.empty() && c == 0)
                return false;
            if (word.empty())
                wrong_count();
            if (c == 0)
                check_row_begin();
            const auto value = parse_number(word);
            if (!value)
                in_.fail(Status::format, "{} is not a number (frame {}, channel {})",
                         in_quotes(word), frame_, name(c));
            if (!std::isfinite(*value))
                in_.fail(Status::not_finite, "frame {}, channel {} is {}", frame_, name(c), *value);
            row[c] = *value;
        }
        row_end_ = in_.line_number();
        return true;
    }

    /// Called at the first word of a row. If a row begins in the middle of a line, the previous row
    /// had too many numbers, or too few and took some of this one.
    void check_row_begin() {
        const std::int64_t line = in_.line_number();
        if (frame_ > 0 && line == row_end_)
            in_.fail_at(row_begin_, Status::format,
                        "frame {} has {} numbers than the {} channels of the hierarchy", frame_ - 1,
                        row_begin_ == row_end_ ? "more" : "fewer", channels_);
        row_begin_ = line;
    }

    [[noreturn]] void wrong_count() {
        const std::int64_t count = count_numbers();
        in_.fail(Status::format,
                 "the file declares {} frames of {} channels, but has {} frames{}: {}", frames_,
                 channels_, count / channels_,
                 count % channels_ == 0 ? "" : format_text(" and {} numbers", count % channels_),
                 count / channels_ < frames_ ? "is it cut off? If not, correct 'Frames:'"
                                             : "correct 'Frames:' if all belong to the motion");
    }

    /// Counts all numbers of the data; leaves in_ at the last one.
    std::int64_t count_numbers() {
        std::int64_t count = 0;
        for (TextCursor cursor = begin_; !cursor.word().empty(); ++count)
            in_ = cursor;
        return count;
    }

    std::string name(std::int64_t c) const {
        return in_quotes(clip_.channel_names[static_cast<std::size_t>(c)]);
    }

    TextCursor& in_;
    Clip& clip_;
    const TextCursor begin_{in_};
    const std::int64_t frames_;
    const std::int64_t channels_;
    std::int64_t frame_ = 0;
    std::int64_t row_begin_ = 0;
    std::int64_t row_end_ = 0;
};

} // namespace

Clip parse_bvh(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    TextCursor in(bytes, name);
    Clip clip;
    clip.skeleton = read_bvh_hierarchy(in);
    clip.channel_names = channel_names(*clip.skeleton);
    const std::int64_t channels = channel_count(*clip.skeleton);
    if (channels == 0)
        in.fail(Status::format, "no joint has CHANNELS");
    const std::int64_t frames = read_frame_count(in);
    read_rate(in, clip, options.fps.has_value());
    RowReader(in, clip, frames, channels).read();
    if (positions_add_to_offsets(clip)) {
        clip.skeleton = with_positions(*std::move(clip.skeleton), true);
        clip.notes.push_back("positions of joints below the root are assumed to add to OFFSET");
    }
    return clip;
}

} // namespace stltsa::clip
