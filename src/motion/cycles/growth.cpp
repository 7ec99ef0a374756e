// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/growth.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"

namespace stltsa::motion {
namespace {

/// Periods with which the registration begins: those in which the period changes least.
constexpr double seed_periods = 3;
/// Changes of the period that differ less, on a log scale, are alike.
constexpr double steady = 0.02;
/// The motion ends where rows are farther from the mean cycle than this share of its variance, or
/// where it is faster or slower than the tracked period by this factor.
constexpr double max_deviation = 0.33;
/// Noise, and what differs from cycle to cycle, may be more: so many times what is usual.
constexpr double usual_deviations = 3;
constexpr double deviation_periods = 0.25; // so many rows at a time
constexpr double max_tempo_ratio = 1.4;
/// Periods by which it grows at a time, and at most beyond the tracked rows on each side.
constexpr double growth_periods = 0.5;
constexpr double periods_beyond = 3;
/// Cycles at an end with which new rows are registered.
constexpr double registered_again = 1;
/// Least tempo of a registered row, as a share of the mean one.
constexpr double slowest = 0.2;
/// Phases vary smoothly over this share of a cycle: with the finer smooth_share, noise that
/// is as large as the motion adds turns.
constexpr double smooth = 0.2;
constexpr std::int64_t min_rows = 6;

class Grower {
  public:
    Grower(const Signal& signal, const Stretch& stretch, Rows within)
        : typical_(median(stretch.period)) {
        const auto more = static_cast<std::int64_t>(periods_beyond * typical_);
        rows_ = {std::max(within.begin, stretch.rows.begin - more),
                 std::min(within.end, stretch.rows.end + more)};
        const auto first = static_cast<std::ptrdiff_t>(stretch.rows.begin - rows_.begin);
        period_.assign(static_cast<std::size_t>(rows_.count()), stretch.period.back());
        std::fill_n(period_.begin(), first, stretch.period.front());
        std::ranges::copy(stretch.period, period_.begin() + first);
        tracked_ = {first, first + stretch.rows.count()};
        phase_.resize(period_.size());
        both_ = pose_and_velocity(signal.poses.view().block(rows_.begin, rows_.count()),
                                  signal.rate, typical_);
        for (std::int64_t i = 0; i < both_.rows(); ++i) { // velocities per cycle at the local tempo
            const double tempo = period_[static_cast<std::size_t>(i)] / typical_;
            for (std::int64_t c = signal.cols(); c < both_.cols(); ++c)
                both_(i, c) *= tempo;
        }
    }

    Growth grow() {
        if (tracked_.rows() < min_rows || !enter(seed()))
            return {};
        // Less than a step is no reason to try again: the rounds are as many as the run doubles.
        const auto least = std::max<std::int64_t>(2, std::llround(growth_periods * typical_));
        for (std::int64_t before = 0; before == 0 || grown_.rows() >= before + least;) {
            before = grown_.rows();
            const std::int64_t most = 2 * before;
            while (grown_.rows() < most && extend(true))
                continue;
            while (grown_.rows() < most && extend(false))
                continue;
            if (grown_.rows() > before) // the mean cycle follows what has been added
                enter(part(grown_));
        }
        const Run run = part(grown_);
        return {{run.begin + rows_.begin, run.phase}, mean_, deviations(run)};
    }

  private:
    /// Linear time over the periods that change least; of those that change alike, in the middle:
    /// at its ends, a motion begins or ends.
    Run seed() const {
        const auto count = std::min<std::int64_t>(
            tracked_.rows(),
            std::max<std::int64_t>(min_rows, std::llround(seed_periods * typical_)));
        std::vector<double> changed{0}; // up to each row
        for (std::int64_t i = tracked_.begin + 1; i < tracked_.end; ++i)
            changed.push_back(changed.back() +
                              std::abs(std::log(period_[static_cast<std::size_t>(i)] /
                                                period_[static_cast<std::size_t>(i - 1)])));
        const auto change = [&](std::int64_t begin) {
            return changed[static_cast<std::size_t>(begin + count - 1)] -
                   changed[static_cast<std::size_t>(begin)];
        };
        const std::int64_t last = tracked_.rows() - count;
        double least = change(0);
        for (std::int64_t begin = 1; begin <= last; ++begin)
            least = std::min(least, change(begin));
        std::int64_t best = 0;
        for (std::int64_t begin = 0; begin <= last; ++begin)
            if (change(begin) <= least + steady &&
                (change(best) > least + steady ||
                 std::abs(2 * begin - last) < std::abs(2 * best - last)))
                best = begin;
        Run run{tracked_.begin + best, {}};
        double phase = 0;
        for (std::int64_t i = run.begin; i < tracked_.begin + best + count; ++i) {
            run.phase.push_back(phase);
            phase += 1 / period_[static_cast<std::size_t>(i)];
        }
        return run;
    }

