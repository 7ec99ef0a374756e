// SPDX-License-Identifier: BSD-3-Clause
#include "clip/acclaim/bones.hpp"

#include <cmath>

#include "clip/body/skeleton.hpp"
#include "clip/text/number.hpp"

namespace stltsa::clip {
namespace {

/// Characters that separate words, in addition to blanks.
constexpr std::string_view separators = ",()";

class SectionReader {
  public:
    explicit SectionReader(TextCursor& in) : in_(in) {}

    AsfSections read() {
        sections_.root.name = "root";
        for (std::string_view line = in_.line(); !line.empty(); line = in_.line())
            statement(line.substr(0, line.find('#')));
        if (in_bone_)
            in_.fail(Status::format, "the file ends inside bone {}", in_quotes(bone().name));
        return std::move(sections_);
    }

  private:
    AsfBone& bone() { return sections_.bones.back(); }

    /// Ignores sections such as :documentation and :skin.
    void statement(std::string_view line) {
        const std::string word = to_lower(next_word(line, separators));
        if (word.empty())
            return;
        if (word[0] == ':')
            begin_section(word);
        else if (section_ == ":units")
            unit(word, line);
        else if (section_ == ":root")
            root(word, line);
        else if (section_ == ":bonedata")
            bone_data(word, line);
        else if (section_ == ":hierarchy")
            links(word, line);
    }

    void begin_section(const std::string& word) {
        if (in_bone_)
            in_.fail(Status::format, "{} is inside bone {}: 'end' is missing", in_quotes(word),
                     in_quotes(bone().name));
        section_ = word;
    }

    void unit(const std::string& word, std::string_view line) {
        if (word != "angle")
            return;
        const std::string_view value = next_word(line, separators);
        if (!starts_with_ignoring_case(value, "deg") && !starts_with_ignoring_case(value, "rad"))
            in_.fail(Status::format, "the angle unit must be deg or rad, not {}", in_quotes(value));
        sections_.degrees = starts_with_ignoring_case(value, "deg");
    }

    void root(const std::string& word, std::string_view line) {
        if (word == "order")
            sections_.root.dof = channels("root", line);
        else if (word == "axis")
            sections_.root.axis.order = axis_order(next_word(line, separators));
        else if (word == "position")
            sections_.root.direction = vector(word, line);
        else if (word == "orientation")
            sections_.root.axis.angles = vector(word, line);
    }

    /// Ignores keywords such as id, limits and bodymass.
    void bone_data(const std::string& word, std::string_view line) {
        if (word == "begin")
            begin_bone();
        else if (!in_bone_)
            in_.fail(Status::format, "{} is outside begin ... end", in_quotes(word));
        else if (word == "end")
            end_bone();
        else if (word == "name")
            bone().name = bone_name(next_word(line, separators));
        else if (word == "direction")
            bone().direction = vector(word, line);
        else if (word == "length")
            bone().length = number(word, line);
        else if (word == "axis")
            bone_axis(line);
        else if (word == "dof")
            bone_dof(line);
    }

    void begin_bone() {
        if (in_bone_)
            in_.fail(Status::format, "'begin' is inside bone {}: 'end' is missing",
                     in_quotes(bone().name));
        in_bone_ = true;
        sections_.bones.emplace_back();
        bone().line = in_.line_number();
    }

    void end_bone() {
        if (bone().name.empty())
            in_.fail(Status::format, "the bone that begins on line {} has no name", bone().line);
        in_bone_ = false;
    }

    void bone_axis(std::string_view line) {
        bone().axis.angles = vector("axis", line);
        const std::string_view order = next_word(line, separators);
        if (!order.empty())
            bone().axis.order = axis_order(order);
    }

    void bone_dof(std::string_view line) {
        bone().dof = channels(bone().name, line);
        for (const Channel channel : bone().dof)
            if (!is_rotation(channel))
                in_.fail(Status::unsupported,
                         "bone {} has the position channel {}: only the root may translate",
                         in_quotes(bone().name), channel_name(channel));
    }

    std::string bone_name(std::string_view word) const {
        in_.check_name(word);
        return to_lower(word);
    }

    std::vector<Channel> channels(std::string_view bone, std::string_view line) {
        std::vector<Channel> result;
        for (std::string_view word = next_word(line, separators); !word.empty();
             word = next_word(line, separators)) {
            const Channel next = channel(to_lower(word));
            if (!may_follow(next, result))
                in_.fail(Status::format, "bone {} has one {} too many: {}", in_quotes(bone),
                         in_quotes(word), channel_limit);
            result.push_back(next);
        }
        return result;
    }

    Channel channel(const std::string& word) {
        for (int c = 0; c < 6; ++c)
            if (word == channel_name(static_cast<Channel>(c)))
                return static_cast<Channel>(c);
        if (word == "l")
            in_.fail(Status::unsupported, "bones of variable length (dof l) are not supported");
        in_.fail(Status::format, "{} is not one of tx ty tz rx ry rz", in_quotes(word));
    }

    std::array<int, 3> axis_order(std::string_view word) {
        const std::string order = to_lower(word);
        if (order.size() != 3 || order.find_first_not_of("xyz") != order.npos)
            in_.fail(Status::format, "{} is not an order of axes such as XYZ", in_quotes(word));
        return {order[0] - 'x', order[1] - 'x', order[2] - 'x'};
    }

    Vec3 vector(std::string_view keyword, std::string_view& line) {
        Vec3 result{};
        for (double& value : result)
            value = number(keyword, line);
        return result;
    }

    double number(std::string_view keyword, std::string_view& line) {
        const std::string_view word = next_word(line, separators);
        const auto value = parse_number(word);
        if (!value || !std::isfinite(*value))
            in_.fail(value ? Status::not_finite : Status::format,
                     "'{}' needs finite numbers, not {}", keyword, in_quotes(word));
        return *value;
    }

    /// "begin", "end", or a parent and its children.
    void links(const std::string& parent, std::string_view line) {
        if (parent == "begin" || parent == "end")
            return;
        in_.check_name(parent);
        for (std::string_view word = next_word(line, separators); !word.empty();
             word = next_word(line, separators))
            sections_.links.push_back({parent, to_lower(word), in_.line_number()});
    }

    TextCursor& in_;
    AsfSections sections_;
    std::string section_;
    bool in_bone_ = false;
};

} // namespace

AsfSections read_asf_sections(TextCursor& in) {
    return SectionReader(in).read();
}

} // namespace stltsa::clip
