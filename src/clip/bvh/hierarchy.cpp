// SPDX-License-Identifier: BSD-3-Clause
#include "clip/bvh/hierarchy.hpp"

#include <cmath>
#include <optional>

#include "clip/body/skeleton.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

/// More than any body has; limits the memory for a hostile file.
constexpr std::size_t most_joints = 4096;

/// "Xrotation", "yposition", ... Also "Xtranslation", which some exporters write.
std::optional<Channel> channel_of(std::string_view word) {
    const std::string name = to_lower(word);
    if (name.empty() || name[0] < 'x' || name[0] > 'z')
        return std::nullopt;
    const int axis = name[0] - 'x';
    const std::string_view kind = std::string_view(name).substr(1);
    if (kind == "rotation")
        return static_cast<Channel>(static_cast<int>(Channel::rx) + axis);
    if (kind == "position" || kind == "translation")
        return static_cast<Channel>(static_cast<int>(Channel::tx) + axis);
    return std::nullopt;
}

/// Uses a stack of open joints instead of recursion, because the file determines the depth.
class HierarchyReader {
  public:
    explicit HierarchyReader(TextCursor& in) : in_(in) {}

    Skeleton read() {
        if (!equals_ignoring_case(in_.word(), "HIERARCHY"))
            in_.fail(Status::format, "a BVH file must begin with HIERARCHY");
        for (;;) {
            const std::string_view word = in_.word();
            if (equals_ignoring_case(word, "MOTION"))
                break;
            statement(word);
        }
        if (!open_.empty())
            in_.fail(Status::format, "MOTION comes before the closing brace of joint {} on line {}",
                     in_quotes(joint().name), open_.back().line);
        if (skeleton_.joints.empty())
            in_.fail(Status::format, "the hierarchy has no ROOT");
        return std::move(skeleton_);
    }

  private:
    struct Open {
        int joint;
        std::int64_t line;
        bool has_offset = false;
    };

    Joint& joint() { return skeleton_.joints[static_cast<std::size_t>(open_.back().joint)]; }

    void statement(std::string_view word) {
        if (word.empty())
            in_.fail(Status::format, "the file ends inside the hierarchy: no MOTION was found");
        if (equals_ignoring_case(word, "ROOT"))
            root();
        else if (open_.empty())
            in_.fail(Status::format, "{} is outside ROOT {{ ... }}", in_quotes(word));
        else if (equals_ignoring_case(word, "OFFSET"))
            offset();
        else if (equals_ignoring_case(word, "CHANNELS"))
            channels();
        else if (equals_ignoring_case(word, "JOINT"))
            open_joint(false);
        else if (equals_ignoring_case(word, "End"))
            end_site();
        else if (equals_ignoring_case(word, "}"))
            close();
        else
            in_.fail(Status::format,
                     "{} is not expected here; a joint has OFFSET, CHANNELS, JOINT or End Site",
                     in_quotes(word));
    }

    void root() {
        if (!open_.empty())
            in_.fail(Status::format, "ROOT is inside joint {}: a closing brace is missing",
                     in_quotes(joint().name));
        if (!skeleton_.joints.empty())
            in_.fail(Status::unsupported,
                     "a second ROOT: files with several figures are not supported; keep one");
        open_joint(false);
    }

    void end_site() {
        if (!equals_ignoring_case(in_.word(), "Site"))
            in_.fail(Status::format, "'End' must be followed by 'Site'");
        open_joint(true);
    }

    /// A name may contain blanks or be missing; the brace may follow it or be on the next line.
    void open_joint(bool end_site) {
        const std::int64_t line = in_.line_number();
        Joint joint;
        joint.name = in_.rest_of_line('{');
        in_.check_name(joint.name);
        if (in_.word() != "{")
            in_.fail(Status::format, "'{{' is missing after {} on line {}", in_quotes(joint.name),
                     line);
        if (skeleton_.joints.size() == most_joints)
            in_.fail(Status::unsupported, "more than {} joints", most_joints);
        if (!open_.empty()) {
            if (this->joint().end_site)
                in_.fail(Status::format, "an End Site may have only an OFFSET");
            joint.parent = open_.back().joint;
        }
        joint.end_site = end_site;
        if (joint.name.empty())
            joint.name = end_site ? this->joint().name + " end"
                                  : format_text("joint {}", skeleton_.joints.size());
        open_.push_back({static_cast<int>(skeleton_.joints.size()), line});
        skeleton_.joints.push_back(std::move(joint));
    }

    void offset() {
        for (double& value : joint().offset)
            value = number("OFFSET");
        open_.back().has_offset = true;
    }

    void channels() {
        const auto count = parse_integer(in_.word());
        if (!count || *count < 0)
            in_.fail(Status::format, "CHANNELS must be followed by the number of channels");
        for (std::int64_t i = 0; i < *count; ++i) {
            const std::string_view word = in_.word();
            const auto channel = channel_of(word);
            if (!channel)
                in_.fail(Status::format,
                         "{} is not a channel; expected {} of Xposition ... Zrotation",
                         in_quotes(word), *count);
            std::vector<Channel>& channels = joint().channels;
            if (!may_follow(*channel, channels))
                in_.fail(Status::format, "joint {} has one {} too many: {}",
                         in_quotes(joint().name), in_quotes(word), channel_limit);
            channels.push_back(*channel);
        }
    }

    double number(std::string_view keyword) {
        const std::string_view word = in_.word();
        const auto value = parse_number(word);
        if (!value)
            in_.fail(Status::format, "{} must be followed by three numbers, not {}", keyword,
                     in_quotes(word));
        if (!std::isfinite(*value))
            in_.fail(Status::not_finite, "the {} of joint {} is not finite", keyword,
                     in_quotes(joint().name));
        return *value;
    }

    void close() {
        if (!open_.back().has_offset)
            in_.fail(Status::format, "joint {} on line {} has no OFFSET", in_quotes(joint().name),
                     open_.back().line);
        open_.pop_back();
    }

    TextCursor& in_;
    Skeleton skeleton_;
    std::vector<Open> open_;
};

} // namespace

Skeleton read_bvh_hierarchy(TextCursor& in) {
    return HierarchyReader(in).read();
}

} // namespace stltsa::clip
