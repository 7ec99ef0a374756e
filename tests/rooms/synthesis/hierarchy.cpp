// SPDX-License-Identifier: BSD-3-Clause
// Decides whether two clips show the same body.
#include "synthesis/hierarchy.hpp"
#include "clip/testing.hpp"
#include "synthesis/testing.hpp"

using namespace synthesis_testing;
using stltsa::Status;
using stltsa::synthesis::check_same_body;

namespace {

/// The walker with one joint changed.
template <class Change>
Clip changed(Change change) {
    Clip clip = walking({});
    change(clip.skeleton->joints);
    return clip;
}

Clip with_longer_leg(double factor) {
    return changed([=](auto& joints) { joints[left_foot].offset[1] *= factor; });
}

void the_same_body_has_no_difference(void**) {
    assert_string_equal(check_same_body(walking({}), walking({}), "other").c_str(), "");
}

void offsets_may_differ_by_one_percent(void**) {
    const Clip clip = walking({});
    const std::string name = "a toe";
    const Clip near = changed([&](auto& joints) {
        joints[left_foot].offset[1] *= 1.009;
        joints[left_foot].name = name;
    });
    Clip named = clip;
    named.skeleton->joints[left_foot].name = name;
    assert_string_equal(check_same_body(named, near, "other").c_str(), name.c_str());
    for (const double factor : {1.011, 0.989, 1.5, -1.0})
        ASSERT_FAILS(Status::unsupported, "1 %",
                     check_same_body(clip, with_longer_leg(factor), "other"));
}

/// The offset of a root with position channels is ignored; a tiny bone may differ by rounding.
void offsets_without_information(void**) {
    const Clip clip = walking({});
    const Clip moved = changed([](auto& joints) { joints[0].offset = {1, 2, 3}; });
    assert_string_equal(check_same_body(clip, moved, "other").c_str(), "");
    Clip tiny = clip;
    tiny.skeleton->joints[2].offset = {0, 0.001, 0};
    Clip rounded = clip;
    rounded.skeleton->joints[2].offset = {0, 0.002, 0};
    check_same_body(tiny, rounded, "other");
}

/// Hips that travel below a static root are placed by their positions, whatever their offset.
void offsets_of_hips_that_travel_below_a_static_root(void**) {
    using namespace stltsa::clip;
    const auto traveling = [](const Vec3& hips, bool add) {
        Clip clip = walking({});
        std::vector<Joint>& joints = clip.skeleton->joints;
        for (Joint& joint : joints)
            ++joint.parent;
        joints[0].offset = hips;
        joints.emplace(joints.begin());
        joints[1].adds = add;
        return clip;
    };
    const Vec3 here{0, 90, -450};
    const Vec3 there{9, 80, 0};
    assert_string_equal(
        check_same_body(traveling(here, false), traveling(there, false), "other").c_str(), "");
    ASSERT_FAILS(Status::unsupported, "1 %",
                 check_same_body(traveling(here, true), traveling(there, true), "other"));
}

/// Positions of a limb only move its joint about; its offset is a bone of the body.
void offsets_of_limbs_with_positions_count(void**) {
    using stltsa::clip::Channel;
    const auto positioned = [](double factor) {
        return changed([factor](auto& joints) {
            auto& channels = joints[left_foot].channels;
            channels.insert(channels.begin(), {Channel::tx, Channel::ty, Channel::tz});
            joints[left_foot].offset[1] *= factor;
        });
    };
    assert_string_equal(check_same_body(positioned(1), positioned(1), "other").c_str(), "");
    ASSERT_FAILS(Status::unsupported, "1 %",
                 check_same_body(positioned(1), positioned(1.5), "other"));
}

void other_bodies_are_refused(void**) {
    const Clip clip = walking({});
    const auto refused = [&](const char* word, const Clip& other) {
        ASSERT_FAILS(Status::unsupported, word, check_same_body(clip, other, "other.bvh"));
    };
    refused("\"Kopf\"", changed([](auto& joints) { joints[1].name = "Kopf"; }));
    refused("different parent", changed([](auto& joints) { joints[7].parent = 1; }));
    refused("different channels",
            changed([](auto& joints) { std::swap(joints[1].channels[0], joints[1].channels[1]); }));
    refused("different channels", changed([](auto& joints) {
                joints[1].axis = {std::sqrt(0.5), std::sqrt(0.5), 0, 0};
            }));
    refused("different channels", changed([](auto& joints) { joints[0].adds = true; }));
    refused("has 9 joints", changed([](auto& joints) { joints.pop_back(); }));
    Clip fixed = clip;
    fixed.skeleton->fixed_axes = true;
    refused("different format", fixed);
    refused("other.bvh", fixed);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_same_body_has_no_difference),
        cmocka_unit_test(offsets_may_differ_by_one_percent),
        cmocka_unit_test(offsets_without_information),
        cmocka_unit_test(offsets_of_hips_that_travel_below_a_static_root),
        cmocka_unit_test(offsets_of_limbs_with_positions_count),
        cmocka_unit_test(other_bodies_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
