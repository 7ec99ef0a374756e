// SPDX-License-Identifier: BSD-3-Clause
// Reasons and warnings: correct numbers, times in the source, and advice.
#include "motion/testing.hpp"

#include "motion/curve/drift.hpp"
#include "motion/decompose.hpp"

namespace {

using namespace motion_testing;
using namespace stltsa::motion;

Decomposition decomposed(const Matrix& samples, const DecomposeOptions& options = {}) {
    return decompose(samples.view(), 30, options, stltsa::Progress{});
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

Matrix noise_of(std::int64_t samples) {
    Matrix noise(samples, 10);
    add_noise(noise, 1, 2);
    return noise;
}

/// Markers of a body that walks through space at 1.2 per second.
Matrix walk_in_space(double seconds) {
    return sampled(static_cast<std::int64_t>(30 * seconds), 10, 30,
                   [](double t, std::int64_t c) { return 1.2 * t + 0.1 * cyclic_pose(t, c); });
}

void measures_drift(void**) {
    const Matrix line = sampled(
        100, 3, 30, [](double t, std::int64_t c) { return 1e6 + t * static_cast<double>(c); });
    ASSERT_NEAR(drift_share(line.view()), 1, 1e-9);
    const Matrix cycles =
        sampled(300, 10, 30, [](double t, std::int64_t c) { return cyclic_pose(t, c); });
    assert_true(drift_share(cycles.view()) < 0.02);
    assert_true(drift_share(Matrix(50, 2).view()) == 0);
    assert_true(drift_share(walk_in_space(6).view()) > 0.95);
}

void says_that_a_drift_hides_the_period(void**) {
    DecomposeOptions options;
    options.in_space = true;
    const Matrix walk = walk_in_space(6);
    const Decomposition d = decomposed(walk, options);
    assert_true(d.cycles.empty());
    assert_true(holds(d.reason, "linear drift") && holds(d.reason, "subtract"));
    // Not for poses without position, nor without drift.
    assert_false(holds(decomposed(walk).reason, "drift"));
    assert_false(holds(decomposed(noise_of(300), options).reason, "drift"));
}

void says_which_lags_were_searched(void**) {
    // A clip of 4 s is compared with itself at lags up to 70 % of that.
    const auto slow = [](std::int64_t samples) {
        return decomposed(sampled(samples, 3, 30,
                                  [](double t, std::int64_t c) {
                                      return std::exp(0.3 * t) * static_cast<double>(c + 1);
                                  }))
            .reason;
    };
    assert_true(holds(slow(120), "not repeat at any lag from 0.30 s to 2.80 s"));
    assert_true(holds(slow(600), "not repeat at any lag from 0.30 s to 6.00 s"));
    assert_true(holds(slow(12), "lasts 0.40 s, which is too short for a period of 0.30 s"));
}

void says_where_the_curve_is_cut(void**) {
    Matrix cut = noise_of(300);
    for (std::int64_t i = 0; i < 300; ++i)
        for (std::int64_t c = 0; c < 10; ++c)
            cut(i, c) = (i < 200 ? 0 : 1000) + std::sin(0.2 * static_cast<double>(i + c));
    DecomposeOptions options;
    options.neighbors = 10;
    options.first_s = 50;
    bool warned = false;
    for (const stltsa::Warning& warning : decomposed(cut, options).warnings)
        if (warning.code == stltsa::WarningCode::disconnected) {
            warned = holds(warning.text, "cut at 56.67 s");
            ASSERT_NEAR(warning.begin_s, 56.67, 0.005);
            ASSERT_NEAR(warning.end_s, 56.67, 0.005);
        }
    assert_true(warned);
}

void names_the_jump(void**) {
    DecomposeOptions options;
    options.in_space = true;
    options.jump = "frame 7";
    options.jump_s = 107;
    const Decomposition none = decomposed(walk_in_space(6), options);
    assert_true(holds(none.reason, "jumps at frame 7") && !holds(none.reason, "drift"));
    const Decomposition cyclic = decomposed(Exercise{}.samples(30), options);
    assert_true(cyclic.reason.empty());
    assert_true(cyclic.warnings.back().code == stltsa::WarningCode::jump);
    assert_true(cyclic.warnings.back().begin_s == 107);
    assert_true(holds(cyclic.warnings.back().text, "jumps at frame 7"));
}

void names_the_requested_dimension(void**) {
    const Matrix circle = sampled(300, 2, 30, [](double t, std::int64_t c) {
        return c == 0 ? std::cos(turn * t) : std::sin(turn * t);
    });
    DecomposeOptions options;
    options.dimension = 7;
    assert_true(holds(decomposed(circle, options).reason, "7 dimensions"));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(measures_drift),
        cmocka_unit_test(says_that_a_drift_hides_the_period),
        cmocka_unit_test(says_which_lags_were_searched),
        cmocka_unit_test(says_where_the_curve_is_cut),
        cmocka_unit_test(names_the_jump),
        cmocka_unit_test(names_the_requested_dimension),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
