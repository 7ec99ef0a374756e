// SPDX-License-Identifier: BSD-3-Clause
#include "phase/live_cycle.hpp"

#include <algorithm>
#include <cmath>

#include <lapacke.h>

#include "linalg/principal.hpp"
#include "linalg/simd.hpp"
#include "motion/curve/statistics.hpp"
#include "phase/live_filter.hpp"

namespace stltsa::phase {
namespace {

constexpr std::int64_t most_directions = 16; ///< 32 give the same
constexpr std::int64_t most_harmonics = 10;
/// Added to the covariance of the residuals, as a share of the mean variance.
constexpr double least_scatter = 0.02;

/// Pose and scaled velocity behind the filter, of every row.
Matrix filtered(ConstMatrixView rows, double rate, double period_s) {
    const std::int64_t p = rows.cols;
    LiveFilter filter(static_cast<std::size_t>(p));
    Matrix both(rows.rows, 2 * p);
    const double scale = velocity_scale(period_s);
    for (std::int64_t i = 0; i < rows.rows; ++i) {
        if (i == 0)
            filter.start(rows.row(i));
        else
            filter.step(1 / rate, rows.row(i));
        std::ranges::copy(filter.pose(), both.row(i));
        axpy(scale, filter.velocity().data(), both.row(i) + p, p);
    }
    return both;
}

/// The runs without what the filter has not yet seen enough of.
std::vector<Run> warm(const std::vector<Run>& runs, double rate) {
    const auto cold = static_cast<std::int64_t>(std::ceil(warm_up_s * rate));
    std::vector<Run> result;
    for (const Run& run : runs) {
        const std::int64_t drop = std::clamp<std::int64_t>(cold - run.begin, 0, run.rows());
        if (drop < run.rows())
            result.push_back({run.begin + drop, {run.phase.begin() + drop, run.phase.end()}});
    }
    return result;
}

/// Every row of the runs.
Matrix gathered(const Matrix& rows, const std::vector<Run>& runs) {
    std::int64_t count = 0;
    for (const Run& run : runs)
        count += run.rows();
    Matrix result(count, rows.cols());
    double* to = result.data();
    for (const Run& run : runs)
        to = std::copy_n(rows.row(run.begin), run.rows() * rows.cols(), to);
    return result;
}

/// The runs, as if one after another.
std::vector<Run> packed(const std::vector<Run>& runs) {
    std::vector<Run> result;
    std::int64_t begin = 0;
    for (const Run& run : runs) {
        result.push_back({begin, run.phase});
        begin += run.rows();
    }
    return result;
}

void center(Matrix& rows, std::vector<double>& mean) {
    mean = column_means(rows.view());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        axpy(-1, mean.data(), rows.row(i), rows.cols());
}

Matrix projected(const Matrix& rows, const Matrix& directions) {
    Matrix result(rows.rows(), directions.rows());
    for (std::int64_t i = 0; i < rows.rows(); ++i)
        for (std::int64_t d = 0; d < directions.rows(); ++d)
            result(i, d) = dot(rows.row(i), directions.row(d), rows.cols());
    return result;
}

/// The inverse of the Cholesky factor of the residuals' covariance.
Matrix whitening_of(const Matrix& residuals, double least_variance) {
    const std::int64_t n = residuals.cols();
    std::vector<double> matrix(static_cast<std::size_t>(n * n));
    set_covariance(residuals.view(), matrix.data());
    for (std::int64_t i = 0; i < n; ++i)
        matrix[static_cast<std::size_t>(i * n + i)] += least_variance;
    const auto order = static_cast<lapack_int>(n);
    if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', order, matrix.data(), order) != 0 ||
        LAPACKE_dtrtri_work(LAPACK_COL_MAJOR, 'L', 'N', order, matrix.data(), order) != 0)
        fail(Status::degenerate, "the motion has no extent: nothing can be followed");
    Matrix whitening(n, n);
    for (std::int64_t c = 0; c < n; ++c)
        for (std::int64_t r = c; r < n; ++r)
            whitening(r, c) = matrix[static_cast<std::size_t>(c * n + r)];
    return whitening;
}

/// Poses at rest at even phases, in the directions. The filter has come to rest as well: they are
/// not delayed, and have no velocity.
Matrix places_at_rest(const Matrix& rows, const std::vector<Run>& runs, const LiveCycle& cycle,
                      std::int64_t harmonics) {
    const std::int64_t p = rows.cols();
    const Matrix poses = fit_loop(rows.view(), runs, harmonics).sampled(place_count);
    Matrix both(place_count, 2 * p);
    for (std::int64_t g = 0; g < place_count; ++g) {
        std::copy_n(poses.row(g), p, both.row(g));
        axpy(-1, cycle.mean.data(), both.row(g), 2 * p);
    }
    return projected(both, cycle.directions);
}

double squares(const Matrix& matrix) {
    return dot(matrix.data(), matrix.data(), matrix.rows() * matrix.cols());
}

double median_rate(const std::vector<Run>& runs, double rate) {
    std::vector<double> steps;
    for (const Run& run : runs)
        for (std::size_t i = 0; i + 1 < run.phase.size(); ++i)
            steps.push_back((run.phase[i + 1] - run.phase[i]) * rate);
    return motion::median(steps);
}

} // namespace

