// SPDX-License-Identifier: BSD-3-Clause
// A body seen from its right: its postures projected onto the plane in which it walks or, if it
// does not travel, onto its plane of symmetry. Needs no joint names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <stltsa.hpp>

#include "plot/svg.hpp"

namespace tool::plot {

struct Joint {
    std::string name;
    std::int64_t parent = -1;
};

/// A skeleton and its motion, from the library.
struct Bodies {
    std::vector<Joint> joints; ///< parents first
    stltsa::Matrix positions;  ///< frames x (3 * joints), world
    stltsa::Matrix rotations;  ///< frames x (4 * joints), local, w x y z
    int up = 1;                ///< 0, 1, 2: x, y, z
};

enum class Depth { far, middle, near };

struct Bone {
    std::size_t from = 0;
    std::size_t to = 0;
    Depth depth = Depth::middle;
};

/// A disk around the middle of a bone that begins or ends at a joint with "head" in its name.
struct Head {
    std::size_t from = 0;
    std::size_t to = 0;
    double radius = 0; ///< in the file's unit: a sixteenth of the body's height
};

class SideView {
  public:
    explicit SideView(Bodies bodies);

    /// One point per joint: x forward of the root, y up from the ground, in the file's unit.
    std::vector<Point> posture(std::int64_t frame) const;
    const std::vector<Bone>& bones() const { return bones_; }
    /// The head, if a joint has "head" in its name.
    const std::optional<Head>& head() const { return head_; }
    std::int64_t frames() const { return bodies_.positions.rows; }

  private:
    struct Body {
        double forward, right, height;
    };

    double coordinate(std::int64_t frame, std::size_t joint, int axis) const;
    Body body_point(std::int64_t frame, std::size_t joint) const;
    std::vector<Body> mean_posture() const;
    void find_forward();
    std::optional<Point> direction_of_travel(double body_height) const;
    Point direction_of_toes(const std::vector<Body>& mean) const;
    void find_ground();
    void find_bones();
    void find_head();

    Bodies bodies_;
    std::vector<Point> yaw_;     ///< cosine and sine of the root's yaw per frame
    Point forward_{1, 0};        ///< in the horizontal plane of the un-yawed body
    std::vector<double> ground_; ///< height of the ground per frame
    std::vector<Bone> bones_;
    std::optional<Head> head_;
};

} // namespace tool::plot
