// SPDX-License-Identifier: BSD-3-Clause
// Files whose writers or readers end early.
#include "checkpoints.hpp"
#include "clip/testing.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "clip/files/read_file.hpp"
#include "clip/files/replace_file.hpp"
#include "clip/files/write_file.hpp"

namespace {

using namespace clip_testing;
using namespace stltsa::clip;
namespace fs = std::filesystem;

std::string steps; ///< the steps of a write that protect against a power failure

} // namespace

// These take the place of the functions of the C library in this program.
extern "C" int fsync(int file) {
    struct stat status {};
    ::fstat(file, &status);
    steps += S_ISDIR(status.st_mode) ? "flush folder, " : "flush file, ";
    return static_cast<int>(::syscall(SYS_fsync, file));
}
extern "C" int rename(const char* from, const char* to) noexcept {
    steps += "rename, ";
    return ::renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace {

std::string content_of(const std::string& path) {
    return read_file(path);
}

std::int64_t files_in(const std::string& folder) {
    return std::distance(fs::directory_iterator(folder), {});
}

/// A process that writes two contents in turn until it is killed.
pid_t writer(const std::string& path, const std::string& a, const std::string& b) {
    const pid_t child = ::fork();
    if (child == 0)
        for (;;) {
            write_file(path, a);
            write_file(path, b);
        }
    return child;
}

void a_killed_writer_leaves_one_of_the_two(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.path("a"), a(300'000, 'a'), b(200'000, 'b');
    write_file(path, a);
    std::mt19937 random(1);
    int changed = 0;
    std::string before = a;
    for (int round = 0; round < 50; ++round) {
        const pid_t child = writer(path, a, b);
        ::usleep(static_cast<useconds_t>(random() % 40000));
        assert_int_equal(::kill(child, SIGKILL), 0);
        assert_int_equal(::waitpid(child, nullptr, 0), child);
        const std::string now = content_of(path);
        assert_true(now == a || now == b);
        changed += now != before;
        before = now;
    }
    assert_true(changed > 0); // otherwise nothing was written
}

void what_killed_writers_left_is_deleted(void**) {
    const TemporaryFolder folder;
    const pid_t gone = ::fork();
    if (gone == 0)
        ::_exit(0);
    assert_int_equal(::waitpid(gone, nullptr, 0), gone);
    const auto old = [&](const std::string& name) {
        const std::string path = folder.write(name, "x");
        fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(2));
        return path;
    };
    const std::string left = old(stltsa::format_text(".stltsa-{}-0.tmp", gone));
    const std::string of_amc = old(stltsa::format_text(".stltsa-{}-1.tmp.asf", gone));
    const std::string mine = old(stltsa::format_text(".stltsa-{}-7.tmp", ::getpid()));
    const std::string foreign = old(".stltsa-notes.tmp");
    const std::string young = folder.write(stltsa::format_text(".stltsa-{}-2.tmp", gone), "x");
    const std::string link = folder.path(stltsa::format_text(".stltsa-{}-3.tmp", gone));
    fs::create_symlink(foreign, link);
    write_file(folder.path("a"), "new");
    assert_true(!fs::exists(left) && !fs::exists(of_amc));
    assert_true(fs::exists(mine) && fs::exists(foreign) && fs::exists(young));
    assert_true(fs::is_symlink(link));
    assert_int_equal(files_in(folder.path("")), 5);
}

void a_pipe_whose_reader_left_is_an_error(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.path("pipe"), bytes(1 << 20, 'x'); // more than a pipe holds
    assert_int_equal(::mkfifo(path.c_str(), 0600), 0);
    (void)std::signal(SIGPIPE, SIG_DFL); // a SIGPIPE would end this program
    const pid_t reader = ::fork();
    if (reader == 0) {
        char byte = 0;
        const int pipe = ::open(path.c_str(), O_RDONLY);
        ::_exit(::read(pipe, &byte, 1) == 1 ? 0 : 1);
    }
    ASSERT_FAILS(Status::io, "pipe: cannot write: Broken pipe", write_file(path, bytes));
    assert_int_equal(::waitpid(reader, nullptr, 0), reader);
    sigset_t pending, blocked;
    assert_int_equal(::sigpending(&pending), 0);
    assert_int_equal(::sigismember(&pending, SIGPIPE), 0);
    assert_int_equal(::pthread_sigmask(SIG_BLOCK, nullptr, &blocked), 0);
    assert_int_equal(::sigismember(&blocked, SIGPIPE), 0);
}

/// No signal ends these waits.
void a_wait_for_a_reader_can_be_cancelled(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.path("pipe"), bytes(1 << 20, 'x'); // more than a pipe holds
    assert_int_equal(::mkfifo(path.c_str(), 0600), 0);
    ::alarm(20);
    for (const bool opened : {false, true}) {
        const int reader = opened ? ::open(path.c_str(), O_RDONLY | O_NONBLOCK) : -1;
        ASSERT_FAILS(Status::cancelled, "cancelled",
                     testing::cancel_at(3, [&] { write_file(path, bytes); }));
        ::close(reader);
    }
    ::alarm(0);
}

/// There is a checkpoint before each wait.
void a_slow_reader_gets_all_bytes(void**) {
    const TemporaryFolder folder;
    const std::string path = folder.path("pipe");
    std::string bytes;
    while (bytes.size() < (1 << 20))
        bytes += stltsa::format_text("{},", bytes.size());
    assert_int_equal(::mkfifo(path.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        received = content_of(path);
    });
    const int checkpoints = testing::checkpoints_of([&] { write_file(path, bytes); });
    reader.join();
    assert_true(received == bytes);
    assert_true(checkpoints >= 3);
}

void the_bytes_are_on_the_disk_before_the_name(void**) {
    const TemporaryFolder folder;
    steps.clear();
    write_file(folder.path("a"), "new");
    assert_string_equal(steps.c_str(), "flush file, rename, flush folder, ");
}

void a_dangling_link_is_followed(void**) {
    const TemporaryFolder folder;
    fs::create_symlink("target", folder.path("link"));
    write_file(folder.path("link"), "new");
    assert_true(fs::is_symlink(folder.path("link")));
    assert_true(content_of(folder.path("target")) == "new");
    // A link that points to itself is never resolved.
    fs::create_symlink("loop", folder.path("loop"));
    ASSERT_FAILS(Status::io, "cannot write", write_file(folder.path("loop"), "new"));
}

/// Another user of the folder may put a link in the place of the temporary file.
void a_link_instead_of_the_temporary_file_is_not_followed(void**) {
    const TemporaryFolder folder;
    write_file(folder.path("victim"), "precious");
    TemporaryFile file(folder.path("new"));
    fs::remove(file.name());
    fs::create_symlink(folder.path("victim"), file.name());
    const auto fails = [](const auto& work) {
        try {
            work();
            return false;
        } catch (const std::system_error&) {
            return true;
        }
    };
    assert_true(fails([&] { file.write([](const auto& sink) { sink("new"); }); }));
    assert_true(fails([&] { file.move_to_place(); }));
    assert_true(content_of(folder.path("victim")) == "precious");
    assert_false(fs::exists(folder.path("new")));
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_killed_writer_leaves_one_of_the_two),
        cmocka_unit_test(what_killed_writers_left_is_deleted),
        cmocka_unit_test(a_pipe_whose_reader_left_is_an_error),
        cmocka_unit_test(a_wait_for_a_reader_can_be_cancelled),
        cmocka_unit_test(a_slow_reader_gets_all_bytes),
        cmocka_unit_test(the_bytes_are_on_the_disk_before_the_name),
        cmocka_unit_test(a_dangling_link_is_followed),
        cmocka_unit_test(a_link_instead_of_the_temporary_file_is_not_followed),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
