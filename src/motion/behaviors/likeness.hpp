// SPDX-License-Identifier: BSD-3-Clause
// How similar the motions in two ranges of moments are; moderate differences in size and tempo
// change it little.
#pragma once

#include <vector>

#include "motion/behaviors/kernel_features.hpp"

namespace stltsa::motion {

/// What is done in some moments.
struct Description {
    /// Mean kernel features, of length 1: postures and speeds.
    std::vector<double> kernel;
    /// Covariances of the velocities with themselves some time later, of length 1: which parts of
    /// the body move together, and how, but neither how far nor from which phase on.
    std::vector<double> moving;
    std::vector<double> shape; ///< mean features if shapes are described, instead of the others
};

class Describer {
  public:
    explicit Describer(const KernelFeatures& features);
    Description operator()(Rows moments) const;

  private:
    const KernelFeatures& features_;
    Matrix velocities_; ///< of the poses, per moment
};

/// Stretches are one behavior if their likeness is at least this, on the average.
constexpr double same_behavior = 0.65;

/// 0 (different) to 1 (same). Both must be from one Describer.
double likeness(const Description& a, const Description& b);

} // namespace stltsa::motion
