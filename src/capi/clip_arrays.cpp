// SPDX-License-Identifier: BSD-3-Clause
// Clips from a caller's arrays.
#include "clip/arrays/arrays.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>

#include "capi/boundary/arrays.hpp"
#include "capi/boundary/structs.hpp"
#include "capi/handles.hpp"
#include "capi/options/reader.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/text/text_cursor.hpp"

using namespace stltsa;
using capi::guard;
using capi::required;

namespace {

constexpr bool same(clip::RotationForm form, int value) {
    return static_cast<int>(form) == value;
}
static_assert(same(clip::RotationForm::quaternions, STLTSA_ROTATIONS_QUATERNION) &&
              same(clip::RotationForm::matrices, STLTSA_ROTATIONS_MATRIX) &&
              same(clip::RotationForm::channels, STLTSA_ROTATIONS_CHANNELS));

/// Counts of joints and points that fit any array.
constexpr std::int64_t most_items = 1 << 20;

void check_count(std::int64_t count, const char* what) {
    if (count < 1 || count > most_items)
        fail(Status::argument, "{} {}: from 1 to {} are possible", count, what, most_items);
}

std::string checked_name(const char* name, const char* what, std::int64_t index) {
    constexpr std::size_t longest = 256; // as in files
    if (name == nullptr)
        fail(Status::argument, "{} {} has no name", what, index);
    std::string text(name);
    if (text.size() > longest)
        fail(Status::argument, "the name of {} {} has {} bytes; at most {} are allowed", what,
             index, text.size(), longest);
    return text;
}

/// Sets whether the joint's positions add, which the first of them says.
clip::Channel channel_of(std::string_view word, clip::Joint& joint) {
    const bool added = word.starts_with('+');
    const std::string_view name = added ? word.substr(1) : word;
    for (int c = 0; c < 6; ++c) {
        const auto channel = static_cast<clip::Channel>(c);
        if (clip::channel_name(channel) != name || (added && clip::is_rotation(channel)))
            continue;
        if (!clip::is_rotation(channel)) {
            const bool first = std::ranges::all_of(joint.channels, clip::is_rotation);
            if (!first && joint.adds != added)
                fail(Status::argument,
                     "joint {}: either all positions of a joint add to the offset, or none",
                     clip::in_quotes(joint.name));
            joint.adds = added;
        }
        return channel;
    }
    fail(Status::argument,
         "joint {}: there is no channel {}: expected words of tx ty tz rx ry rz, such as "
         "\"rz rx ry\"",
         clip::in_quotes(joint.name), clip::in_quotes(word));
}

void set_channels(const char* text, clip::Joint& joint) {
    const char* usual = joint.parent < 0 ? "tx ty tz rz rx ry" : "rz rx ry";
    std::string_view words = text != nullptr ? text : joint.end_site ? "" : usual;
    for (std::string_view word = clip::next_word(words); !word.empty();
         word = clip::next_word(words)) {
        const clip::Channel channel = channel_of(word, joint);
        if (!clip::may_follow(channel, joint.channels))
            fail(Status::argument, "joint {}: {}", clip::in_quotes(joint.name),
                 clip::channel_limit);
        joint.channels.push_back(channel);
    }
}

/// `size`: of the caller's struct, which is the step from joint to joint.
clip::Skeleton skeleton_of(const stltsa_joint* joints, std::size_t size, std::int64_t count) {
    check_count(count, "joints");
    if (size < offsetof(stltsa_joint, is_end_site))
        fail(Status::argument, "joint_size is {}; it must be sizeof(stltsa_joint)", size);
    clip::Skeleton skeleton;
    const char* at = reinterpret_cast<const char*>(&required(joints, "joints"));
    for (std::int64_t j = 0; j < count; ++j) {
        stltsa_joint known{};
        std::memcpy(&known, at + static_cast<std::size_t>(j) * size, std::min(size, sizeof known));
        clip::Joint joint;
        joint.name = checked_name(known.name, "joint", j);
        joint.parent = static_cast<int>(std::clamp<std::int64_t>(known.parent, -2, most_items));
        std::copy(std::begin(known.offset), std::end(known.offset), joint.offset.begin());
        joint.end_site = known.is_end_site != 0;
        set_channels(known.channels, joint);
        skeleton.joints.push_back(std::move(joint));
    }
    return skeleton;
}

/// An array that may be left out; no rows then.
capi::InputFrames optional_input(const stltsa_in* in, const char* name) {
    static constexpr stltsa_in none = {nullptr, 0, 0, 0, 0, STLTSA_F64, 0};
    return {in == nullptr || in->data == nullptr ? &none : in, name};
}

} // namespace

std::vector<std::string> stltsa::capi::channel_texts(const clip::Clip& clip) {
    std::vector<std::string> texts;
    if (!clip.skeleton || clip.skeleton->fixed_axes)
        return texts;
    for (const clip::Joint& joint : clip.skeleton->joints) {
        std::string text;
        for (const clip::Channel channel : joint.channels) {
            const bool adds = joint.adds && !clip::is_rotation(channel);
            text += text.empty() ? "" : " ";
            text += adds ? "+" : "";
            text += clip::channel_name(channel);
        }
        texts.push_back(std::move(text));
    }
    return texts;
}

stltsa_status stltsa_clip_from_skeleton(const stltsa_joint* joints, size_t joint_size,
                                        int64_t count, int32_t form, const stltsa_in* rotations,
                                        const stltsa_in* root_positions, double fps,
                                        stltsa_clip** clip) noexcept {
    return guard([&] {
        required(clip, "clip") = nullptr;
        capi::check_rate(fps);
        const capi::InputFrames frames(rotations, "rotations");
        const capi::InputFrames root = optional_input(root_positions, "root_positions");
        auto made = std::make_unique<stltsa_clip>(clip::clip_from_skeleton(
            {skeleton_of(joints, joint_size, count), static_cast<clip::RotationForm>(form),
             frames.view(), root.view(), fps}));
        *clip = made.release();
    });
}

stltsa_status stltsa_clip_from_points(const stltsa_points* points, const stltsa_options* options,
                                      stltsa_clip** clip) noexcept {
    return guard(options, [&] {
        required(clip, "clip") = nullptr;
        const stltsa_points given = capi::taken(points, "points", "stltsa_points");
        if (given.fps != 0)
            capi::check_rate(given.fps);
        const capi::InputFrames positions(&given.positions, "positions");
        const capi::InputFrames confidence = optional_input(&given.confidence, "confidence");
        const capi::InputFrames times = optional_input(&given.times, "times");
        std::vector<std::string> names;
        const std::int64_t count = given.space > 0 ? given.positions.cols / given.space : 0;
        for (std::int64_t p = 0; given.names != nullptr && p < count; ++p)
            names.push_back(checked_name(given.names[p], "point", p));
        auto made = std::make_unique<stltsa_clip>(clip::clip_from_points(
            {positions.view(), given.space, std::move(names), confidence.view(),
             capi::OptionsReader(options).read_options().min_confidence, times.view(), given.fps}));
        *clip = made.release();
    });
}
