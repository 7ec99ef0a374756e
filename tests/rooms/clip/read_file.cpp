// SPDX-License-Identifier: BSD-3-Clause
// Files that arrive slowly while signals interrupt, and large ones.
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

/// A progress callback that cancels at its n-th call.
struct Canceller {
    int calls; ///< left
    stltsa::clip::ReadOptions options() {
        stltsa::clip::ReadOptions made;
        made.progress = stltsa::Progress(
            [](void* user, std::int32_t, double) {
                return --static_cast<Canceller*>(user)->calls == 0 ? 1 : 0;
            },
            this);
        return made;
    }
};

std::string repeated(std::string_view row, std::size_t bytes) {
    std::string text;
    while (text.size() < bytes)
        text += row;
    return text;
}

/// Each text has 3 MB, and an error that is found at its end, unless the reading is cancelled.
void reading_a_large_text_can_be_cancelled(void**) {
    constexpr std::size_t size = 3 << 20;
    const TemporaryFolder folder;
    const std::string asf = folder.write("small.asf", small_asf);
    const std::string large_asf = folder.write("large.asf", repeated("# comment\n", size));
    const std::string amc = ":DEGREES\n" + repeated("# comment\n", size);
    const std::string bvh = small_bvh + repeated("0 0 0 0 0 0 0 0 0 0\n", size);
    struct Case {
        Format format;
        std::string text, skeleton;
        int calls;
    } const cases[] = {{Format::csv, repeated("1,2,3\n", size) + "x\n", "", 2},
                       {Format::bvh, bvh, "", 2},
                       {Format::amc, amc, asf, 2},
                       {Format::amc, amc, large_asf, 50}}; // 48 while the skeleton's file is read
    for (const Case& one : cases) {
        Canceller canceller{one.calls};
        auto options = canceller.options();
        options.skeleton = one.skeleton;
        ASSERT_FAILS(Status::cancelled, "cancelled",
                     stltsa::clip::parse(one.text, one.format, "large", options));
    }
}

void reading_a_large_file_can_be_cancelled(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.write("large.csv", repeated("1,2,3\n", 1 << 20));
    Canceller canceller{10}; // parsing calls it once
    ASSERT_FAILS(Status::cancelled, "cancelled", stltsa::clip::read(path, canceller.options()));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(signals_do_not_end_reading),
        cmocka_unit_test(a_signal_lets_the_caller_stop),
        cmocka_unit_test(reading_a_large_text_can_be_cancelled),
        cmocka_unit_test(reading_a_large_file_can_be_cancelled),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
