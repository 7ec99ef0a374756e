// SPDX-License-Identifier: BSD-3-Clause
// glTF 2.0 in its binary form (GLB): one node for each joint or point, and an animation.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>

#include "base/checkpoint.hpp"
#include "clip/body/kinematics.hpp"
#include "clip/body/skeleton.hpp"
#include "clip/features/features.hpp"
#include "clip/features/point_names.hpp"
#include "clip/gltf/buffer.hpp"

namespace stltsa::clip {
namespace {

void append(std::vector<float>& to, const Vec3& v) {
    for (const double value : v)
        to.push_back(narrow(value));
}

std::vector<double> as_list(const Vec3& v) {
    return {v.begin(), v.end()};
}

/// The file while it grows. Every list becomes a member of the same name.
class GltfWriter {
  public:
    explicit GltfWriter(const Clip& clip) : clip_(clip) {}

    std::string write() {
        if (clip_.skeleton)
            add_skeleton(*clip_.skeleton);
        else
            add_points();
        return packed(json());
    }

  private:
    // Nodes have the indices of the joints.
    void add_skeleton(const Skeleton& skeleton) {
        add_joints(skeleton);
        const int times = add_times(all_frames());
        const std::vector<std::size_t> begins = channel_begins(skeleton);
        const Matrix turns = rotations(clip_);
        for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
            const auto& channels = skeleton.joints[j].channels;
            if (std::ranges::any_of(channels, is_rotation))
                animate(j, "rotation", times, buffer_.add(4, rotations_of(turns, j)));
            if (!std::ranges::all_of(channels, is_rotation))
                animate(j, "translation", times, buffer_.add(3, places_of(skeleton, j, begins[j])));
        }
        add_skin(skeleton);
    }

