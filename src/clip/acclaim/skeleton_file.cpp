// SPDX-License-Identifier: BSD-3-Clause
#include "clip/acclaim/skeleton_file.hpp"

#include <unordered_map>

#include "clip/acclaim/bones.hpp"
#include "clip/body/kinematics.hpp"

namespace stltsa::clip {
namespace {

constexpr std::size_t most_bones = 2048;

/// C of "local rotation = C M C^-1": rotations about the fixed axes in their order.
Quaternion bone_axis(const AsfAxis& axis, bool degrees) {
    Quaternion product;
    for (const int a : axis.order) {
        const double angle = axis.angles[static_cast<std::size_t>(a)];
        product = axis_rotation(a, degrees ? to_radians(angle) : angle) * product;
    }
    return product;
}

/// From the parent end of a bone to its other end.
Vec3 bone_vector(const AsfBone& bone) {
    const double size = norm(bone.direction);
    return size > 0 ? (bone.length / size) * bone.direction : Vec3{};
}

/// Orders the bones depth first, parents before children, as in the hierarchy section.
class SkeletonBuilder {
  public:
    SkeletonBuilder(const TextCursor& in, const AsfSections& sections)
        : in_(in), sections_(sections) {}

    Skeleton build() {
        index_bones();
        connect();
        skeleton_.fixed_axes = true;
        add_bones();
        return std::move(skeleton_);
    }

  private:
    static constexpr std::size_t root = 0; // bone i of the file has number i + 1

    const AsfBone& bone(std::size_t number) const {
        return number == root ? sections_.root : sections_.bones[number - 1];
    }

    void index_bones() {
        const std::size_t count = sections_.bones.size();
        if (count == 0)
            in_.fail(Status::format, "no bones: the section :bonedata is missing or empty");
        if (sections_.root.dof.empty())
            in_.fail(Status::format, "the section :root has no 'order'");
        if (count > most_bones)
            in_.fail(Status::unsupported, "more than {} bones", most_bones);
        for (std::size_t number = 0; number <= count; ++number)
            if (!numbers_.emplace(bone(number).name, number).second)
                in_.fail_at(bone(number).line, Status::format, "a second bone named {}",
                            in_quotes(bone(number).name));
        children_.resize(count + 1);
        has_parent_.resize(count + 1);
    }

    std::size_t number_of(const std::string& name, std::int64_t line) const {
        const auto found = numbers_.find(name);
        if (found == numbers_.end())
            in_.fail_at(line, Status::format, "{} is not among the bones of :bonedata",
                        in_quotes(name));
        return found->second;
    }

    void connect() {
        for (const AsfLink& link : sections_.links) {
            const std::size_t parent = number_of(link.parent, link.line);
            const std::size_t child = number_of(link.child, link.line);
            if (child == root || has_parent_[child])
                in_.fail_at(link.line, Status::format, "{} already has a parent",
                            in_quotes(link.child));
            has_parent_[child] = true;
            children_[parent].push_back(child);
        }
        for (std::size_t number = 1; number < has_parent_.size(); ++number)
            if (!has_parent_[number])
                in_.fail_at(bone(number).line, Status::format,
                            "bone {} is missing from the section :hierarchy",
                            in_quotes(bone(number).name));
    }

    void add_bones() {
        struct Pending {
            std::size_t number;
            int parent; ///< joint index
        };
        std::vector<Pending> pending{{root, -1}};
        std::size_t added = 0;
        for (; !pending.empty(); ++added) {
            const Pending next = pending.back();
            pending.pop_back();
            const auto joint = static_cast<int>(skeleton_.joints.size());
            add_joint(next.number, next.parent);
            const std::vector<std::size_t>& children = children_[next.number];
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                pending.push_back({*child, joint});
            if (children.empty())
                add_end_site(bone(next.number), joint);
            ends_.resize(skeleton_.joints.size());
            ends_[static_cast<std::size_t>(joint)] =
                next.number == root ? Vec3{} : bone_vector(bone(next.number));
        }
        // In a cycle of bones each has a parent, but none is connected to the root.
        if (added != has_parent_.size())
            in_.fail(Status::format, "the section :hierarchy does not connect all bones to root");
    }

    void add_joint(std::size_t number, int parent) {
        const AsfBone& from = bone(number);
        Joint joint;
        joint.name = from.name;
        joint.parent = parent;
        joint.channels = from.dof;
        joint.adds = true;
        joint.axis = bone_axis(from.axis, sections_.degrees);
        joint.offset = number == root ? from.direction : ends_[static_cast<std::size_t>(parent)];
        skeleton_.joints.push_back(std::move(joint));
    }

    void add_end_site(const AsfBone& from, int parent) {
        Joint joint;
        joint.name = from.name + " end";
        joint.parent = parent;
        joint.offset = bone_vector(from);
        joint.end_site = true;
        skeleton_.joints.push_back(std::move(joint));
    }

    const TextCursor& in_;
    const AsfSections& sections_;
    Skeleton skeleton_;
    std::unordered_map<std::string, std::size_t> numbers_;
    std::vector<std::vector<std::size_t>> children_;
    std::vector<bool> has_parent_;
    std::vector<Vec3> ends_; ///< of the bone of each joint
};

} // namespace

AsfFile parse_asf(std::string_view bytes, const std::string& name) {
    TextCursor in(bytes, name);
    const AsfSections sections = read_asf_sections(in);
    return {SkeletonBuilder(in, sections).build(), sections.degrees};
}

} // namespace stltsa::clip
