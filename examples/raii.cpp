// SPDX-License-Identifier: BSD-3-Clause
// From C++20: stltsa.hpp owns the handles and throws failures.
//
//     c++ -std=c++20 raii.cpp $(pkg-config --cflags --libs stltsa) -o raii
//     ./raii walk.bvh
#include <exception>
#include <iostream>

#include <stltsa.hpp>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: " << argv[0] << " CLIP\n";
        return 2;
    }
    try {
        stltsa::Options options;
        options.set(STLTSA_OPT_THREADS, 1);
        const stltsa::Clip clip = stltsa::Clip::open(argv[1]);
        const stltsa::Decomposition found = stltsa::decompose(clip, options);
        for (const stltsa::Unit& unit : found.units())
            std::cout << stltsa::unit_name(unit.kind) << ' ' << unit.begin_s << " s to "
                      << unit.end_s << " s\n";
        std::cout << found.cycles().size() << " cycles, period "
                  << found.info().real(STLTSA_INFO_PERIOD) << " s\n";
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
