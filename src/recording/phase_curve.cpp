// SPDX-License-Identifier: BSD-3-Clause
#include "recording/phase_curve.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "linalg/gaussian.hpp"
#include "linalg/simd.hpp"
#include "ltsa/embed.hpp"
#include "motion/coordinate.hpp"
#include "motion/curve/statistics.hpp"
#include "recording/least_squares.hpp"

namespace stltsa::recording {
namespace {

/// 1.2 periods, as in one clip (motion/choose_neighbors.cpp).
constexpr std::int64_t neighbors = 29;
constexpr std::int64_t chunk = 12 * samples_per_period;
constexpr std::int64_t overlap = 4 * samples_per_period;
/// The last chunk absorbs what is shorter than this beyond it.
constexpr std::int64_t least_rest = 6 * samples_per_period;
constexpr std::int64_t least_samples = samples_per_period * 3 / 2;
constexpr int most_dimensions = 3;
/// A view without slow sway is tried if the cyclicity is below this, and must be better by that.
constexpr double good_cyclicity = 0.85;
constexpr double clearly_better = 0.1;
constexpr double slow_periods = 0.75;
/// A chunk continues the one before if its coordinate correlates so much with it, and its spread is
/// within these ratios.
constexpr double least_correlation = 0.8;
constexpr double least_spread = 0.4;
constexpr double most_spread = 2.5;
/// The anchor holds if it correlates so much with the coordinate in the overlap.
constexpr double anchor_holds = 0.9;
constexpr double ridge = 1e-3;
/// Of dimensions, the next one must be better by this.
constexpr double slightly_better = 0.02;
constexpr double start_loss = 0.05;

using Values = std::vector<double>;

double correlation(std::span<const double> a, std::span<const double> b) {
    const auto n = static_cast<std::int64_t>(std::min(a.size(), b.size()));
    if (n < 2)
        return 0;
    const double ma = sum(a.data(), n) / static_cast<double>(n);
    const double mb = sum(b.data(), n) / static_cast<double>(n);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

double mean_of(std::span<const double> values) {
    return values.empty() ? 0
                          : sum(values.data(), static_cast<std::int64_t>(values.size())) /
                                static_cast<double>(values.size());
}

double spread_of(std::span<const double> values) {
    const double mean = mean_of(values);
    double squares = 0;
    for (const double v : values)
        squares += (v - mean) * (v - mean);
    return values.empty() ? 0 : std::sqrt(squares / static_cast<double>(values.size()));
}

double cyclicity_of(std::span<const double> curve) {
    const Values level(curve.size(), 1.0);
    return motion::cyclicity(curve, level, samples_per_period);
}

/// The two most cyclic coordinates of one embedding.
struct Pair {
    Values first, second; ///< the second is empty in one dimension
    double cyclicity = 0; ///< of the first
};

Pair most_cyclic(const Matrix& coords) {
    std::vector<std::pair<double, std::int64_t>> order;
    for (std::int64_t c = 0; c < coords.cols(); ++c)
        order.emplace_back(-cyclicity_of(motion::column_of(coords.view(), c)), c);
    std::sort(order.begin(), order.end());
    Pair pair;
    pair.first = motion::column_of(coords.view(), order[0].second);
    pair.cyclicity = -order[0].first;
    if (order.size() > 1)
        pair.second = motion::column_of(coords.view(), order[1].second);
    return pair;
}

/// Embeddings in 1 to 3 dimensions; fewer if the samples do not vary in so many directions.
std::vector<Pair> embed_chunk(ConstMatrixView samples) {
    ltsa::Parameters parameters;
    parameters.neighbors = std::min(neighbors, samples.rows - 1);
    parameters.window = parameters.neighbors;
    parameters.dimension = static_cast<int>(std::min<std::int64_t>(most_dimensions, samples.cols));
    std::vector<Pair> pairs;
    try {
        const ltsa::Graph graph =
            ltsa::build_graph(samples, {&samples.rows, 1}, parameters, Progress());
        if (graph.components.count > 1)
            return pairs;
        const int last = std::min(parameters.dimension, ltsa::varying_directions(graph));
        for (int d = 1; d <= last; ++d)
            pairs.push_back(
                most_cyclic(ltsa::embed(graph, d, ltsa::eigenvalues_of_fit(d), Progress()).coords));
    } catch (const Error& error) {
        if (error.status() != Status::degenerate && error.status() != Status::disconnected &&
            error.status() != Status::too_few_frames)
            throw;
    }
    return pairs;
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

Values anchored(const Anchor& anchor, ConstMatrixView samples) {
    Values target;
    for (std::int64_t i = 0; i < samples.rows; ++i)
        target.push_back(dot(samples.row(i), anchor.weights.data(), samples.cols) -
                         dot(anchor.mean.data(), anchor.weights.data(), samples.cols));
    return target;
}

void learn(ConstMatrixView samples, std::span<const double> curve, Anchor& anchor) {
    anchor.mean.assign(static_cast<std::size_t>(samples.cols), 0);
    for (std::int64_t i = 0; i < samples.rows; ++i)
        axpy(1 / static_cast<double>(samples.rows), samples.row(i), anchor.mean.data(),
             samples.cols);
    Matrix centered = copied(samples);
    for (std::int64_t i = 0; i < centered.rows(); ++i)
        axpy(-1, anchor.mean.data(), centered.row(i), centered.cols());
    const double mean = mean_of(curve);
    Values target;
    for (const double v : curve)
        target.push_back(v - mean);
    anchor.weights = least_squares(centered.view(), target, ridge);
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

/// Traces the curve through the chunks of one view of the samples.
class Tracer {
  public:
    Tracer(ConstMatrixView samples, PhaseCurve& result, RowProgress& progress)
        : samples_(samples), result_(result), progress_(progress),
          size_(static_cast<std::size_t>(samples.rows)) {
        result.curve.assign(size_, 0);
        result.partner.assign(size_, 0);
    }

    void run(const Anchor* like) {
        const auto starts = chunk_starts(samples_.rows);
        for (std::size_t c = 0; c < starts.size(); ++c) {
            const std::int64_t end = c + 1 == starts.size() ? samples_.rows : starts[c] + chunk;
            const Rows rows{starts[c], end};
            progress_.reached(result_.places[static_cast<std::size_t>(starts[c])]);
            const auto pairs = embed_chunk(samples_.block(rows.begin, rows.count()));
            if (pairs.empty())
                result_.cyclicity.push_back(0);
            else if (c == 0)
                begin(rows, pairs, like);
            else
                extend(rows, starts[c - 1], pairs);
        }
    }

  private:
    void begin(Rows rows, const std::vector<Pair>& pairs, const Anchor* like) {
        const Pair& own = pairs[simplest(pairs)];
        Choice chosen{own.first, 1, own.cyclicity};
        if (like != nullptr) {
            const Values target = anchored(*like, samples_.block(rows.begin, rows.count()));
            Choice turn = best_turn(pairs, target);
            if (turn.correlation >= least_correlation &&
                turn.cyclicity >= own.cyclicity - start_loss)
                chosen = std::move(turn);
        }
        place(rows, pairs, chosen, 0);
        learn(samples_.block(rows.begin, rows.count()), chosen.curve, result_.anchor);
    }

    void extend(Rows rows, std::int64_t before, const std::vector<Pair>& pairs) {
        const auto begin = static_cast<std::size_t>(rows.begin);
        const auto shared = static_cast<std::size_t>(
            std::clamp<std::int64_t>(before + chunk - rows.begin, 0, overlap));
        const std::span<const double> reference(result_.curve.data() + begin, shared);
        Values target;
        bool holds = false;
        if (!result_.anchor.weights.empty()) {
            target = anchored(result_.anchor, samples_.block(rows.begin, rows.count()));
            holds = correlation(std::span(target).first(shared), reference) >= anchor_holds;
        }
        if (!holds)
            target.assign(reference.begin(), reference.end());
        Choice turn = best_turn(pairs, target);
        if (turn.correlation < least_correlation)
            return restart(rows, pairs);
        if (!holds && !scale_to(before, begin + shared, turn.curve))
            return restart(rows, pairs);
        place(rows, pairs, turn, shared);
        if (!holds)
            learn(samples_.block(rows.begin, rows.count()),
                  std::span<const double>(result_.curve)
                      .subspan(begin, static_cast<std::size_t>(rows.count())),
                  result_.anchor);
    }

    /// Gives the curve the mean and spread of what was traced before; whether they were similar.
    /// What the anchor gives has its scale already: many small errors would add up.
    bool scale_to(std::int64_t before, std::size_t end, Values& curve) const {
        const auto first = static_cast<std::size_t>(before);
        const auto earlier = std::span<const double>(result_.curve).subspan(first, end - first);
        const double spread = spread_of(earlier);
        const double ratio = spread > 0 ? spread_of(curve) / spread : 0;
        if (ratio < least_spread || ratio > most_spread)
            return false;
        // Deviations alone are scaled: an offset would grow without bound in noise.
        const double mean = mean_of(curve), level = mean_of(earlier);
        for (double& v : curve)
            v = (v - mean) / ratio + level;
        return true;
    }

    /// A new coordinate, which does not continue the one before.
    void restart(Rows rows, const std::vector<Pair>& pairs) {
        const Pair& own = pairs[simplest(pairs)];
        place(rows, pairs, {own.first, 0, own.cyclicity}, 0);
    }

    /// Writes the chunk, crossfaded over the `shared` first samples.
    void place(Rows rows, const std::vector<Pair>& pairs, const Choice& chosen,
               std::size_t shared) {
        const auto begin = static_cast<std::size_t>(rows.begin);
        const Values partner = partner_of(pairs, chosen.curve);
        for (std::size_t i = 0; i < chosen.curve.size(); ++i) {
            const double part =
                i < shared ? static_cast<double>(i) / static_cast<double>(shared) : 1;
            const auto fade = [&](double& at, double to) { at = (1 - part) * at + part * to; };
            fade(result_.curve[begin + i], chosen.curve[i]);
            fade(result_.partner[begin + i], partner[i]);
        }
        result_.cyclicity.push_back(chosen.cyclicity);
    }

    ConstMatrixView samples_;
    PhaseCurve& result_;
    RowProgress& progress_;
    std::size_t size_;
};

/// Rows at which the phase, the running sum of 1 / period, passes the multiples of 1 / 24.
Values warped_places(const Stretch& stretch) {
    Values places;
    double phase = 0; // at row i, in samples
    double next = 0;
    for (std::size_t i = 0; i + 1 < stretch.period.size(); ++i) {
        const double step = static_cast<double>(samples_per_period) / stretch.period[i];
        for (; next <= phase + step; ++next)
            places.push_back(static_cast<double>(stretch.rows.begin) + static_cast<double>(i) +
                             (next - phase) / step);
        phase += step;
    }
    return places;
}

/// What varies more slowly than the period, such as sway, taken out.
Matrix high_passed(const Matrix& samples) {
    const Matrix slow =
        gaussian_smoothed(samples.view(), slow_periods * samples_per_period, Beyond::nothing);
    Matrix fast = samples;
    axpy(-1, slow.data(), fast.data(), fast.rows() * fast.cols());
    return fast;
}

PhaseCurve trace_view(ConstMatrixView samples, const Values& places, bool high_pass,
                      const Anchor* like, RowProgress& progress) {
    PhaseCurve result;
    result.places = places;
    result.anchor.high_pass = high_pass;
    Tracer(samples, result, progress)
        .run(like != nullptr && like->high_pass == high_pass ? like : nullptr);
    return result;
}

} // namespace

double PhaseCurve::typical_cyclicity() const {
    return motion::median(cyclicity);
}

std::vector<double> earlier_curve(const std::vector<double>& curve, std::size_t quarter) {
    Values earlier;
    for (std::size_t i = 0; i < curve.size(); ++i)
        earlier.push_back(i >= quarter                 ? curve[i - quarter]
                          : i + quarter < curve.size() ? -curve[i + quarter]
                                                       : 0);
    return earlier;
}

PhaseCurve trace_phase(const Signal& signal, const Stretch& stretch, const Anchor* like,
                       RowProgress& progress) {
    const Values places = warped_places(stretch);
    const auto count = static_cast<std::int64_t>(places.size());
    if (count < least_samples)
        return {};
    Matrix samples(count, signal.cols());
    for (std::int64_t i = 0; i < count; ++i)
        row_at(signal.poses.view(), places[static_cast<std::size_t>(i)], samples.row(i));
    PhaseCurve whole = trace_view(samples.view(), places, false, like, progress);
    if (whole.typical_cyclicity() >= good_cyclicity)
        return whole;
    const Matrix fast = high_passed(samples);
    PhaseCurve view = trace_view(fast.view(), places, true, like, progress);
    return view.typical_cyclicity() > whole.typical_cyclicity() + clearly_better ? view : whole;
}

} // namespace stltsa::recording
