// SPDX-License-Identifier: BSD-3-Clause
// Shows the allocations of other libraries that end the process if they fail (docs/robustness.md).
// Each of them fails in a process of its own; the program prints how these ended.
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <fcntl.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include "allocations.hpp"
#include "stltsa.h"

namespace {

// Exit statuses of the processes, apart from those of a library that exits.
constexpr int complete = 100;       ///< no allocation failed
constexpr int has_result = 101;     ///< the call succeeded although one failed
constexpr int returned_error = 102; ///< the call returned a status

int fit(std::int64_t rows, std::int64_t columns, int mode) {
    std::vector<double> x;
    for (std::int64_t i = 0; i < rows; ++i)
        for (std::int64_t c = 0; c < columns; ++c)
            x.push_back(std::sin(0.2 * static_cast<double>(i + c)) +
                        0.1 * std::sin(37.0 * static_cast<double>(i * i)));
    const stltsa_in in = {x.data(), rows, columns, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = nullptr;
    stltsa_model* model = nullptr;
    if (stltsa_options_new(&options) != STLTSA_OK ||
        stltsa_options_set_int(options, STLTSA_OPT_MODE, mode) != STLTSA_OK)
        return 1;
    const stltsa_status status = stltsa_fit(&in, nullptr, options, &model);
    stltsa_model_free(model);
    stltsa_options_free(options);
    return status;
}

/// Runs the task in a process of its own; returns how that ended.
template <class Task>
std::string ending_of(const Task& task) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child < 0) {
        std::perror("fork");
        std::exit(1);
    }
    if (child == 0) {
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, STDERR_FILENO);
        ::_exit(task());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status))
        return WTERMSIG(status) == SIGSEGV   ? "SIGSEGV"
               : WTERMSIG(status) == SIGABRT ? "SIGABRT"
                                             : "signal " + std::to_string(WTERMSIG(status));
    switch (WEXITSTATUS(status)) {
    case complete:
        return "complete";
    case has_result:
        return "result";
    case returned_error:
        return "error";
    default:
        return "exit status " + std::to_string(WEXITSTATUS(status));
    }
}

std::string sentence(const char* call, const std::map<std::string, int>& endings) {
    std::string text;
    for (const auto& [ending, count] : endings)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " x " + ending;
    return std::string(call) + ": " + (text.empty() ? "no allocation" : text);
}

/// Makes each allocation of the library during a fit fail in turn.
std::string fail_in_turn(Spared& library, const char* call, std::int64_t rows, std::int64_t columns,
                         int mode) {
    std::map<std::string, int> endings;
    for (std::int64_t n = 0;; ++n) {
        const std::string ending = ending_of([&] {
            library.until_failure = n;
            const int status = fit(rows, columns, mode);
            if (library.until_failure.load() >= 0)
                return complete;
            return status == STLTSA_OK ? has_result : returned_error;
        });
        if (ending == "complete")
            break;
        ++endings[ending];
    }
    return sentence(call, endings);
}

void* throw_once(void*) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    no_memory = true;
    try {
        ::pthread_once(&once, [] { throw 1; }); // as std::call_once, if its function throws
    } catch (int) {
    }
    no_memory = false;
    return nullptr;
}

int start_thread() {
    pthread_t thread;
    if (::pthread_create(&thread, nullptr, throw_once, nullptr) != 0)
        return returned_error;
    ::pthread_join(thread, nullptr);
    return has_result;
}

} // namespace

int main() {
    ::dl_iterate_phdr(find_spared, nullptr);
    const std::string openblas =
        fail_in_turn(spared[0], "OpenBLAS, fit of 40 x 4", 40, 4, STLTSA_MODE_TEMPORAL);
    const std::string libgomp = fail_in_turn(spared[1], "libgomp, fit of 200 x 2 in mode recurrent",
                                             200, 2, STLTSA_MODE_RECURRENT);
    const std::string glibc =
        sentence("glibc, exception through pthread_once", {{ending_of(start_thread), 1}});
    std::printf("%s; %s; %s\n", openblas.c_str(), libgomp.c_str(), glibc.c_str());
    return 0;
}
