// SPDX-License-Identifier: BSD-3-Clause
// Makes the borders of cycles lie at the same place of the movement.
#pragma once

#include <vector>

#include "motion/period/signal.hpp"

namespace stltsa::motion {

/// Moves each border towards the mean movement around it, on both sides, and all of
/// them by nothing on the average. The borders stay inside the rows.
std::vector<double> align_borders(const Signal& signal, Rows within, std::vector<double> borders);

} // namespace stltsa::motion
