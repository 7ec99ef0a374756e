// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

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

void read_rate(TextCursor& in, Clip& clip) {
    const std::string_view text = header_value(in, "Frame", "Time");
    const auto seconds = parse_number(text);
    if (!seconds || *seconds < 0 || !std::isfinite(*seconds))
        in.fail(Status::format, "'Frame Time:' must be followed by a number of seconds, not {}",
                in_quotes(text));
    if (*seconds > 0 && (*seconds < shortest_frame_s || *seconds > longest_frame_s))
        in.fail(Status::format, "invalid Frame Time {} s; expected {} s to {} s", *seconds,
                shortest_frame_s, longest_frame_s);
    clip.fps = rate_of(*seconds);
    if (clip.fps == 0)
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
        if (frames_ > most)
            truncated();
        Matrix values(frames_, channels_);
        for (frame_ = 0; frame_ < frames_; ++frame_)
            read_row(values.row(frame_));
        if (!in_.word().empty()) {
            check_row_begin();
            in_.fail(Status::format, "too many numbers for {} frames: {} numbers for {} channels",
                     frames_, count_numbers(), channels_);
        }
        clip_.values = std::move(values);
    }

  private:
    void read_row(double* row) {
        for (std::int64_t c = 0; c < channels_; ++c) {
            const std::string_view word = in_.word();
            if (word.empty())
                truncated();
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

    [[noreturn]] void truncated() {
        const std::int64_t count = count_numbers();
        in_.fail(Status::format,
                 "the file ends early: it declares {} frames of {} channels, but has only {} "
                 "frames{}",
                 frames_, channels_, count / channels_,
                 count % channels_ == 0 ? "" : format_text(" and {} numbers", count % channels_));
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
    TextCursor in(bytes, name, options.progress);
    Clip clip;
    clip.skeleton = read_bvh_hierarchy(in);
    clip.channel_names = channel_names(*clip.skeleton);
    const std::int64_t channels = channel_count(*clip.skeleton);
    if (channels == 0)
        in.fail(Status::format, "no joint has CHANNELS");
    const std::int64_t frames = read_frame_count(in);
    read_rate(in, clip);
    RowReader(in, clip, frames, channels).read();
    if (positions_add_to_offsets(clip)) {
        clip.skeleton->translations_add = true;
        clip.notes.push_back("positions of joints below the root are assumed to add to OFFSET");
    }
    return clip;
}

} // namespace stltsa::clip
