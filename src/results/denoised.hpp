// SPDX-License-Identifier: BSD-3-Clause
// Denoised coordinates, and the parameters of the smooth curve.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "motion/curve/denoise.hpp"
#include "results/fitted.hpp"

namespace stltsa::results {

struct DenoiseOptions {
    std::optional<double> gamma; ///< as in motion::DenoiseOptions
    std::optional<double>
        knot_spacing; ///< seconds, rows if the rate is unknown; empty: by the period
    bool robust = true;
    PeriodSearch search; ///< of coordinates whose period is not known
};

struct Denoised {
    motion::Denoised result;
    motion::DenoiseOptions options;    ///< as used
    std::vector<std::int64_t> lengths; ///< rows that each spline goes through
    Source source;
    PeriodFacts period;                  ///< that the knots rest on
    std::optional<ltsa::Parameters> fit; ///< none: the coordinates were given
    Warnings warnings;                   ///< of that fit
};

/// Throws as motion::denoise().
Denoised denoise(ConstMatrixView coords, std::vector<std::int64_t> lengths,
                 const DenoiseOptions& options, Source source);

/// The coordinates of a fit, a spline for each of its unbroken_lengths().
Denoised denoise(const Fitted& fitted, const DenoiseOptions& options);

} // namespace stltsa::results
