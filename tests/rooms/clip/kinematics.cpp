// SPDX-License-Identifier: BSD-3-Clause
// Compares rotations and positions with products of rotation matrices computed here.
#include "clip/testing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "clip/features/features.hpp"
#include "clip/write.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;

using Matrix3 = std::array<Vec3, 3>;

constexpr Matrix3 identity{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

Matrix3 product(const Matrix3& a, const Matrix3& b) {
    Matrix3 c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k)
                c[i][j] += a[i][k] * b[k][j];
    return c;
}

Vec3 product(const Matrix3& a, const Vec3& v) {
    Vec3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            result[i] += a[i][k] * v[k];
    return result;
}

Matrix3 turn(char axis, double degrees) {
    const double c = std::cos(degrees * std::numbers::pi / 180);
    const double s = std::sin(degrees * std::numbers::pi / 180);
    switch (axis) {
    case 'X':
        return {Vec3{1, 0, 0}, Vec3{0, c, -s}, Vec3{0, s, c}};
    case 'Y':
        return {Vec3{c, 0, s}, Vec3{0, 1, 0}, Vec3{-s, 0, c}};
    default:
        return {Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}};
    }
}

Matrix3 matrix_of(const double* q) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
            Vec3{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
            Vec3{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

void check_near(const Matrix3& a, const Matrix3& b) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            ASSERT_NEAR(a[i][j], b[i][j], 1e-14);
}

/// A root without channels, a joint at (1, 2, 3) that turns in `order`, and its end at (4, 5, 6).
Clip one_joint(const std::string& order, const std::vector<double>& angles) {
    std::string text = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nJOINT j\n{\nOFFSET 1 2 3\nCHANNELS " +
                       std::to_string(order.size());
    for (const char axis : order)
        text += std::string(" ") + axis + "rotation";
    text += "\nEnd Site\n{\nOFFSET 4 5 6\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n";
    for (const double angle : angles)
        text += stltsa::format_text("{} ", angle);
    return parse(text, Format::bvh);
}

void check_order(const std::string& order) {
    Random random;
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<double> angles;
        Matrix3 expected = identity;
        for (const char axis : order) {
            angles.push_back(400 * random.next());
            expected = product(expected, turn(axis, angles.back()));
        }
        const Clip clip = one_joint(order, angles);
        check_near(matrix_of(rotations(clip).data() + 4), expected);
        const Vec3 end = product(expected, Vec3{4, 5, 6});
        for (std::size_t i = 0; i < 3; ++i)
            ASSERT_NEAR(positions(clip)(0, 6 + static_cast<std::int64_t>(i)),
                        static_cast<double>(i + 1) + end[i], 1e-13);
    }
}

void every_order_of_rotations(void**) {
    for (const char a : {'X', 'Y', 'Z'}) {
        check_order({a});
        for (const char b : {'X', 'Y', 'Z'}) {
            check_order({a, b});
            for (const char c : {'X', 'Y', 'Z'})
                check_order({a, b, c});
        }
    }
}

void chains_multiply_from_the_root(void**) {
    const Clip clip = parse(small_bvh, Format::bvh);
    // Frame 1: 2 3 4 10 20 30 40 50 60 70, all Z X Y.
    const Matrix3 hips = product(product(turn('Z', 10), turn('X', 20)), turn('Y', 30));
    const Matrix3 leg = product(product(turn('Z', 40), turn('X', 50)), turn('Y', 60));
    const Matrix3 arm = turn('X', 70);
    const std::array<Vec3, 5> relative{Vec3{0, 0, 0}, Vec3{1, -2, 0.5},
                                       product(leg, Vec3{0, -4, 0}), Vec3{3, 5, 0},
                                       product(arm, Vec3{6, 0, 0})};
    const std::array<std::size_t, 5> parents{0, 0, 1, 0, 3};
    const stltsa::Matrix at = positions(clip);
    assert_int_equal(at.cols(), 15);
    for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            Vec3 inside = relative[j];
            if (j == 2 || j == 4)
                for (std::size_t k = 0; k < 3; ++k)
                    inside[k] += relative[parents[j]][k];
            ASSERT_NEAR(at(1, static_cast<std::int64_t>(3 * j + i)),
                        product(hips, inside)[i] + static_cast<double>(i + 2), 1e-13);
        }
}

void channels_interleaved_with_positions(void**) {
    const std::string text = "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 6 Yrotation Zposition "
                             "Xrotation Xposition Zrotation Yposition\nEnd Site\n{\nOFFSET 0 1 0\n"
                             "}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n10 3 20 1 30 2\n";
    const Clip clip = parse(text, Format::bvh);
    const Matrix3 expected = product(product(turn('Y', 10), turn('X', 20)), turn('Z', 30));
    check_near(matrix_of(rotations(clip).data()), expected);
    const stltsa::Matrix at = positions(clip);
    for (std::int64_t i = 0; i < 3; ++i)
        ASSERT_NEAR(at(0, i), static_cast<double>(i + 1), 0);
}

void rotations_keep_their_sign(void**) {
    std::string text =
        "HIERARCHY\nROOT r\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\nEnd Site\n{\nOFFSET "
        "0 1 0\n}\n}\nMOTION\nFrames: 73\nFrame Time: 1\n";
    for (int i = 0; i < 73; ++i) // two whole turns, with angles that jump by 360
        text += stltsa::format_text("{}\n", i % 36 * 20 - (i % 36 > 9 ? 360 : 0));
    const stltsa::Matrix q = rotations(parse(text, Format::bvh));
    assert_int_equal(q.cols(), 8);
    assert_true(q(0, 0) == 1 && q(5, 4) == 1 && q(5, 5) == 0); // the end site does not turn
    for (std::int64_t i = 1; i < q.rows(); ++i) {
        double dot = 0;
        for (std::int64_t c = 0; c < 4; ++c)
            dot += q(i, c) * q(i - 1, c);
        ASSERT_NEAR(dot, std::cos(10 * std::numbers::pi / 180), 1e-12);
    }
}

