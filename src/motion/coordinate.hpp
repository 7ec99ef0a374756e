// SPDX-License-Identifier: BSD-3-Clause
// Chooses the coordinate that swings once per cycle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ltsa/model.hpp"

namespace stltsa::motion {

/// Half of (autocorrelation at one period - at half a period), samples weighted by their activity
/// level. 1: one swing back and forth per period; near 0: only follows time; negative: two swings
/// per period.
double cyclicity(std::span<const double> coordinate, std::span<const double> level, double period);

struct Coordinate {
    std::size_t model = 0;   ///< index into the models
    std::int64_t column = 0; ///< of its coords
    double cyclicity = -1;
};

/// The most cyclic column of all models, or of the model with `dimension` columns (empty: all). A
/// model with more columns must be clearly better. The models' rows are the samples of `level`.
Coordinate choose_coordinate(const std::vector<ltsa::Model>& models, std::optional<int> dimension,
                             std::span<const double> level, double period);

/// Two columns of one model that form a loop when plotted against each other (paper, Fig. 1).
struct Loop {
    std::size_t model = 0;
    std::int64_t first = 0;
    std::int64_t second = 1;
};

/// The two most cyclic columns of the model whose second column is most cyclic: a second column
/// that swings twice per cycle would form a figure eight. A model with more columns must be clearly
/// better. Empty if all models have one column.
std::optional<Loop> choose_loop(const std::vector<ltsa::Model>& models,
                                std::span<const double> level, double period);

std::vector<double> column_of(ConstMatrixView matrix, std::int64_t column);

} // namespace stltsa::motion
