// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/registration.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/extrema.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Rounds of mean cycle and phases: 3 give what 20 give.
constexpr int most_rounds = 4;
/// A round moves no phase further.
constexpr double most_correction = 0.1;
/// Least step, as a share of the mean one.
constexpr double slowest_in_cycle = 0.2;
constexpr double slowest_beyond = 0.05;
/// Rates at which a phase is continued beyond cycles, as shares of the mean one.
constexpr double least_rate = 0.4;
constexpr double most_rate = 2;
constexpr std::int64_t bins = 100;
/// Outside the cycles, a column that is this many standard deviations from the mean cycle has half
/// its weight. In first and last steps of walks, when the arms do not swing, all strikes and
/// toe-offs of the feet then lie within 50 ms of their phase; without it, 88 % do. Values from 1 to
/// 4 give the same result.
constexpr double half_off = 3;
/// Added to the variance of each column, as a share of the mean variance. Values from 0.03 to 0.3
/// give the same result.
constexpr double variance_floor = 0.1;
/// The same as a share of the motion's variance, for motion without noise.
constexpr double least_variance = 1e-9;

/// How a row pulls its phase: weight, and the phase it is pulled to.
struct Pull {
    std::vector<double> weight, target;
};

/// For checkpoint(): a row is compared with the loop at its phase.
std::int64_t work_at_phase(const Loop& loop) {
    return loop.coefficients.rows() * loop.cols();
}

/// The variance of each column about the mean cycle. Empty: all columns have the same weight.
using Spread = std::vector<double>;

Spread spread_about(ConstMatrixView rows, const MeanCycle& cycle, const Run& run) {
    Spread spread(static_cast<std::size_t>(rows.cols)), mean = spread;
    for (std::int64_t i = 0; i < run.rows(); ++i) {
        cycle.loop.at(run.phase[static_cast<std::size_t>(i)], mean.data());
        const double* row = rows.row(run.begin + i);
        for (std::size_t c = 0; c < spread.size(); ++c)
            spread[c] += (row[c] - mean[c]) * (row[c] - mean[c]) / static_cast<double>(run.rows());
        checkpoint(work_at_phase(cycle.loop));
    }
    const double sum = std::accumulate(spread.begin(), spread.end(), 0.0);
    const double floor = (variance_floor * sum + least_variance * cycle.variance) /
                         static_cast<double>(spread.size());
    for (double& each : spread)
        each += floor;
    return spread;
}

/// The weight of each column of a row: it rises as the column varies less within cycles and is
/// nearer to the mean cycle here. Parts of the body that do not yet take part in the motion give no
/// information on the phase of the others.
void weigh_columns(const double* row, const std::vector<double>& mean, const Spread& spread,
                   std::vector<double>& weights) {
    for (std::size_t c = 0; c < spread.size(); ++c) {
        const double off = (row[c] - mean[c]) / half_off;
        weights[c] = 1 / (spread[c] + off * off);
    }
}

/// One Gauss-Newton step of each row towards the nearest point of the loop.
Pull pull_to(ConstMatrixView rows, const Loop& loop, const Run& run, const Spread& spread) {
    Pull pull;
    std::vector<double> mean(static_cast<std::size_t>(rows.cols)), slope = mean;
    std::vector<double> counts(mean.size(), 1);
    for (std::int64_t i = 0; i < run.rows(); ++i) {
        const double phase = run.phase[static_cast<std::size_t>(i)];
        loop.at(phase, mean.data(), slope.data());
        const double* row = rows.row(run.begin + i);
        weigh_columns(row, mean, spread, counts);
        const double along = sum_of(rows.cols, [&](std::int64_t c) {
            const auto at = static_cast<std::size_t>(c);
            return counts[at] * (row[c] - mean[at]) * slope[at];
        });
        const double weight = sum_of(rows.cols, [&](std::int64_t c) {
            const auto at = static_cast<std::size_t>(c);
            return counts[at] * slope[at] * slope[at];
        });
        pull.weight.push_back(weight);
        pull.target.push_back(
            phase +
            (weight > 0 ? std::clamp(along / weight, -most_correction, most_correction) : 0));
        checkpoint(2 * work_at_phase(loop));
    }
    return pull;
}