/// A random hierarchy, its text, and where its joints are in each frame: the positions of the root
/// replace its OFFSET; those of the other joints add to theirs, or replace them.
struct RandomBody {
    static constexpr int frames = 3;

    Random random = {};
    bool adds = false;
    std::string hierarchy = {};
    std::array<std::string, frames> rows = {};
    std::array<std::vector<Vec3>, frames> places = {};
    bool below_root_moves = false;

    /// Every joint but the root has children while there are fewer than `most`.
    void joint(int depth, const std::array<Matrix3, frames>& parents,
               const std::array<Vec3, frames>& origins);
    std::string text() const {
        std::string all = hierarchy + "MOTION\nFrames: 3\nFrame Time: 0.01\n";
        for (const std::string& row : rows)
            all += row + "\n";
        return all;
    }
};

void RandomBody::joint(int depth, const std::array<Matrix3, frames>& parents,
                       const std::array<Vec3, frames>& origins) {
    const bool is_root = depth == 0;
    const Vec3 offset{50 + 50 * random.next(), 90 * random.next(), 70 * random.next()};
    hierarchy += stltsa::format_text("{} j{}\n{{\nOFFSET {} {} {}\n", is_root ? "ROOT" : "JOINT",
                                     places[0].size(), offset[0], offset[1], offset[2]);
    std::vector<std::string> channels;
    std::string axes = "XYZ";
    for (int i = 0; i < 3; ++i) // positions of some axes
        if (random.below(2) == 0)
            channels.push_back(std::string(1, axes[static_cast<std::size_t>(i)]) + "position");
    below_root_moves = below_root_moves || (!is_root && !channels.empty());
    for (std::uint64_t i = is_root ? 1 : random.below(4); i > 0; --i) // at any place among them
        channels.insert(channels.begin() +
                            static_cast<std::ptrdiff_t>(random.below(channels.size() + 1)),
                        std::string(1, axes[random.below(3)]) + "rotation");
    hierarchy += stltsa::format_text("CHANNELS {}", channels.size());
    for (const std::string& channel : channels)
        hierarchy += " " + channel;
    hierarchy += "\n";
    std::array<Matrix3, frames> worlds = parents;
    std::array<Vec3, frames> at{};
    for (std::size_t f = 0; f < frames; ++f) {
        Vec3 place = offset;
        for (const std::string& channel : channels) {
            const auto axis = static_cast<std::size_t>(channel[0] - 'X');
            const bool turns = channel.ends_with("rotation");
            double value = turns ? 180 * random.next() : 0.1 * offset[axis] * random.next();
            if (turns)
                worlds[f] = product(worlds[f], turn(channel[0], value));
            else if (is_root || !adds)
                place[axis] = value += offset[axis];
            else
                place[axis] += value;
            rows[f] += stltsa::format_text("{} ", value);
        }
        place = product(parents[f], place);
        for (std::size_t i = 0; i < 3; ++i)
            at[f][i] = origins[f][i] + place[i];
        places[f].push_back(at[f]);
    }
    for (std::uint64_t i = depth < 4 ? (is_root ? 2 : random.below(3)) : 0; i > 0; --i)
        joint(depth + 1, worlds, at);
    hierarchy += "}\n";
}

/// As read, and as read from what is saved.
void positions_mean_the_same_in_every_file(void**) {
    int adding = 0;
    Random random;
    for (int repeat = 0; repeat < 60; ++repeat) {
        RandomBody body{.random = random, .adds = repeat % 2 == 0, .hierarchy = "HIERARCHY\n"};
        body.joint(0, {identity, identity, identity}, {});
        random = body.random;
        const Clip clip = parse(body.text(), Format::bvh);
        adding += body.adds && body.below_root_moves ? 1 : 0;
        const TemporaryFolder folder;
        write(clip, folder.path("a.bvh"));
        const Clip again = read(folder.path("a.bvh"), {});
        for (const stltsa::Matrix& found : {positions(clip), positions(again)})
            for (std::size_t f = 0; f < RandomBody::frames; ++f)
                for (std::size_t j = 0; j < body.places[f].size(); ++j)
                    for (std::size_t i = 0; i < 3; ++i)
                        ASSERT_NEAR(found(static_cast<std::int64_t>(f),
                                          static_cast<std::int64_t>(3 * j + i)),
                                    body.places[f][j][i], 1e-9);
    }
    assert_true(adding > 20);
}

void bare_matrices_have_no_pose(void**) {
    const Clip clip = parse("1,2\n3,4\n", Format::csv);
    ASSERT_FAILS(Status::unsupported, "positions need a skeleton", positions(clip));
    ASSERT_FAILS(Status::unsupported, "rotations need a skeleton", rotations(clip));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(every_order_of_rotations),
        cmocka_unit_test(chains_multiply_from_the_root),
        cmocka_unit_test(channels_interleaved_with_positions),
        cmocka_unit_test(rotations_keep_their_sign),
        cmocka_unit_test(positions_mean_the_same_in_every_file),
        cmocka_unit_test(bare_matrices_have_no_pose),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
