// SPDX-License-Identifier: BSD-3-Clause
// Results as text for people, made from the JSON objects, so that the two cannot disagree.
#pragma once

#include <string>
#include <vector>

#include "json.hpp"

namespace tool {

std::string info_report(const Json& clip, const std::string& title, bool colors);
std::string model_report(const Json& model, const std::string& title, bool colors);
std::string dimension_report(const Json& dimension, const std::string& title, bool colors);
std::string denoising_report(const Json& denoising, const std::string& title, bool colors);
std::string mapping_report(const Json& mapping, const std::string& title, bool colors);
/// `pieces`: as the user wrote them.
std::string synthesis_report(const Json& synthesis, const std::vector<std::string>& pieces,
                             bool colors);
std::string decomposition_report(const Json& decomposition, const std::string& title, bool colors);

/// "3 cycles of 1.10 s", or why there is none.
std::string decomposition_summary(const Json& decomposition);

/// "528 frames, 4.40 s, from 1 piece with 3 seams"
std::string synthesis_summary(const Json& synthesis);
/// A piece as the user wrote it, without the folder of its clip.
std::string piece_name(const std::string& piece);

/// "12 of 422 points moved towards a smooth curve"
std::string denoising_summary(const Json& denoising);
/// "every 3.3 samples (0.110 s), robust fit"
std::string knots_text(const Json& denoising);

/// What results share: "40 samples (1.33 s)", "positions, 96 columns, up axis y" and so on.
std::string samples_text(const Json& result);
std::string neighbors_text(const Json& result);
std::string features_text(const Json& result);

} // namespace tool
