// SPDX-License-Identifier: BSD-3-Clause
#include "base/checkpoint.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/bvh/form.hpp"
#include "clip/clip.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

/// Replaces characters that would end the name.
std::string plain_name(std::string name) {
    for (char& c : name)
        if (c == '{' || static_cast<unsigned char>(c) < ' ')
            c = '_';
    return name;
}

/// Writes the joints in their depth-first order, with a stack of the joints whose brace is open.
class HierarchyWriter {
  public:
    HierarchyWriter(const Skeleton& skeleton, std::string& text)
        : joints_(skeleton.joints), text_(text) {}

    void write() {
        text_ += "HIERARCHY\n";
        for (std::size_t j = 0; j < joints_.size(); ++j) {
            close_down_to(joints_[j].parent);
            open(static_cast<int>(j));
        }
        close_down_to(-1);
    }

  private:
    void close_down_to(int parent) {
        while (!open_.empty() && open_.back() != parent) {
            open_.pop_back();
            begin_line() += "}\n";
        }
        if (parent >= 0 && open_.empty())
            fail(Status::internal, "the joints of the skeleton are not in depth-first order");
    }

    void open(int index) {
        const Joint& joint = joints_[static_cast<std::size_t>(index)];
        begin_line() += title(joint) + '\n';
        begin_line() += "{\n";
        open_.push_back(index);
        begin_line() += "OFFSET";
        for (const double value : joint.offset) {
            text_ += ' ';
            append_number(text_, value);
        }
        text_ += '\n';
        if (!joint.end_site || !joint.channels.empty())
            channels(joint);
    }

    std::string title(const Joint& joint) const {
        if (joint.parent < 0)
            return "ROOT " + plain_name(joint.name);
        if (!joint.end_site)
            return "JOINT " + plain_name(joint.name);
        // Readers expect no name, and most end sites have only that of their parent.
        const std::string& parent = joints_[static_cast<std::size_t>(joint.parent)].name;
        return joint.name == parent + " end" ? "End Site" : "End Site " + plain_name(joint.name);
    }

    void channels(const Joint& joint) {
        begin_line() += format_text("CHANNELS {}", joint.channels.size());
        for (const Channel channel : joint.channels) {
            text_ += ' ';
            text_ += static_cast<char>('X' + channel_axis(channel));
            text_ += is_rotation(channel) ? "rotation" : "position";
        }
        text_ += '\n';
    }

    std::string& begin_line() { return text_.append(open_.size(), '\t'); }

    const std::vector<Joint>& joints_;
    std::string& text_;
    std::vector<int> open_;
};

void append_motion(std::string& text, const Clip& clip) {
    text += format_text("MOTION\nFrames: {}\nFrame Time: ", clip.frames());
    append_number(text, clip.frame_time > 0 ? clip.frame_time : 1 / clip.fps);
    text += '\n';
    for (std::int64_t i = 0; i < clip.frames(); ++i) {
        for (std::int64_t c = 0; c < clip.values.cols(); ++c) {
            append_number(text, clip.values(i, c));
            text += c + 1 < clip.values.cols() ? ' ' : '\n';
        }
        checkpoint(work_of_number * clip.values.cols());
    }
}

} // namespace

std::string format_bvh(const Clip& clip) {
    if (!clip.skeleton)
        fail(Status::unsupported,
             "a BVH file needs a skeleton, but this clip is a bare matrix: write .csv or .npy");
    if (!(clip.fps > 0))
        fail(Status::unsupported, "a BVH file needs a frame rate, but that of this clip is "
                                  "unknown: open it with option fps");
    if (1 / clip.fps > longest_frame_s)
        fail(Status::unsupported,
             "a frame of a BVH file takes at most {:g} s, but one of this clip takes {:g} s: give "
             "the clip a higher frame rate",
             longest_frame_s, 1 / clip.fps);
    const Clip bvh = in_bvh_form(clip);
    std::string text;
    HierarchyWriter(*bvh.skeleton, text).write();
    append_motion(text, bvh);
    return text;
}

} // namespace stltsa::clip
