// SPDX-License-Identifier: BSD-3-Clause
// Fits that run at once give the same bits as fits that run alone. ARPACK keeps state between its
// calls, so without the lock around a whole eigenproblem this crashes or differs.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

#include "stltsa.h"

namespace {

constexpr std::int64_t frames = 400;
constexpr std::int64_t features = 12;
constexpr std::int64_t dimension = 2;
constexpr int clips = 4;
constexpr int repeats = 30;

/// A smooth motion of its own for each clip.
std::vector<double> motion(int clip) {
    std::vector<double> x;
    for (std::int64_t i = 0; i < frames; ++i)
        for (std::int64_t c = 0; c < features; ++c)
            x.push_back(std::sin(0.01 * static_cast<double>(i * (1 + c % 4)) + 0.7 * clip +
                                 static_cast<double>(c)));
    return x;
}

/// Empty where the fit failed.
std::vector<double> fit(const std::vector<double>& x, std::int64_t threads) {
    const stltsa_in in = {x.data(), frames, features, 0, 0, STLTSA_F64, 0};
    std::vector<double> y(frames * dimension);
    const stltsa_out out = {y.data(), frames, dimension, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = nullptr;
    stltsa_model* model = nullptr;
    const bool good = stltsa_options_new(&options) == STLTSA_OK &&
                      stltsa_options_set_int(options, STLTSA_THREADS, threads) == STLTSA_OK &&
                      stltsa_options_set_int(options, STLTSA_NEIGHBORS, 12) == STLTSA_OK &&
                      stltsa_fit(&in, nullptr, 0, options, &model) == STLTSA_OK &&
                      stltsa_model_coords(model, &out) == STLTSA_OK;
    stltsa_model_free(model);
    stltsa_options_free(options);
    return good ? y : std::vector<double>();
}

} // namespace

int main() {
    std::vector<std::vector<double>> inputs, alone;
    for (int clip = 0; clip < clips; ++clip) {
        inputs.push_back(motion(clip));
        alone.push_back(fit(inputs.back(), 1));
        if (alone.back().empty()) {
            std::printf("a fit alone fails: %s\n", stltsa_last_error());
            return 1;
        }
    }
    std::vector<int> different(clips, 0);
    std::vector<std::thread> threads;
    for (std::size_t clip = 0; clip < clips; ++clip)
        threads.emplace_back([&, clip] {
            for (int i = 0; i < repeats; ++i)
                different[clip] += fit(inputs[clip], 1 + i % 3) != alone[clip];
        });
    int total = 0;
    for (std::size_t clip = 0; clip < clips; ++clip) {
        threads[clip].join();
        total += different[clip];
    }
    std::printf("%d of %d fits at once differ from the fit alone\n", total, clips * repeats);
    return total == 0 ? 0 : 1;
}