/// Minimizes sum weight (x - target)^2 + stiffness sum (second difference of x)^2, by a Cholesky
/// factor L D L^T of the five diagonals, for which calls of LAPACK cost more than the arithmetic.
std::vector<double> smoothed(const std::vector<double>& weight, std::vector<double> target,
                             double stiffness) {
    const std::size_t n = target.size();
    struct Row {
        double diagonal, first, second; ///< of D, and of the column of L below it
    };
    std::vector<Row> rows(n);
    for (std::size_t j = 0; j < n; ++j) {
        rows[j].diagonal = weight[j];
        target[j] *= weight[j];
    }
    for (std::size_t j = 0; j + 2 < n; ++j) {
        rows[j].diagonal += stiffness;
        rows[j].first -= 2 * stiffness;
        rows[j].second += stiffness;
        rows[j + 1].diagonal += 4 * stiffness;
        rows[j + 1].first -= 2 * stiffness;
        rows[j + 2].diagonal += stiffness;
    }
    for (std::size_t j = 0; j < n; ++j) {
        Row& row = rows[j];
        if (!(row.diagonal > 0))
            return {};
        const double first = row.first, second = row.second;
        row.first /= row.diagonal;
        row.second /= row.diagonal;
        if (j + 1 < n) {
            rows[j + 1].diagonal -= first * row.first;
            rows[j + 1].first -= first * row.second;
            target[j + 1] -= row.first * target[j];
        }
        if (j + 2 < n) {
            rows[j + 2].diagonal -= second * row.second;
            target[j + 2] -= row.second * target[j];
        }
    }
    for (std::size_t j = n; j-- > 0;) {
        target[j] /= rows[j].diagonal;
        if (j + 1 < n)
            target[j] -= rows[j].first * target[j + 1];
        if (j + 2 < n)
            target[j] -= rows[j].second * target[j + 2];
    }
    return target;
}

/// Raises steps that are too small, so that the phase rises strictly, and keeps the median phase.
void make_rise(std::vector<double>& phase, double least_step) {
    bool falls = false;
    for (std::size_t i = 0; i + 1 < phase.size(); ++i)
        falls = falls || phase[i + 1] - phase[i] < least_step;
    if (!falls)
        return;
    std::vector<double> risen{0}, moved{phase[0]};
    for (std::size_t i = 0; i + 1 < phase.size(); ++i) {
        risen.push_back(risen.back() + std::max(phase[i + 1] - phase[i], least_step));
        moved.push_back(phase[i + 1] - risen.back());
    }
    const double offset = median(moved);
    for (std::size_t i = 0; i < phase.size(); ++i)
        phase[i] = risen[i] + offset;
}

/// A run on its way, and where it started: its changes are smooth, not its phase.
struct Moving {
    Run run;
    std::vector<double> start;

    explicit Moving(Run from) : run(std::move(from)), start(run.phase) {}

    void follow(const Pull& pull, double stiffness, double least_step) {
        std::vector<double> change;
        for (std::size_t i = 0; i < start.size(); ++i)
            change.push_back(pull.target[i] - start[i]);
        change = smoothed(pull.weight, std::move(change), stiffness);
        for (std::size_t i = 0; i < change.size(); ++i)
            run.phase[i] = start[i] + change[i];
        make_rise(run.phase, least_step);
    }
};

/// How far the phases moved at most.
double moved(const Run& from, const Run& to) {
    double most = 0;
    for (std::size_t i = 0; i < from.phase.size(); ++i)
        most = std::max(most, std::abs(to.phase[i] - from.phase[i]));
    return most;
}

double mean_weight(const std::vector<Pull>& pulls) {
    double sum = 0, count = 0;
    for (const Pull& pull : pulls) {
        sum = std::accumulate(pull.weight.begin(), pull.weight.end(), sum);
        count += static_cast<double>(pull.weight.size());
    }
    return sum / count;
}

double stiffness_of(double weight, double reach) {
    return weight * std::pow(reach, 4);
}

/// Adds the share of time at each phase of the turn that begins at phase `from`.
void add_turn(const Run& run, double from, std::vector<double>& shares) {
    const double first = run.row_at(from);
    const double length = run.row_at(from + 1) - first;
    double before = first;
    for (auto bin = static_cast<std::int64_t>(std::floor(from * bins));; ++bin) {
        const double border = std::min(static_cast<double>(bin + 1) / bins, from + 1);
        const double at = run.row_at(border);
        shares[static_cast<std::size_t>(((bin % bins) + bins) % bins)] += (at - before) / length;
        before = at;
        if (border >= from + 1)
            return;
    }
}

