// SPDX-License-Identifier: BSD-3-Clause
#include "gait.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

namespace walker {
namespace {

struct Key {
    double phase;
    double degrees;
};

/// Periodic cubic spline (period 1) through keys with ascending phases in [0, 1).
class Curve {
  public:
    Curve(std::initializer_list<Key> keys) : keys_(keys), bend_(keys.size()) {
        // Solves for the second derivatives. The system is diagonally dominant, so every sweep at
        // least halves the error.
        for (int sweep = 0; sweep < 60; ++sweep)
            for (std::size_t i = 0; i < keys_.size(); ++i) {
                const std::size_t before = (i + keys_.size() - 1) % keys_.size();
                const double a = width(before);
                const double b = width(i);
                const double change = rise(i) / b - rise(before) / a;
                bend_[i] = (6 * change - a * bend_[before] - b * bend_[next(i)]) / (2 * (a + b));
            }
    }

    double operator()(double phase) const {
        const double p = phase - std::floor(phase);
        std::size_t i = keys_.size() - 1;
        while (i > 0 && keys_[i].phase > p)
            --i;
        const double h = width(i);
        const double u = (p - keys_[i].phase) / h;
        const double v = 1 - u;
        return v * keys_[i].degrees + u * keys_[next(i)].degrees -
               h * h / 6 * u * v * ((1 + v) * bend_[i] + (1 + u) * bend_[next(i)]);
    }

  private:
    std::size_t next(std::size_t i) const { return (i + 1) % keys_.size(); }
    double width(std::size_t i) const {
        return keys_[next(i)].phase - keys_[i].phase + (next(i) == 0 ? 1 : 0);
    }
    double rise(std::size_t i) const { return keys_[next(i)].degrees - keys_[i].degrees; }

    std::vector<Key> keys_;
    std::vector<double> bend_;
};

// Key points of one cycle; README.md lists their sources.
const Curve thigh_curve{{0.00, 23},  {0.06, 23},    {0.12, 21.5}, {0.31, -1.5},
                        {0.42, -12}, {0.50, -17.5}, {0.56, -17},  {0.62, -10.5},
                        {0.75, 16},  {0.86, 26.5},  {0.94, 24}};
const Curve knee{{0.00, 2.5}, {0.06, 11},   {0.14, 20},   {0.31, 6},  {0.40, 3.5},
                 {0.50, 9.5}, {0.62, 35.5}, {0.73, 61.5}, {0.86, 28}, {0.96, 2}};
const Curve foot{{0.00, 20.5},  {0.04, 7.5},   {0.09, 0},    {0.13, 0},     {0.20, 0},
                 {0.26, 0},     {0.32, 0},     {0.42, -5},   {0.50, -10.5}, {0.56, -29},
                 {0.62, -63.5}, {0.67, -67.5}, {0.84, -6.5}, {0.94, 17.5}};
// While the heel rises, this mirrors the foot's curve, so that the toes stay on the floor.
const Curve toes{{0.00, 18}, {0.04, 8},  {0.09, 0},  {0.13, 0},    {0.20, 0},
                 {0.26, 0},  {0.32, 0},  {0.42, 5},  {0.50, 10.5}, {0.56, 29},
                 {0.62, 56}, {0.70, 40}, {0.81, 15}, {0.92, 16}};

/// A cosine over the cycle, or over half of it, with its peak at the given phase.
double wave(double phase, double peak, double harmonic = 1) {
    return std::cos(2 * std::numbers::pi * harmonic * (phase - peak));
}

} // namespace

LegAngles leg_angles(double phase) {
    return {thigh_curve(phase), knee(phase), foot(phase), toes(phase), 1.5 * wave(phase, 0.3)};
}

ArmAngles arm_angles(double phase) {
    return {-8 - 16 * wave(phase, 0), 32 - 12 * wave(phase, 0)};
}

TrunkAngles trunk_angles(double phase) {
    return {4.5 * wave(phase, 0.13), 5 * wave(phase, 0),  2 + wave(phase, 0.05, 2),
            1 * wave(phase, 0.3),    -4 * wave(phase, 0), 2 + 1.5 * wave(phase, 0.1, 2)};
}

} // namespace walker
