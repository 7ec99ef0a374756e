// SPDX-License-Identifier: BSD-3-Clause
// From C++: handles in std::unique_ptr, failures as exceptions. C++11 is enough.
//
//     c++ raii.cpp $(pkg-config --cflags --libs stltsa) -o raii
//     ./raii walk.bvh
#include <cstdint>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>

#include <stltsa.h>

namespace {

struct Deleter {
    void operator()(stltsa_options* options) const { stltsa_options_free(options); }
    void operator()(stltsa_clip* clip) const { stltsa_clip_free(clip); }
    void operator()(stltsa_decomposition* result) const { stltsa_decomposition_free(result); }
};
template <class T>
using Handle = std::unique_ptr<T, Deleter>;

void check(stltsa_status status) {
    if (status != STLTSA_OK)
        throw std::runtime_error(std::string(stltsa_status_name(status)) + ": " +
                                 stltsa_last_error());
}

Handle<stltsa_options> one_thread() {
    stltsa_options* options = nullptr;
    check(stltsa_options_new(&options));
    Handle<stltsa_options> owner(options); // owned before the next call can fail
    check(stltsa_options_set_int(options, STLTSA_OPT_THREADS, 1));
    return owner;
}

Handle<stltsa_clip> open(const std::string& path) {
    stltsa_clip* clip = nullptr;
    check(stltsa_clip_open(path.c_str(), nullptr, &clip));
    return Handle<stltsa_clip>(clip);
}

Handle<stltsa_decomposition> decompose(const stltsa_clip& clip, const stltsa_options& options) {
    stltsa_decomposition* result = nullptr;
    check(stltsa_decompose(&clip, &options, &result));
    return Handle<stltsa_decomposition>(result);
}

double period(const stltsa_decomposition& result) {
    double seconds = 0;
    check(stltsa_decomposition_get_real(&result, STLTSA_DECOMPOSITION_PERIOD, &seconds));
    return seconds;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: " << argv[0] << " CLIP\n";
        return 2;
    }
    try {
        const auto clip = open(argv[1]);
        const auto units = decompose(*clip, *one_thread());
        for (std::int64_t i = 0; i < stltsa_decomposition_unit_count(units.get()); ++i) {
            stltsa_interval unit;
            check(stltsa_decomposition_unit(units.get(), i, &unit));
            std::cout << stltsa_unit_name(unit.kind) << ' ' << unit.begin_s << " s to "
                      << unit.end_s << " s\n";
        }
        std::cout << stltsa_decomposition_cycle_count(units.get()) << " cycles, period "
                  << period(*units) << " s\n";
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
