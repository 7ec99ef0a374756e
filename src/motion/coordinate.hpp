// SPDX-License-Identifier: BSD-3-Clause
// Which coordinate of which embedding swings once per cycle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ltsa/model.hpp"

namespace stltsa::motion {

/// Half of (autocorrelation at one period - at half a period), samples weighted by their activity
/// level. 1: swings to and fro once per period; near 0: only follows time; negative: twice per
/// period.
double cyclicity(std::span<const double> coordinate, std::span<const double> level, double period);

struct Coordinate {
    std::size_t model = 0;   ///< index into the models
    std::int64_t column = 0; ///< of its coords
    double cyclicity = -1;
};

/// The best column of all models, or of the one of `dimension` (0: all); of a model with more
/// columns only if it is clearly better. The models' rows are the samples of `level`.
Coordinate choose_coordinate(const std::vector<ltsa::Model>& models, int dimension,
                             std::span<const double> level, double period);

/// Two columns of one model that make a loop when drawn against each other.
struct Loop {
    std::size_t model = 0;
    std::int64_t first = 0;
    std::int64_t second = 1;
};

/// The two most cyclic columns of the model whose second one is best: where the second swings
/// twice per cycle, they draw an eight. Of models with more columns only where clearly better; none
/// where all models have one column.
std::optional<Loop> choose_loop(const std::vector<ltsa::Model>& models,
                                std::span<const double> level, double period);

std::vector<double> column_of(ConstMatrixView matrix, std::int64_t column);

} // namespace stltsa::motion
