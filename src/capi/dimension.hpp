// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "capi/options.hpp"
#include "ltsa/dimension.hpp"

namespace stltsa::capi {

/// Tangent dimension of the B whose eigengap is looked at where the caller names none.
inline constexpr int eigengap_tangent_dimension = 2;

ltsa::DimensionOptions dimension_options(const OptionsReader& options);

} // namespace stltsa::capi
