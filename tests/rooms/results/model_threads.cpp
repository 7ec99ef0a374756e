// SPDX-License-Identifier: BSD-3-Clause
// Several threads use a model for the first time at once.
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "assertions.hpp"
#include "stltsa.h"

namespace {

constexpr std::int64_t rows = 2000, cols = 3;

std::vector<double> spiral() {
    std::vector<double> x;
    for (std::int64_t i = 0; i < rows; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / 200;
        x.insert(x.end(), {std::cos(t), std::sin(t), 0.1 * t});
    }
    return x;
}

stltsa_in frames_of(const std::vector<double>& x) {
    return {x.data(), rows, cols, 0, 0, STLTSA_F64, 0};
}

stltsa_model* fitted(const std::vector<double>& x) {
    const stltsa_in frames = frames_of(x);
    stltsa_model* model = nullptr;
    assert_int_equal(stltsa_fit(&frames, nullptr, nullptr, &model), STLTSA_OK);
    return model;
}

std::vector<double> mapped(const stltsa_model* model, const std::vector<double>& x) {
    std::vector<double> y(rows * 2);
    const stltsa_in frames = frames_of(x);
    const stltsa_out coords{y.data(), rows, 2, 0, 0, STLTSA_F64, 0};
    if (stltsa_map(model, &frames, nullptr, nullptr, &coords, nullptr, nullptr) != STLTSA_OK)
        y.clear();
    return y;
}

void several_threads_map_first(void**) {
    const std::vector<double> x = spiral();
    std::vector<double> beside = x;
    for (double& value : beside)
        value += 1e-3;
    stltsa_model* alone = fitted(x);
    const std::vector<double> expected = mapped(alone, beside);
    stltsa_model_free(alone);
    assert_false(expected.empty());
    for (int repeat = 0; repeat < 5; ++repeat) {
        stltsa_model* model = fitted(x);
        std::vector<std::vector<double>> results(4);
        std::vector<std::thread> threads;
        for (std::vector<double>& result : results)
            threads.emplace_back([&] { result = mapped(model, beside); });
        for (std::thread& thread : threads)
            thread.join();
        for (const std::vector<double>& result : results)
            assert_true(result == expected);
        stltsa_model_free(model);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {cmocka_unit_test(several_threads_map_first)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
