// SPDX-License-Identifier: BSD-3-Clause
// Results as text for people.
#pragma once

#include <string>
#include <vector>

#include <stltsa.hpp>

#include "commands/mapped.hpp"

namespace tool {

std::string info_report(const stltsa::Clip& clip, const std::string& title);
std::string model_report(const stltsa::Model& model, const std::string& title);
std::string dimension_report(const stltsa::Model& model, const std::string& title);
std::string denoising_report(const stltsa::Denoising& denoising, const std::string& title);
std::string mapping_report(const Mapping& mapping, const std::string& title);
/// `pieces`: as typed.
std::string synthesis_report(const stltsa::Synthesis& synthesis,
                             const std::vector<std::string>& pieces);
std::string decomposition_report(const stltsa::Decomposition& decomposition,
                                 const std::string& title);
std::string decomposition_csv(const stltsa::Decomposition& decomposition);

/// Facts that reports share: "90, one frame in 4, 30 per second"; "k = 41 (1.37 s), ...";
/// "positions, 96 columns, y up".
std::string samples_text(const stltsa::Info& result);
std::string neighbors_text(const stltsa::Info& result);
std::string features_text(const stltsa::Info& result);

} // namespace tool