void whiten(const Matrix& whitening, const double* values, double* whitened) {
    for (std::int64_t r = 0; r < whitening.rows(); ++r)
        whitened[r] = dot(whitening.row(r), values, r + 1);
}

LiveCycle learn_live(ConstMatrixView rows, double rate, const Phases& phases,
                     std::span<const std::int64_t> drifting) {
    LiveCycle cycle;
    cycle.rate = rate;
    cycle.period = phases.mean.period / rate;
    cycle.turns_per_second = median_rate(phases.runs, rate);
    cycle.weights.assign(static_cast<std::size_t>(rows.cols), 1);
    Matrix used = copied(rows);
    for (const std::int64_t column : drifting) {
        cycle.weights[static_cast<std::size_t>(column)] = 0;
        for (std::int64_t i = 0; i < used.rows(); ++i)
            used(i, column) = 0;
    }
    const std::vector<Run> runs = warm(phases.runs, rate);
    if (runs.empty())
        fail(Status::too_few_frames, "the cycles end before the filter has settled");
    Matrix centered = gathered(filtered(used.view(), rate, cycle.period), runs);
    center(centered, cycle.mean);
    const auto count = static_cast<double>(centered.rows());
    cycle.variance = squares(centered) / count;
    double speed = 0;
    for (std::int64_t i = 0; i < centered.rows(); ++i)
        speed += dot(centered.row(i) + rows.cols, centered.row(i) + rows.cols, rows.cols) / count;
    cycle.usual_speed = std::sqrt(speed);
    cycle.directions = principal_directions(centered.view(), most_directions).directions;
    Matrix coordinates = projected(centered, cycle.directions);
    const std::int64_t harmonics =
        std::min(most_harmonics, motion::harmonics_for(phases.mean.period));
    const Loop loop = fit_loop(coordinates.view(), packed(runs), harmonics);
    cycle.places = loop.sampled(place_count);
    cycle.rests = places_at_rest(used, runs, cycle, harmonics);
    const double least =
        least_scatter * squares(coordinates) / count / static_cast<double>(coordinates.cols());
    std::vector<double> expected(static_cast<std::size_t>(coordinates.cols()));
    std::int64_t row = 0;
    for (const Run& run : runs)
        for (const double phase : run.phase) {
            loop.at(phase, expected.data());
            axpy(-1, expected.data(), coordinates.row(row++), coordinates.cols());
        }
    cycle.whitening = whitening_of(coordinates, least);
    std::vector<double> distances, whitened = expected;
    for (std::int64_t i = 0; i < coordinates.rows(); ++i) {
        whiten(cycle.whitening, coordinates.row(i), whitened.data());
        distances.push_back(dot(whitened.data(), whitened.data(), coordinates.cols()));
    }
    cycle.typical = std::max(motion::median(distances), 1e-9);
    return cycle;
}

} // namespace stltsa::phase
