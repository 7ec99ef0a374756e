// SPDX-License-Identifier: BSD-3-Clause
#include "results/denoised.hpp"

#include <algorithm>
#include <numeric>

#include "base/progress.hpp"
#include "ltsa/frames.hpp"

namespace stltsa::results {
namespace {

/// The source's period; if it was not searched for, the period of the longest clip's coordinates.
PeriodFacts period_of(ConstMatrixView coords, const std::vector<std::int64_t>& lengths,
                      const PeriodSearch& search, const Source& source) {
    const auto longest = std::max_element(lengths.begin(), lengths.end());
    const std::int64_t first = std::accumulate(lengths.begin(), longest, std::int64_t{0});
    const double fps = source.samples.fps;
    if (source.period.longest > 0)
        return source.period;
    return look_for_period(coords.block(first, *longest), fps, range_of(search, fps, *longest));
}

} // namespace

Denoised denoise(ConstMatrixView coords, std::vector<std::int64_t> lengths,
                 const DenoiseOptions& options, Source source) {
    ltsa::check_frames(coords, lengths, "coords");
    const double fps = source.samples.fps;
    Denoised denoised;
    denoised.options = {options.gamma, 0, options.robust};
    if (options.knot_spacing) {
        denoised.options.knot_step = *options.knot_spacing * (fps > 0 ? fps : 1);
    } else {
        report_progress(Stage::denoise, 0);
        denoised.period = period_of(coords, lengths, options.search, source);
        denoised.options.knot_step =
            motion::knot_step_for(rows_of_period(denoised.period, source.samples));
    }
    denoised.result = motion::denoise(coords, lengths, denoised.options);
    denoised.lengths = std::move(lengths);
    denoised.source = std::move(source);
    return denoised;
}

Denoised denoise(const Fitted& fitted, const DenoiseOptions& options) {
    Denoised denoised =
        denoise(fitted.model.coords.view(), unbroken_lengths(fitted.model), options, fitted.source);
    denoised.fit = fitted.model.parameters;
    denoised.warnings = fitted.model.warnings;
    return denoised;
}

} // namespace stltsa::results
