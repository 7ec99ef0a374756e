// SPDX-License-Identifier: BSD-3-Clause
#include "motion/cycles/loop.hpp"

#include <algorithm>
#include <cmath>

#include "base/checkpoint.hpp"
#include "base/numbers.hpp"
#include "linalg/band.hpp"
#include "linalg/simd.hpp"
#include "linalg/weighted_rows.hpp"

namespace stltsa::motion {
namespace {

/// Of the highest harmonic, as a share of the number of rows; falls with the fourth power.
constexpr double ridge = 1e-3;
/// From 4 to 24 harmonics the phase of annotated events scatters alike.
constexpr std::int64_t least_harmonics = 3;
constexpr std::int64_t most_harmonics = 12;

/// So many rows are added to the normal equations at once.
constexpr std::int64_t rows_at_once = 32;

/// 1, cos(2 pi h phase), sin(2 pi h phase); by the addition theorem, since cosines and sines are
/// most of the time of a registration.
void basis(double phase, std::int64_t harmonics, double* values) {
    const double c = std::cos(turn * phase), s = std::sin(turn * phase);
    values[0] = 1;
    double cosine = 1, sine = 0;
    for (std::int64_t h = 1; h <= harmonics; ++h) {
        const double next = cosine * c - sine * s;
        sine = sine * c + cosine * s;
        values[h] = cosine = next;
        values[harmonics + h] = sine;
    }
}

/// From the basis to its derivative by the phase.
void differentiate(std::int64_t harmonics, double* values) {
    values[0] = 0;
    for (std::int64_t h = 1; h <= harmonics; ++h) {
        const double k = turn * static_cast<double>(h), cosine = values[h];
        values[h] = -k * values[harmonics + h];
        values[harmonics + h] = k * cosine;
    }
}

void combine(const Matrix& coefficients, const double* weights, double* values) {
    std::fill_n(values, coefficients.cols(), 0.0);
    add_weighted(coefficients.view(), weights, 1, values);
}

} // namespace

void Loop::at(double phase, double* values) const {
    double weights[2 * most_harmonics + 1];
    basis(phase, harmonics(), weights);
    combine(coefficients, weights, values);
}

void Loop::at(double phase, double* values, double* slope) const {
    double weights[2 * most_harmonics + 1];
    basis(phase, harmonics(), weights);
    combine(coefficients, weights, values);
    differentiate(harmonics(), weights);
    combine(coefficients, weights, slope);
}

void Loop::shift(double zero) {
    const std::int64_t n = harmonics();
    for (std::int64_t h = 1; h <= n; ++h) {
        const double c = std::cos(turn * static_cast<double>(h) * zero);
        const double s = std::sin(turn * static_cast<double>(h) * zero);
        for (std::int64_t j = 0; j < cols(); ++j) {
            const double a = coefficients(h, j), b = coefficients(n + h, j);
            coefficients(h, j) = a * c + b * s;
            coefficients(n + h, j) = b * c - a * s;
        }
    }
}

Matrix Loop::sampled(std::int64_t count) const {
    Matrix values(count, cols());
    for (std::int64_t i = 0; i < count; ++i)
        at(static_cast<double>(i) / static_cast<double>(count), values.row(i));
    return values;
}

double Loop::variance() const {
    return sum_of((coefficients.rows() - 1) * cols(),
                  [&](std::int64_t i) {
                      const double c = coefficients.row(1)[i];
                      return c * c;
                  }) /
           2;
}

double Run::phase_at(double row) const {
    const double place = row - static_cast<double>(begin);
    const auto i = static_cast<std::size_t>(std::clamp(
        std::floor(place), 0.0, static_cast<double>(std::max<std::int64_t>(0, rows() - 2))));
    const double step = phase[std::min(i + 1, phase.size() - 1)] - phase[i];
    return phase[i] + (place - static_cast<double>(i)) * step;
}

double Run::row_at(double reached) const {
    const auto after = std::ranges::upper_bound(phase, reached) - phase.begin();
    const auto i = static_cast<std::size_t>(std::clamp<std::int64_t>(after, 1, rows() - 1));
    return static_cast<double>(begin) + static_cast<double>(i - 1) +
           (reached - phase[i - 1]) / (phase[i] - phase[i - 1]);
}

Loop fit_loop(ConstMatrixView rows, std::span<const Run> runs, std::int64_t harmonics) {
    const std::int64_t terms = 2 * harmonics + 1;
    Matrix normal(terms, terms), right(terms, rows.cols);
    Matrix b(rows_at_once, terms);
    double count = 0;
    for (const Run& run : runs)
        for (std::int64_t i = 0; i < run.rows(); i += rows_at_once) {
            const std::int64_t block = std::min(rows_at_once, run.rows() - i);
            for (std::int64_t k = 0; k < block; ++k)
                basis(run.phase[static_cast<std::size_t>(i + k)], harmonics, b.row(k));
            for (std::int64_t r = 0; r < terms; ++r) {
                add_weighted({b.data(), block, r + 1, terms}, b.data() + r, terms, normal.row(r));
                add_weighted(rows.block(run.begin + i, block), b.data() + r, terms, right.row(r));
                checkpoint(block * rows.cols);
            }
            count += static_cast<double>(block);
        }
    BandMatrix system(terms, terms - 1);
    for (std::int64_t j = 0; j < terms; ++j)
        for (std::int64_t i = j; i < terms; ++i)
            system.column(j)[i - j] = normal(i, j);
    for (std::int64_t r = 1; r < terms; ++r) {
        const auto h = static_cast<double>(r > harmonics ? r - harmonics : r);
        *system.column(r) += ridge * count * std::pow(h / static_cast<double>(harmonics), 4);
    }
    if (!system.factor(0))
        fail(Status::internal, "the mean cycle of {} rows has no fit", count);
    Matrix inverse(terms, terms); // symmetric and small, whereas there may be many columns
    for (std::int64_t r = 0; r < terms; ++r)
        inverse(r, r) = 1;
    system.solve(inverse.view(), {});
    Loop loop{Matrix(terms, rows.cols)};
    for (std::int64_t r = 0; r < terms; ++r) {
        add_weighted(right.view(), inverse.row(r), 1, loop.coefficients.row(r));
        checkpoint(terms * rows.cols);
    }
    return loop;
}

std::int64_t harmonics_for(double period) {
    return std::clamp(static_cast<std::int64_t>(period / 3), least_harmonics, most_harmonics);
}

} // namespace stltsa::motion
