// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints that a test answers itself.
#pragma once

#include <functional>
#include <utility>

#include "base/checkpoint.hpp"
#include "base/error.hpp"

namespace testing {

/// Calls a function at each checkpoint of this thread; it may throw.
class Answering final : public stltsa::Checkpoints {
  public:
    explicit Answering(std::function<void()> answer)
        : Checkpoints(true), answer_(std::move(answer)) {
        count_again();
    }
    void check() override { answer_(); }

  private:
    std::function<void()> answer_;
};

/// How often the work asks whether to go on.
template <class Work>
int checkpoints_of(const Work& work) {
    int count = 0;
    const Answering counting([&] { ++count; });
    work();
    return count;
}

/// Cancels the work at its n-th checkpoint.
template <class Work>
void cancel_at(int n, const Work& work) {
    const Answering cancelling([&] {
        if (--n == 0)
            stltsa::fail(stltsa::Status::cancelled, "cancelled");
    });
    work();
}

/// Whether the work ends at its n-th checkpoint if it is cancelled there.
template <class Work>
bool ends_at(int n, const Work& work) {
    int count = 0;
    const Answering cancelling([&] {
        if (++count >= n)
            stltsa::fail(stltsa::Status::cancelled, "cancelled");
    });
    try {
        work();
        return false;
    } catch (const stltsa::Error& error) {
        return error.status() == stltsa::Status::cancelled && count == n;
    }
}

} // namespace testing