/// Makes the mean share of time uniform over the phases; without a whole turn nothing changes.
void even_out(std::vector<Moving>& all) {
    std::vector<double> shares(bins);
    double turns = 0;
    for (const Moving& moving : all) {
        const std::vector<double>& phases = moving.run.phase;
        for (double from = phases.front(); from + 1 <= phases.back(); ++from, ++turns)
            add_turn(moving.run, from, shares);
    }
    if (turns == 0)
        return;
    std::vector<double> knots{0};
    for (const double share : shares)
        knots.push_back(knots.back() + share / turns);
    for (Moving& moving : all)
        for (double& phase : moving.run.phase) {
            const double whole = std::floor(phase);
            const double place = (phase - whole) * bins;
            const auto bin = std::min<std::int64_t>(bins - 1, static_cast<std::int64_t>(place));
            const double low = knots[static_cast<std::size_t>(bin)];
            phase = whole + low +
                    (place - static_cast<double>(bin)) *
                        (knots[static_cast<std::size_t>(bin + 1)] - low);
        }
}

std::vector<Run> runs_of(const std::vector<Moving>& all) {
    std::vector<Run> runs;
    for (const Moving& moving : all)
        runs.push_back(moving.run);
    return runs;
}

double variance_of(ConstMatrixView rows, std::span<const Run> runs) {
    std::vector<double> mean(static_cast<std::size_t>(rows.cols));
    double count = 0, squares = 0;
    for (const Run& run : runs)
        for (std::int64_t i = run.begin; i < run.end(); ++i, ++count) {
            axpy(1, rows.row(i), mean.data(), rows.cols);
            checkpoint(rows.cols);
        }
    for (double& value : mean)
        value /= count;
    for (const Run& run : runs)
        for (std::int64_t i = run.begin; i < run.end(); ++i) {
            squares += squared_distance(rows.row(i), mean.data(), rows.cols);
            checkpoint(rows.cols);
        }
    return squares / count;
}

/// Change of the phase per row in the quarter of a cycle at an end.
double rate_at(const std::vector<double>& phase, bool at_end, double period) {
    const std::size_t last = phase.size() - 1;
    const std::size_t reach =
        std::clamp<std::size_t>(static_cast<std::size_t>(period / 4), 1, last);
    const double change = at_end ? phase[last] - phase[last - reach] : phase[reach] - phase[0];
    return std::clamp(change / static_cast<double>(reach), least_rate / period, most_rate / period);
}

Run registered(ConstMatrixView rows, const MeanCycle& mean, Run run, double slowest, double smooth,
               double settled, const Spread& spread) {
    Moving moving(std::move(run));
    for (int round = 0; round < most_rounds; ++round) {
        const Run before = moving.run;
        const Pull pull = pull_to(rows, mean.loop, moving.run, spread);
        moving.follow(pull, stiffness_of(mean_weight({pull}), smooth * mean.period),
                      slowest / mean.period);
        if (moved(before, moving.run) < settled)
            break;
    }
    return moving.run;
}

/// Registers the last two cycles at an end again, and blends them into what is there.
void settle(ConstMatrixView rows, const MeanCycle& mean, const Spread& spread, bool at_end,
            Run& run) {
    const std::int64_t count =
        std::min(run.rows(), static_cast<std::int64_t>(std::llround(2 * mean.period)));
    const std::int64_t first = at_end ? run.rows() - count : 0;
    const auto begin = run.phase.begin() + first;
    const Run moved = registered(rows, mean, {run.begin + first, {begin, begin + count}},
                                 slowest_beyond, smooth_share, nearly_settled, spread);
    for (std::int64_t i = 0; i < count; ++i) {
        const double place =
            static_cast<double>(i) / static_cast<double>(std::max<std::int64_t>(1, count - 1));
        const double share = std::clamp(2 * (at_end ? place : 1 - place), 0.0, 1.0);
        double& phase = run.phase[static_cast<std::size_t>(first + i)];
        phase += share * (moved.phase[static_cast<std::size_t>(i)] - phase);
    }
}

} // namespace

