// SPDX-License-Identifier: BSD-3-Clause
// A body seen from the side that shows most of its motion: of a walk, from its right.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "clip/body/heading.hpp"
#include "report/figure/svg.hpp"

namespace stltsa::report {

class SideView {
  public:
    /// Of a clip with a skeleton. `poll`: called periodically, may throw.
    SideView(const clip::Clip& clip, clip::Axis up);

    /// Around the posture of a frame and the ground, in the file's unit, y up.
    Rect box(std::int64_t frame);
    /// `ground`: where the middle of the body stands; `scale`: figure units per unit of the file.
    void draw(Svg& svg, std::int64_t frame, Point ground, double scale);

  private:
    struct Bone {
        std::size_t from, to;
        bool far;
    };

    std::vector<clip::Vec3> body(std::int64_t frame);
    std::vector<Point> posture(std::int64_t frame);
    bool is_head(std::size_t joint) const;

    const clip::Clip& clip_;
    clip::Heading heading_;
    std::size_t up_;
    clip::Pose pose_;
    Point forward_{1, 0};         ///< in the horizontal plane of the body without its yaw
    std::optional<double> floor_; ///< empty: the lowest joint of each frame
    std::vector<Bone> bones_;
    const Bone* head_ = nullptr;
    double head_radius_ = 0; ///< a sixteenth of the body's height
};

} // namespace stltsa::report
