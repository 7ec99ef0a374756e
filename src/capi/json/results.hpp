// SPDX-License-Identifier: BSD-3-Clause
// The JSON text of results, one line each, as docs/schema describes it. What does not change the
// result (the number of threads) is left out, so that equal results are equal texts.
#pragma once

#include <string>

#include "results/decomposed.hpp"
#include "results/denoised.hpp"
#include "results/fitted.hpp"
#include "results/synthesized.hpp"

namespace stltsa::capi {

std::string clip_json(const clip::Clip& clip);
std::string model_json(const results::Fitted& fitted);
std::string dimension_json(const results::EstimatedDimension& estimated);
std::string decomposition_json(const results::Decomposed& decomposed);
std::string denoising_json(const results::Denoised& denoised);
/// `clip`: what was made.
std::string synthesis_json(const clip::Clip& clip, const results::Synthesized& synthesized);

} // namespace stltsa::capi