Registration register_runs(ConstMatrixView rows, std::vector<Run> runs, double period,
                           double smooth, double settled) {
    Registration result;
    result.mean.period = period;
    result.mean.variance = variance_of(rows, runs);
    const std::int64_t harmonics = harmonics_for(period);
    std::vector<Moving> all;
    for (Run& run : runs)
        all.emplace_back(std::move(run));
    for (int round = 0; round < most_rounds; ++round) {
        const std::vector<Run> before = runs_of(all);
        const Loop loop = fit_loop(rows, before, harmonics);
        std::vector<Pull> pulls;
        for (const Moving& moving : all)
            pulls.push_back(pull_to(rows, loop, moving.run, {}));
        const double stiffness = stiffness_of(mean_weight(pulls), smooth * period);
        for (std::size_t r = 0; r < all.size(); ++r)
            all[r].follow(pulls[r], stiffness, slowest_in_cycle / period);
        even_out(all);
        double most = 0;
        for (std::size_t r = 0; r < all.size(); ++r)
            most = std::max(most, moved(before[r], all[r].run));
        if (most < settled)
            break;
    }
    result.runs = runs_of(all);
    result.mean.loop = fit_loop(rows, result.runs, harmonics);
    return result;
}

Run register_with(ConstMatrixView rows, const MeanCycle& mean, Run run, double slowest,
                  double smooth) {
    return registered(rows, mean, std::move(run), slowest, smooth, 0, {});
}

Run continued(const Run& run, double period, Range within) {
    const double begin_rate = rate_at(run.phase, false, period);
    const double end_rate = rate_at(run.phase, true, period);
    std::vector<double> phase;
    for (std::int64_t i = run.begin - within.begin; i > 0; --i)
        phase.push_back(run.phase.front() - begin_rate * static_cast<double>(i));
    phase.insert(phase.end(), run.phase.begin(), run.phase.end());
    for (std::int64_t i = 1; i <= within.end - run.end(); ++i)
        phase.push_back(run.phase.back() + end_rate * static_cast<double>(i));
    return {within.begin, std::move(phase)};
}

Run grown(ConstMatrixView rows, const MeanCycle& mean, const Run& run, Range within) {
    Run result = run;
    const Spread spread = spread_about(rows, mean, run);
    const std::int64_t step = std::max<std::int64_t>(3, static_cast<std::int64_t>(mean.period / 4));
    while (result.begin > within.begin || result.end() < within.end) {
        const Run before = std::move(result);
        result = continued(before, mean.period,
                           {std::max(within.begin, before.begin - step),
                            std::min(within.end, before.end() + step)});
        if (result.begin < before.begin)
            settle(rows, mean, spread, false, result);
        if (result.end() > before.end())
            settle(rows, mean, spread, true, result);
        make_rise(result.phase, slowest_beyond * slowest_in_cycle / mean.period);
    }
    return result;
}

std::vector<double> residuals(ConstMatrixView rows, const MeanCycle& mean, const Run& run) {
    std::vector<double> expected(static_cast<std::size_t>(rows.cols)), result;
    for (std::int64_t i = 0; i < run.rows(); ++i) {
        mean.loop.at(run.phase[static_cast<std::size_t>(i)], expected.data());
        result.push_back(std::sqrt(
            squared_distance(rows.row(run.begin + i), expected.data(), rows.cols) / mean.variance));
        checkpoint(work_at_phase(mean.loop));
    }
    return result;
}

Offset offset_between(const Loop& first, const Loop& second) {
    constexpr std::int64_t places = 200;
    const std::int64_t m = first.harmonics(), n = second.harmonics(), cols = first.cols();
    // By Parseval's theorem, the sum over the places of the products of both curves is a Fourier
    // series of the shift.
    std::vector<double> alike(places, 0);
    for (std::int64_t h = 1; h <= std::min(m, n); ++h) {
        const double* a = first.coefficients.row(h);
        const double* b = first.coefficients.row(m + h);
        const double* c = second.coefficients.row(h);
        const double* d = second.coefficients.row(n + h);
        const double cosine = dot(a, c, cols) + dot(b, d, cols);
        const double sine = dot(a, d, cols) - dot(b, c, cols);
        for (std::int64_t shift = 0; shift < places; ++shift) {
            const double angle = turn * static_cast<double>(h * shift) / places;
            alike[static_cast<std::size_t>(shift)] +=
                (cosine * std::cos(angle) + sine * std::sin(angle)) / 2;
        }
    }
    const auto best = static_cast<std::int64_t>(std::ranges::max_element(alike) - alike.begin());
    const auto at = [&](std::int64_t i) {
        return alike[static_cast<std::size_t>((i + places) % places)];
    };
    const double shift =
        (static_cast<double>(best) + parabola_vertex(at(best - 1), at(best), at(best + 1))) /
        places;
    const double size = std::sqrt(first.variance() * second.variance());
    return {shift - std::floor(shift), size > 0 ? at(best) / size : 0};
}

} // namespace stltsa::motion
