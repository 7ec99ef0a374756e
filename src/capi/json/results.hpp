// SPDX-License-Identifier: BSD-3-Clause
// Results as JSON, one line each (docs/schema). Options that do not change the result, such as the
// number of threads, are omitted, so that equal results give equal texts.
#pragma once

#include <string>

#include "results/compared.hpp"
#include "results/decomposed.hpp"
#include "results/denoised.hpp"
#include "results/fitted.hpp"
#include "results/synthesized.hpp"

namespace stltsa::capi {

std::string clip_json(const clip::Clip& clip);
std::string model_json(const results::Fitted& fitted);
std::string decomposition_json(const results::Decomposed& decomposed);
std::string comparison_json(const stltsa_comparison& comparison);
std::string denoising_json(const results::Denoised& denoised);
/// `clip`: the new clip.
std::string synthesis_json(const clip::Clip& clip, const results::Synthesized& synthesized);

} // namespace stltsa::capi
