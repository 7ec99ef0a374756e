// SPDX-License-Identifier: BSD-3-Clause
#include "motion/embedding.hpp"

#include <algorithm>

#include "ltsa/fit.hpp"

namespace stltsa::motion {
namespace {

/// Of the tangent spaces that are tried.
constexpr int most_dimensions = 3;
/// One dimension takes three neighbors.
constexpr std::int64_t least_distinct = 4;

std::int64_t distinct_samples(ConstMatrixView samples) {
    std::int64_t distinct = 1;
    for (std::int64_t i = 1; i < samples.rows; ++i)
        if (!std::equal(samples.row(i), samples.row(i) + samples.cols, samples.row(i - 1)))
            ++distinct;
    return distinct;
}

ltsa::Parameters parameters_for(std::int64_t neighbors, std::int64_t distinct,
                                const DecomposeOptions& options) {
    ltsa::Parameters p;
    // Slow frame rates: enough for the tangent spaces at least. Short clips: one neighborhood.
    p.neighbors =
        options.neighbors > 0
            ? options.neighbors
            : std::min(std::max<std::int64_t>(neighbors, most_dimensions + 2), distinct - 1);
    p.window = options.window > 0 ? options.window : p.neighbors;
    // Two dimensions at least, for the loop.
    p.dimension =
        options.dimension > 0
            ? std::max(options.dimension, 2)
            : static_cast<int>(std::clamp<std::int64_t>(p.neighbors - 2, 1, most_dimensions));
    p.mode = options.mode;
    p.exclusion = p.window;
    p.threads = options.threads;
    return p;
}

} // namespace

Embedding embed(ConstMatrixView samples, Span span, std::int64_t neighbors,
                const DecomposeOptions& options, const Progress& progress) {
    if (options.neighbors >= span.count)
        span = {0, samples.rows};
    const ConstMatrixView embedded = samples.block(span.first, span.count);
    const std::int64_t distinct = distinct_samples(embedded);
    Embedding result{span, parameters_for(neighbors, distinct, options), {}, {}};
    if (distinct < least_distinct) {
        result.problem =
            format_text("no curve: only {} of {} samples are distinct", distinct, embedded.rows);
        return result;
    }
    const int least = std::max(options.dimension, 1);
    for (;; --result.parameters.dimension)
        try {
            result.models =
                ltsa::fit_dimensions(embedded, {&span.count, 1}, result.parameters, progress);
            return result;
        } catch (const Error& error) {
            const bool flat = error.status() == Status::degenerate;
            if (flat && result.parameters.dimension > least)
                continue;
            if (!flat && error.status() != Status::disconnected)
                throw;
            result.problem = options.dimension > 0 ? format_text("no curve of {} dimensions: {}",
                                                                 options.dimension, error.what())
                                                   : format_text("no curve: {}", error.what());
            return result;
        }
}

Matrix extended(const Matrix& coords, Span span, std::int64_t samples) {
    Matrix all(samples, coords.cols());
    for (std::int64_t i = 0; i < samples; ++i)
        std::copy_n(coords.row(std::clamp<std::int64_t>(i - span.first, 0, span.count - 1)),
                    coords.cols(), all.row(i));
    return all;
}

} // namespace stltsa::motion