    void add_joints(const Skeleton& skeleton) {
        std::vector<std::vector<int>> children(skeleton.joints.size());
        for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
            const int parent = skeleton.joints[j].parent;
            const auto index = static_cast<int>(j);
            if (parent < 0)
                top_.push_back(index);
            else
                children[static_cast<std::size_t>(parent)].push_back(index);
        }
        for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
            const Joint& joint = skeleton.joints[j];
            JsonObject node("name", joint.name, "translation", as_list(joint.offset));
            if (!children[j].empty())
                node.set("children", children[j]);
            nodes_.push_back(node);
        }
    }

    /// x y z w of each frame.
    static std::vector<float> rotations_of(const Matrix& turns, std::size_t joint) {
        std::vector<float> values;
        for (std::int64_t i = 0; i < turns.rows(); ++i) {
            const double* q = turns.row(i) + 4 * joint;
            for (const int component : {1, 2, 3, 0})
                values.push_back(narrow(q[component]));
        }
        return values;
    }

    std::vector<float> places_of(const Skeleton& skeleton, std::size_t joint, std::size_t column) {
        std::vector<float> values;
        for (std::int64_t i = 0; i < clip_.frames(); ++i)
            append(values, joint_translation(skeleton.joints[joint], clip_.values.row(i) + column));
        return values;
    }

    /// Programs make an armature of the joints of a skin. Its resting pose has no rotations. There
    /// is no mesh: the importer of Debian's Blender 3.4 fails at any.
    void add_skin(const Skeleton& skeleton) {
        std::vector<Vec3> rest;
        std::vector<int> joints;
        std::vector<float> inverse_binds;
        for (const Joint& joint : skeleton.joints) {
            const bool is_root = joint.parent < 0;
            rest.push_back(joint.offset +
                           (is_root ? Vec3{} : rest[static_cast<std::size_t>(joint.parent)]));
            joints.push_back(static_cast<int>(joints.size()));
            inverse_binds.insert(inverse_binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
            append(inverse_binds, -1 * rest.back());
            inverse_binds.push_back(1);
        }
        skins_.push_back(JsonObject("joints", joints, "skeleton", top_[0], "inverseBindMatrices",
                                    buffer_.add(16, inverse_binds)));
    }

    void add_points() {
        const std::vector<std::int64_t> all = all_frames();
        int all_times = -1;
        for (std::int64_t first = 0; first < clip_.values.cols(); first += clip_.space) {
            const auto index = nodes_.size();
            top_.push_back(static_cast<int>(index));
            const std::vector<std::int64_t> seen = frames_with(first);
            JsonObject node("name", name_of_point(first));
            if (!seen.empty()) {
                std::vector<float> places;
                for (const std::int64_t i : seen)
                    append(places, place(i, first));
                node.set("translation", as_list(place(seen[0], first)));
                // Most points are seen in all frames, and share their times.
                if (seen == all && all_times < 0)
                    all_times = add_times(all);
                animate(index, "translation", seen == all ? all_times : add_times(seen),
                        buffer_.add(3, places));
            }
            nodes_.push_back(node);
        }
        if (samplers_.empty())
            fail(Status::unsupported, "no point of this clip is seen in any frame");
    }

    std::vector<std::int64_t> all_frames() const {
        std::vector<std::int64_t> frames(static_cast<std::size_t>(clip_.frames()));
        std::iota(frames.begin(), frames.end(), 0);
        return frames;
    }

    /// glTF has no missing values: a point has keys only in the frames in which it is seen.
    std::vector<std::int64_t> frames_with(std::int64_t first) const {
        std::vector<std::int64_t> frames;
        for (std::int64_t i = 0; i < clip_.frames(); ++i)
            if (const Vec3 p = place(i, first);
                !std::isnan(p[0]) && !std::isnan(p[1]) && !std::isnan(p[2]))
                frames.push_back(i);
        return frames;
    }

    Vec3 place(std::int64_t frame, std::int64_t first) const {
        Vec3 result{};
        std::copy_n(clip_.values.row(frame) + first, clip_.space, result.begin());
        return result;
    }

    std::string name_of_point(std::int64_t first) const {
        const auto column = static_cast<std::size_t>(first);
        const std::string_view name = column < clip_.channel_names.size()
                                          ? point_name(clip_.channel_names[column])
                                          : std::string_view();
        return name.empty() ? format_text("point {}", first / clip_.space) : std::string(name);
    }

    int add_times(const std::vector<std::int64_t>& frames) {
        return buffer_.add(1, gltf_times(frames, clip_.fps));
    }

    void animate(std::size_t node, const char* path, int times, int values) {
        checkpoint(work_of_channel * clip_.frames());
        const JsonObject target("node", static_cast<std::int64_t>(node), "path", path);
        channels_.push_back(
            JsonObject("sampler", static_cast<std::int64_t>(samplers_.size()), "target", target));
        samplers_.push_back(
            JsonObject("input", times, "interpolation", "LINEAR", "output", values));
    }

    std::string json() const {
        const std::string stem = std::filesystem::path(clip_.path).stem().string();
        const std::string name = stem.empty() ? "motion" : stem;
        const JsonObject extras("units",
                                "coordinates are those of the clip, neither scaled to "
                                "meters nor turned",
                                "fps", clip_.fps);
        JsonObject file(
            "asset", JsonObject("version", "2.0", "generator", "libstltsa", "extras", extras),
            "scene", 0, "scenes", std::vector<Json>{JsonObject("name", name, "nodes", top_)},
            "nodes", nodes_, "animations",
            std::vector<Json>{
                JsonObject("name", name, "channels", channels_, "samplers", samplers_)});
        if (!skins_.empty())
            file.set("skins", skins_);
        buffer_.describe(file);
        return file.text();
    }

    /// The header and the two chunks (specification, section 4.4).
    std::string packed(std::string text) const {
        text.append((4 - text.size() % 4) % 4, ' ');
        std::string bytes = buffer_.bytes(); // all numbers have four
        const std::size_t size = 12 + 8 + text.size() + 8 + bytes.size();
        if (size > std::numeric_limits<std::uint32_t>::max())
            fail(Status::unsupported,
                 "the clip is too long for a GLB file, which has at most 4 GiB: write stretches "
                 "of it");
        std::string file = "glTF";
        append_word(file, 2);
        append_word(file, size);
        append_word(file, text.size());
        file += "JSON" + text;
        append_word(file, bytes.size());
        file += std::string("BIN\0", 4) + bytes;
        return file;
    }

    static void append_word(std::string& file, std::size_t value) {
        for (int shift = 0; shift < 32; shift += 8)
            file += static_cast<char>(value >> shift & 0xff);
    }

    const Clip& clip_;
    GltfBuffer buffer_;
    std::vector<Json> nodes_, samplers_, channels_, skins_;
    std::vector<int> top_; ///< nodes without a parent
};

} // namespace

std::string format_glb(const Clip& clip) {
    if (!clip.skeleton && clip.space == 0)
        fail(Status::unsupported,
             "a GLB file needs a skeleton or points, but this clip is a bare matrix: name its "
             "columns as coordinates of points (heel_x, heel_y, heel_z), or write .csv or .npy");
    if (!(clip.fps > 0))
        fail(Status::unsupported, "a GLB file needs a frame rate, but that of this clip is "
                                  "unknown: open it with option fps");
    return GltfWriter(clip).write();
}

} // namespace stltsa::clip
