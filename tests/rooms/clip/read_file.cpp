// SPDX-License-Identifier: BSD-3-Clause
// Pipes whose writers are slow or never come.
#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/progress.hpp"
#include "checkpoints.hpp"
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
    const stltsa::Call call(stltsa::Call::Asked{});
    const Clip clip = stltsa::clip::read(pipe, {});
    assert_int_equal(clip.frames(), 3);
    assert_true(clip.values(2, 1) == 6);
}

/// No signal ends this wait.
void a_wait_for_a_writer_can_be_cancelled(void**) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path("slow.csv");
    assert_int_equal(mkfifo(pipe.c_str(), 0600), 0);
    for (const bool opened : {false, true}) {
        const int writer = opened ? ::open(pipe.c_str(), O_RDWR) : -1;
        ::alarm(20);
        ASSERT_FAILS(Status::cancelled, "cancelled",
                     testing::cancel_at(3, [&] { stltsa::clip::read(pipe, {}); }));
        ::alarm(0);
        ::close(writer);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(signals_do_not_end_reading),
        cmocka_unit_test(a_wait_for_a_writer_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
