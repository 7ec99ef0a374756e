// SPDX-License-Identifier: BSD-3-Clause
// Warnings about an embedding.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ltsa/graph.hpp"
#include "ltsa/model.hpp"

namespace stltsa::ltsa {

/// |Spearman's rank correlation| of the first coordinate of the largest component with time:
/// 1 if the coordinate only follows time. `coords`: distinct frames x d.
double time_correlation(const Graph& graph, const Matrix& coords);

/// Share of consecutive frames of a clip that are closer to each other than two random frames are:
/// about 0.5 for frames in random order; more than 0.87 for each of about 60 recorded motions at 30
/// frames a second, more than 0.75 for each stretch of 40 frames. 1 for fewer than 50 frames.
double share_in_order(const DistinctFrames& frames);
/// The warning that such a share calls for, if it does.
std::optional<Warning> order_warning(double share);

/// All warnings except parts_warning(), because only the caller can name the cut.
Warnings warnings_of(const Graph& graph, const Model& model);

/// `cut`: a name for first_cut(model); empty: no cut. `cut_s`: its time; no_time: unknown.
Warning parts_warning(const Model& model, const std::string& cut, double cut_s);

} // namespace stltsa::ltsa
