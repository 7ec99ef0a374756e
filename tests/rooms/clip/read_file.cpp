// SPDX-License-Identifier: BSD-3-Clause
// Files that arrive slowly while signals interrupt.
#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include "clip/testing.hpp"

namespace {

using namespace clip_testing;

void ignore_signal(int) {}

/// Without SA_RESTART: waiting calls end with EINTR.
void end_waits_by(int signal) {
    struct sigaction action {};
    action.sa_handler = ignore_signal;
    assert_int_equal(sigaction(signal, &action, nullptr), 0);
}

/// Writes in pieces, and sends a signal to the waiting thread before each piece.
class SlowWriter {
  public:
    explicit SlowWriter(std::string path)
        : path_(std::move(path)), reader_(pthread_self()), thread_([this] { write(); }) {}
    ~SlowWriter() { thread_.join(); }

  private:
    void disturb() const {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        pthread_kill(reader_, SIGUSR1);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    void write() const {
        disturb(); // during open
        const int pipe = ::open(path_.c_str(), O_WRONLY | O_NONBLOCK);
        if (pipe < 0)
            return; // the reader gave up
        bool written = true;
        for (const std::string_view piece : {"1,2\n3,", "4\n5,6\n"}) {
            written = written && ::write(pipe, piece.data(), piece.size()) ==
                                     static_cast<ssize_t>(piece.size());
            disturb(); // during read
        }
        ::close(pipe);
    }

    const std::string path_;
    const pthread_t reader_;
    std::thread thread_;
};

void signals_do_not_end_reading(void**) {
    end_waits_by(SIGUSR1);
    const TemporaryFolder folder;
    const std::string pipe = folder.path("slow.csv");
    assert_int_equal(mkfifo(pipe.c_str(), 0600), 0);
    const SlowWriter writer(pipe);
    const Clip clip = stltsa::clip::read(pipe, {});
    assert_int_equal(clip.frames(), 3);
    assert_true(clip.values(2, 1) == 6);
}

/// A caller may want to stop at a signal.
void a_signal_lets_the_caller_stop(void**) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path("slow.csv");
    assert_int_equal(mkfifo(pipe.c_str(), 0600), 0);
    end_waits_by(SIGUSR1);
    stltsa::clip::ReadOptions options;
    options.progress = stltsa::Progress([](void*, std::int32_t, double) { return 1; }, nullptr);
    const SlowWriter writer(pipe);
    ASSERT_FAILS(Status::cancelled, "cancelled", stltsa::clip::read(pipe, options));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(signals_do_not_end_reading),
        cmocka_unit_test(a_signal_lets_the_caller_stop),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