    /// Registers the run with its own mean cycle; false if nothing moves.
    bool enter(Run run) {
        Registration found = register_runs(both_.view(), {std::move(run)}, typical_, smooth, 0);
        grown_ = {found.runs.front().begin, found.runs.front().end()};
        take(found.runs.front(), grown_);
        mean_ = std::move(found.mean);
        return mean_.loop.variance() > 0;
    }

    Run part(Range rows) const {
        return {rows.begin, {phase_.begin() + rows.begin, phase_.begin() + rows.end}};
    }

    void take(const Run& run, Range rows) {
        std::copy_n(run.phase.begin() + (rows.begin - run.begin), rows.rows(),
                    phase_.begin() + rows.begin);
    }

    /// Adds half a period at an end; whether all of it is the same motion.
    bool extend(bool at_end) {
        const auto local = [&](std::int64_t row) { return period_[static_cast<std::size_t>(row)]; };
        const double period = local(at_end ? grown_.end - 1 : grown_.begin);
        const auto step = std::max<std::int64_t>(2, std::llround(growth_periods * period));
        const Range fresh =
            at_end ? Range{grown_.end, std::min(both_.rows(), grown_.end + step)}
                   : Range{std::max<std::int64_t>(0, grown_.begin - step), grown_.begin};
        if (fresh.rows() < 1)
            return false;
        const auto again =
            std::min<std::int64_t>(grown_.rows(), std::llround(registered_again * period));
        const Range all =
            at_end ? Range{fresh.begin - again, fresh.end} : Range{fresh.begin, fresh.end + again};
        const Run more = register_with(both_.view(), mean_, continued(all), slowest, smooth);
        const std::int64_t kept = same_motion(more, fresh, at_end);
        if (kept > 0) {
            const Range rows = at_end ? Range{fresh.begin - again / 2, fresh.begin + kept}
                                      : Range{fresh.end - kept, fresh.end + again / 2};
            take(more, rows);
            grown_ = {std::min(grown_.begin, rows.begin), std::max(grown_.end, rows.end)};
        }
        return kept == step;
    }

    /// What is known of the rows, continued at the tracked period.
    Run continued(Range rows) const {
        Run run{rows.begin, std::vector<double>(static_cast<std::size_t>(rows.rows()))};
        const auto phase = [&](std::int64_t row) -> double& {
            return run.phase[static_cast<std::size_t>(row - rows.begin)];
        };
        const Range known{std::max(rows.begin, grown_.begin), std::min(rows.end, grown_.end)};
        std::copy_n(phase_.begin() + known.begin, known.rows(), &phase(known.begin));
        for (std::int64_t row = known.end; row < rows.end; ++row)
            phase(row) = phase(row - 1) + 1 / period_[static_cast<std::size_t>(row - 1)];
        for (std::int64_t row = known.begin - 1; row >= rows.begin; --row)
            phase(row) = phase(row + 1) - 1 / period_[static_cast<std::size_t>(row)];
        return run;
    }

