// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/phase_curve.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"
#include "ltsa/embed.hpp"
#include "motion/curve/statistics.hpp"
#include "motion/cycles/least_squares.hpp"

namespace stltsa::motion {
namespace {

/// 1.2 periods, as a fit chooses (motion/period/choose_neighbors.cpp).
constexpr std::int64_t neighbors = 29;
constexpr std::int64_t chunk = 12 * samples_per_period;
constexpr std::int64_t overlap = samples_per_period;
/// The last chunk absorbs what is shorter than this beyond it.
constexpr std::int64_t least_rest = 6 * samples_per_period;
constexpr std::int64_t min_samples = samples_per_period;
constexpr int most_dimensions = 3;
/// A view without slow sway is tried if the cyclicity is below this, and must be better by that.
constexpr double good_cyclicity = 0.85;
constexpr double clearly_better = 0.1;
constexpr double slow_periods = 0.75;
/// A chunk continues the first if its coordinate correlates so much with the mean cycle there.
constexpr double least_correlation = 0.8;
/// Of dimensions, the next one must be better by this.
constexpr double slightly_better = 0.02;

using Values = std::vector<double>;

double cyclicity_of(std::span<const double> curve) {
    return cyclicity(curve, samples_per_period);
}

/// The two most cyclic coordinates of one embedding.
struct Pair {
    Values first, second; ///< the second is empty in one dimension
    int column = 0;       ///< of the first, 1-based
    double cyclicity = 0; ///< of the first
};

Pair most_cyclic(const Matrix& coords) {
    std::vector<std::pair<double, std::int64_t>> order;
    for (std::int64_t c = 0; c < coords.cols(); ++c)
        order.emplace_back(-cyclicity_of(column_of(coords.view(), c)), c);
    std::sort(order.begin(), order.end());
    Pair pair;
    pair.first = column_of(coords.view(), order[0].second);
    pair.column = static_cast<int>(order[0].second) + 1;
    pair.cyclicity = -order[0].first;
    if (order.size() > 1)
        pair.second = column_of(coords.view(), order[1].second);
    return pair;
}

struct Embedding {
    std::vector<Pair> pairs; ///< by dimension
    std::vector<ltsa::Model> fits;
};

/// In 1 to 3 dimensions; fewer if the samples do not vary in so many directions.
Embedding embed_chunk(ConstMatrixView samples) {
    ltsa::Parameters parameters;
    parameters.neighbors = std::min(neighbors, samples.rows - 1);
    parameters.window = parameters.neighbors;
    parameters.dimension = static_cast<int>(std::min<std::int64_t>(most_dimensions, samples.cols));
    Embedding result;
    try {
        const ltsa::Graph graph = ltsa::build_graph(samples, {&samples.rows, 1}, parameters);
        if (graph.components.count > 1)
            return result;
        const int last = std::min(parameters.dimension, ltsa::varying_directions(graph));
        for (int d = 1; d <= last; ++d) {
            result.fits.push_back(ltsa::embed(graph, d, ltsa::eigenvalues_of_fit(d)));
            result.pairs.push_back(most_cyclic(result.fits.back().coords));
            result.fits.back().coords = Matrix();
            // A third one moved no border of 88 of 90 recordings by 1 us, two by 0.3 ms.
            if (d > 1 && result.pairs.back().cyclicity >= good_cyclicity)
                break;
        }
    } catch (const Error& error) {
        if (error.status() != Status::degenerate && error.status() != Status::disconnected &&
            error.status() != Status::too_few_frames)
            throw;
    }
    return result;
}

/// Least squares of `target` on 1, first and second over its length, evaluated on all samples.
Values turned(const Pair& pair, std::span<const double> target) {
    const auto n = static_cast<std::int64_t>(target.size());
    const std::int64_t columns = pair.second.empty() ? 2 : 3;
    const auto row = [&](std::size_t i, double* values) {
        values[0] = 1;
        values[1] = pair.first[i];
        if (columns > 2)
            values[2] = pair.second[i];
    };
    Matrix a(n, columns);
    for (std::int64_t i = 0; i < n; ++i)
        row(static_cast<std::size_t>(i), a.row(i));
    const Values x = least_squares(a.view(), target, 0);
    Values result;
    double values[3];
    for (std::size_t i = 0; i < pair.first.size(); ++i) {
        row(i, values);
        result.push_back(dot(values, x.data(), columns));
    }
    return result;
}

struct Choice {
    Values curve;
    double correlation = 0;
    double cyclicity = 0;
};

/// The curve a quarter of a period earlier; in the first quarter, the negated curve half a period
/// later.
Values earlier_curve(const Values& curve, std::size_t quarter) {
    Values earlier;
    for (std::size_t i = 0; i < curve.size(); ++i)
        earlier.push_back(i >= quarter                 ? curve[i - quarter]
                          : i + quarter < curve.size() ? -curve[i + quarter]
                                                       : 0);
    return earlier;
}

/// The coordinate that is most like the curve a quarter of a period earlier, so that the loop of
/// the two runs in the same direction in every chunk; if there is none, that earlier curve itself.
Values partner_of(const std::vector<Pair>& pairs, const Values& curve) {
    const Values earlier = earlier_curve(curve, samples_per_period / 4);
    Values best = earlier;
    double most = least_correlation;
    for (const Pair& pair : pairs) {
        if (pair.second.empty())
            continue;
        Values partner = turned(pair, earlier);
        if (const double like = correlation(partner, earlier); like > most) {
            most = like;
            best = std::move(partner);
        }
    }
    return best;
}

/// Of the embeddings, the one whose turned coordinate is most like the target and most cyclic.
Choice best_turn(const std::vector<Pair>& pairs, std::span<const double> target) {
    Choice best;
    double best_score = -9;
    for (const Pair& pair : pairs) {
        Values curve = turned(pair, target);
        const double like = correlation(std::span(curve).first(target.size()), target);
        const double cyclic = cyclicity_of(curve);
        if (like + cyclic <= best_score + slightly_better)
            continue;
        best_score = like + cyclic;
        best = {std::move(curve), like, cyclic};
    }
    return best;
}

/// The simplest embedding whose coordinate is about as cyclic as any.
std::size_t simplest(const std::vector<Pair>& pairs) {
    std::size_t chosen = 0;
    for (std::size_t i = 1; i < pairs.size(); ++i)
        if (pairs[i].cyclicity > pairs[chosen].cyclicity + clearly_better)
            chosen = i;
    return chosen;
}

/// First samples of the chunks.
std::vector<std::int64_t> chunk_starts(std::int64_t samples) {
    std::vector<std::int64_t> starts{0};
    while (starts.back() + chunk < samples)
        starts.push_back(starts.back() + chunk - overlap);
    if (starts.size() > 1 && samples - starts.back() < least_rest)
        starts.pop_back();
    return starts;
}

/// The mean of a curve over its periods, repeated: chunks begin at multiples of a period.
Values repeated_mean(std::span<const double> curve, std::int64_t samples) {
    constexpr auto period = static_cast<std::size_t>(samples_per_period);
    Values sums(period), counts(period), mean;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        sums[i % period] += curve[i];
        counts[i % period] += 1;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(samples); ++i)
        mean.push_back(sums[i % period] / counts[i % period]);
    return mean;
}

/// Traces the curve through the chunks of one view of the samples, which are at these places.
PhaseCurve trace_view(ConstMatrixView samples, const Signal& signal, const Values& places) {
    PhaseCurve result;
    result.curve.assign(static_cast<std::size_t>(samples.rows), 0);
    result.partner = result.curve;
    const auto starts = chunk_starts(samples.rows);
    Rows first{0, 0}; // of the chunk that the others continue: the first one with an embedding
    for (std::size_t c = 0; c < starts.size(); ++c) {
        const auto begin = static_cast<std::size_t>(starts[c]);
        const std::int64_t end = c + 1 == starts.size() ? samples.rows : starts[c] + chunk;
        report_row(signal, places[begin]);
        Embedding embedded = embed_chunk(samples.block(starts[c], end - starts[c]));
        result.cyclicity.push_back(0);
        if (embedded.pairs.empty())
            continue;
        const std::size_t own = simplest(embedded.pairs);
        Choice chosen{embedded.pairs[own].first, 0, embedded.pairs[own].cyclicity};
        if (first.end > 0) {
            const Values mean = repeated_mean(std::span(result.curve)
                                                  .subspan(static_cast<std::size_t>(first.begin),
                                                           static_cast<std::size_t>(first.count())),
                                              end - starts[c]);
            if (Choice turn = best_turn(embedded.pairs, mean);
                turn.correlation >= least_correlation)
                chosen = std::move(turn);
        } else {
            first = {starts[c], end};
            result.fit = std::move(embedded.fits[own]);
            result.coordinate = embedded.pairs[own].column;
        }
        const Values partner = partner_of(embedded.pairs, chosen.curve);
        for (std::size_t i = 0; i < chosen.curve.size(); ++i) {
            const double part = c > 0 ? std::min(1.0, static_cast<double>(i) / overlap) : 1;
            const auto fade = [&](double& at, double to) { at = (1 - part) * at + part * to; };
            fade(result.curve[begin + i], chosen.curve[i]);
            fade(result.partner[begin + i], partner[i]);
        }
        result.cyclicity.back() = chosen.cyclicity;
    }
    return result;
}

/// What varies more slowly than the period, such as sway, taken out.
Matrix high_passed(const Matrix& samples) {
    const Matrix slow =
        gaussian_smoothed(samples.view(), slow_periods * samples_per_period, Beyond::nothing, 1);
    Matrix fast = samples;
    axpy(-1, slow.data(), fast.data(), fast.rows() * fast.cols());
    return fast;
}

} // namespace

double PhaseCurve::typical_cyclicity() const {
    return median(cyclicity);
}

PhaseCurve trace_phase(const Signal& signal, const Growth& growth) {
    const double first = growth.run.phase.front();
    const auto count = static_cast<std::int64_t>(growth.turns() * samples_per_period) + 1;
    if (count < min_samples)
        return {};
    Values places;
    Matrix samples(count, signal.cols());
    for (std::int64_t i = 0; i < count; ++i) {
        places.push_back(growth.row_of(first + static_cast<double>(i) /
                                                   static_cast<double>(samples_per_period)));
        row_at(signal.poses.view(), places.back(), samples.row(i));
    }
    PhaseCurve curve = trace_view(samples.view(), signal, places);
    if (curve.typical_cyclicity() < good_cyclicity) {
        PhaseCurve view = trace_view(high_passed(samples).view(), signal, places);
        if (view.typical_cyclicity() > curve.typical_cyclicity() + clearly_better)
            curve = std::move(view);
    }
    curve.first_phase = first;
    curve.places = std::move(places);
    return curve;
}

} // namespace stltsa::motion
