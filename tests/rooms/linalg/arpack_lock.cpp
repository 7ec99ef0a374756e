// SPDX-License-Identifier: BSD-3-Clause
// Several threads that solve eigenproblems at the same time get the same eigenpairs as one thread.
// The build with STLTSA_TEST_WITHOUT_ARPACK_LOCK must fail, because ARPACK keeps its state in
// static variables. The alarm is for that build, which may never end.
#ifdef STLTSA_TEST_WITHOUT_ARPACK_LOCK
#include "linalg/arpack.cpp" // instead of the one in the library
#else
#include "linalg/arpack.hpp"
#endif

#include <atomic>
#include <cmath>
#include <cstdio>
#include <span>
#include <thread>
#include <vector>

#include <unistd.h>

#include "checkpoints.hpp"

namespace {

using stltsa::Eigenpairs;

/// A diagonal matrix with a few large entries; too large for the dense solver.
Eigenpairs eigenpairs(int order) {
    return stltsa::largest_eigenpairs(
        [order](std::span<const double> x, std::span<double> y) {
            for (std::size_t i = 0; i < x.size(); ++i)
                y[i] = x[i] * (1 + 1 / (0.01 + static_cast<double>(i) / order));
        },
        order,
        [](std::span<double> x) {
            for (std::size_t i = 0; i < x.size(); ++i)
                x[i] = std::cos(static_cast<double>(i));
        },
        3);
}

bool same(const Eigenpairs& a, const Eigenpairs& b) {
    bool equal = a.values == b.values && a.vectors.cols() == b.vectors.cols();
    for (std::int64_t i = 0; equal && i < a.vectors.rows() * a.vectors.cols(); ++i)
        equal = a.vectors.data()[i] == b.vectors.data()[i];
    return equal;
}

} // namespace

int main() {
    ::alarm(60);
    constexpr int threads = 4, rounds = 10;
    std::atomic<int> wrong{0};
    const auto solve = [&wrong](int order, const Eigenpairs& expected) {
        // Other threads run between two of ARPACK's calls.
        const testing::Answering yielding([] { std::this_thread::yield(); });
        for (int round = 0; round < rounds; ++round)
            try {
                wrong += !same(eigenpairs(order), expected);
            } catch (const std::exception&) {
                ++wrong;
            }
    };
    std::vector<Eigenpairs> expected;
    for (int t = 0; t < threads; ++t)
        expected.push_back(eigenpairs(200 + 37 * t));
    std::vector<std::thread> running;
    for (int t = 0; t < threads; ++t)
        running.emplace_back(solve, 200 + 37 * t, std::cref(expected[static_cast<std::size_t>(t)]));
    for (std::thread& thread : running)
        thread.join();
    std::printf("%d of %d eigenproblems are wrong\n", wrong.load(), threads * rounds);
    return wrong.load() == 0 ? 0 : 1;
}
