// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "clip/acclaim/skeleton_file.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/files/read_file.hpp"
#include "clip/text/number.hpp"
#include "clip/text/text_cursor.hpp"

namespace stltsa::clip {
namespace {

/// A joint's first column, and the last frame in which it was read.
struct Slot {
    const Joint* joint;
    std::size_t column;
    std::int64_t frame = -1;
};

class AmcReader {
  public:
    AmcReader(TextCursor& in, const AsfFile& asf, const std::string& asf_name)
        : in_(in), asf_name_(asf_name), degrees_(asf.degrees) {
        for (const Joint& joint : asf.skeleton.joints) {
            if (joint.channels.empty())
                continue;
            slots_.emplace(joint.name, Slot{&joint, columns_});
            columns_ += joint.channels.size();
        }
    }

    void read(Clip& clip) {
        for (std::string_view line = in_.line(); !line.empty(); line = in_.line())
            statement(line);
        if (frame_ < 0)
            in_.fail(Status::format, "the file has no frames");
        end_frame();
        Matrix values = Matrix::unset(frame_ + 1, static_cast<std::int64_t>(columns_));
        std::copy(values_.begin(), values_.end(), values.data());
        clip.values = std::move(values);
        clip.fps = fps_;
    }

  private:
    void statement(std::string_view line) {
        const std::string_view word = next_word(line);
        if (word[0] == '#')
            return;
        if (word[0] == ':')
            header(word, line);
        else if (const auto number = parse_integer(word))
            begin_frame(*number);
        else
            bone(word, line);
    }

    void header(std::string_view word, std::string_view line) {
        if (equals_ignoring_case(word, ":degrees"))
            degrees_ = true;
        else if (equals_ignoring_case(word, ":radians"))
            degrees_ = false;
        else if (equals_ignoring_case(word, ":samples-per-second"))
            fps_ = rate(next_word(line));
    }

    double rate(std::string_view word) {
        const auto value = parse_number(word);
        if (!value || !(*value >= lowest_fps && *value <= highest_fps))
            in_.fail(Status::format, "{} is not a frame rate from {:g} to {:g}", in_quotes(word),
                     lowest_fps, highest_fps);
        return *value;
    }

    /// The first frame may have any number; gaps after it would distort time.
    void begin_frame(std::int64_t number) {
        if (number < 0)
            in_.fail(Status::format, "invalid frame number {}; frame numbers are not negative",
                     number);
        if (frame_ >= 0) {
            end_frame();
            if (number - number_ != 1)
                in_.fail(Status::format,
                         "frame {} follows frame {}; frames must be numbered consecutively", number,
                         number_);
        }
        number_ = number;
        ++frame_;
        bones_read_ = 0;
        values_.resize(values_.size() + columns_);
    }

    void end_frame() {
        if (bones_read_ == slots_.size())
            return;
        std::string missing; // the first by name, so that the text is deterministic
        for (const auto& [name, slot] : slots_)
            if (slot.frame != frame_ && (missing.empty() || name < missing))
                missing = name;
        in_.fail(
            Status::format,
            "frame {} ends before this line without bone {}, which can move in {}: is the file "
            "truncated, or the skeleton the wrong one?",
            number_, in_quotes(missing), asf_name_);
    }

    void bone(std::string_view word, std::string_view line) {
        if (frame_ < 0)
            in_.fail(Status::format, "{} comes before the number of the first frame",
                     in_quotes(word));
        Slot& slot = find(word);
        if (slot.frame == frame_)
            in_.fail(Status::format, "bone {} appears twice in frame {}", in_quotes(word), number_);
        slot.frame = frame_;
        ++bones_read_;
        double* values = &values_[static_cast<std::size_t>(frame_) * columns_ + slot.column];
        const std::vector<Channel>& channels = slot.joint->channels;
        for (std::size_t c = 0; c < channels.size(); ++c)
            values[c] = number(slot, channels[c], next_word(line));
        if (!trim(line).empty())
            in_.fail(Status::format,
                     "bone {} has {} degrees of freedom in {}, but more numbers here: is it the "
                     "wrong skeleton?",
                     in_quotes(word), channels.size(), asf_name_);
    }

    Slot& find(std::string_view word) {
        name_.assign(word);
        auto found = slots_.find(name_);
        if (found == slots_.end())
            found = slots_.find(to_lower(word));
        if (found == slots_.end())
            in_.fail(Status::format, "{} has no moving bone {}: is it the wrong skeleton?",
                     asf_name_, in_quotes(word));
        return found->second;
    }

    double number(const Slot& slot, Channel channel, std::string_view word) {
        if (word.empty())
            in_.fail(Status::format,
                     "bone {} has {} degrees of freedom in {}, but fewer numbers here: is it the "
                     "wrong skeleton?",
                     in_quotes(slot.joint->name), slot.joint->channels.size(), asf_name_);
        const auto value = parse_number(word);
        if (!value)
            in_.fail(Status::format, "{} is not a number", in_quotes(word));
        if (!std::isfinite(*value))
            in_.fail(Status::not_finite, "frame {}, {} of bone {} is {}", frame_,
                     channel_name(channel), in_quotes(slot.joint->name), *value);
        return is_rotation(channel) && !degrees_ ? *value * (180 / std::numbers::pi) : *value;
    }

    TextCursor& in_;
    const std::string& asf_name_;
    std::unordered_map<std::string, Slot> slots_;
    std::size_t columns_ = 0;
    std::size_t bones_read_ = 0;
    std::vector<double> values_;
    std::int64_t frame_ = -1;
    std::int64_t number_ = 0;
    std::string name_; ///< reused to avoid allocation
    bool degrees_;
    double fps_ = 0;
};

void set_rate(Clip& clip, const ReadOptions& options) {
    if (clip.fps > 0 || options.fps)
        return;
    clip.fps = amc_fps;
    clip.notes.push_back(format_text(
        "AMC files have no frame rate: {} frames a second assumed (option fps sets another)",
        amc_fps));
}

} // namespace

Clip parse_amc(std::string_view bytes, const std::string& name, const ReadOptions& options) {
    const std::string& skeleton_path = options.skeleton;
    std::string text = read_file(skeleton_path);
    AsfFile asf = parse_asf(text, skeleton_path);
    asf.skeleton.asf = std::move(text);
    if (channel_count(asf.skeleton) == 0)
        fail(Status::format, "{}: nothing in this skeleton can move", skeleton_path);
    TextCursor in(bytes, name);
    Clip clip;
    AmcReader(in, asf, skeleton_path).read(clip);
    set_rate(clip, options);
    clip.skeleton = std::move(asf.skeleton);
    clip.channel_names = channel_names(*clip.skeleton);
    return clip;
}

} // namespace stltsa::clip