    /// How many of the fresh rows next to the run go on with its motion.
    std::int64_t same_motion(const Run& more, Range fresh, bool at_end) const {
        const auto phase = [&](std::int64_t row) {
            return more.phase[static_cast<std::size_t>(row - more.begin)];
        };
        // From the last known row to the farthest new one.
        const std::int64_t from = at_end ? fresh.begin - 1 : fresh.begin;
        const std::int64_t to = at_end ? fresh.end - 1 : fresh.end;
        double turns = 0;
        for (std::int64_t i = from; i < to; ++i)
            turns += 1 / period_[static_cast<std::size_t>(i)];
        const double tempo = (phase(to) - phase(from)) / turns;
        if (!(tempo < max_tempo_ratio && tempo > 1 / max_tempo_ratio))
            return 0;
        const std::vector<double> all = deviations(more);
        const auto reach = // of the known rows, those next to the fresh ones may be too few
            std::min(std::max<std::int64_t>(2, std::llround(deviation_periods * typical_)),
                     more.rows() - fresh.rows() + 1);
        const auto row = [&](std::int64_t i) { // the i-th from the known ones, which are negative
            return static_cast<std::size_t>((at_end ? fresh.begin + i : fresh.end - 1 - i) -
                                            more.begin);
        };
        std::vector<double> known;
        for (std::int64_t i = fresh.rows() - more.rows(); i < 0; ++i)
            known.push_back(all[row(i)]);
        const double limit = std::max(max_deviation, usual_deviations * median(known));
        for (std::int64_t i = 0; i < fresh.rows(); ++i) {
            std::vector<double> last; // the median, since single points may jump
            for (std::int64_t k = i + 1 - reach; k <= i; ++k)
                last.push_back(all[row(k)]);
            if (median(last) > limit)
                return std::max<std::int64_t>(0, i + 1 - reach);
        }
        return fresh.rows();
    }

    std::vector<double> deviations(const Run& run) const {
        Matrix off(run.rows(), both_.cols());
        for (std::int64_t i = 0; i < run.rows(); ++i) {
            mean_.loop.at(run.phase[static_cast<std::size_t>(i)], off.row(i));
            for (std::int64_t c = 0; c < off.cols(); ++c)
                off(i, c) = both_(run.begin + i, c) - off(i, c);
            checkpoint(both_.cols() * mean_.loop.coefficients.rows());
        }
        // Sway: the mean deviation over the period around the row, or over the outermost one.
        const auto period =
            std::min<std::int64_t>(run.rows(), std::max<std::int64_t>(1, std::llround(typical_)));
        std::vector<double> squares, sway(static_cast<std::size_t>(off.cols()));
        std::int64_t begin = 0, end = 0;
        for (std::int64_t i = 0; i < run.rows(); ++i) {
            const std::int64_t from =
                std::clamp<std::int64_t>(i - period / 2, 0, run.rows() - period);
            for (; end < from + period; ++end)
                axpy(1 / static_cast<double>(period), off.row(end), sway.data(), off.cols());
            for (; begin < from; ++begin)
                axpy(-1 / static_cast<double>(period), off.row(begin), sway.data(), off.cols());
            const double all = dot(off.row(i), off.row(i), off.cols());
            const double along = dot(off.row(i), sway.data(), off.cols());
            squares.push_back(
                std::max(0.0, all - 2 * along + dot(sway.data(), sway.data(), off.cols())) /
                mean_.loop.variance());
        }
        return squares;
    }

    double typical_;
    Rows rows_;                  ///< of the signal, that may belong to the motion
    Range tracked_;              ///< the stretch, counted from rows_.begin as all that follows
    std::vector<double> period_; ///< of each row
    Matrix both_;
    Range grown_;
    std::vector<double> phase_; ///< of each row; known in grown_
    MeanCycle mean_;
};

} // namespace

double Growth::row_of(double phase) const {
    const auto after = std::ranges::upper_bound(run.phase, phase) - run.phase.begin();
    const auto i = std::clamp<std::ptrdiff_t>(after, 1, run.rows() - 1);
    const double before = run.phase[static_cast<std::size_t>(i - 1)];
    const double step = run.phase[static_cast<std::size_t>(i)] - before;
    return static_cast<double>(run.begin + i - 1) + std::clamp((phase - before) / step, -0.5, 1.5);
}

Growth grow(const Signal& signal, const Stretch& stretch, Rows within) {
    return Grower(signal, stretch, within).grow();
}

} // namespace stltsa::motion
