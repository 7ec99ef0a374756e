// SPDX-License-Identifier: BSD-3-Clause
// Compiled, never run: the C++ header is the first and only include, and comes twice.
#include <stltsa.hpp>

#include <stltsa.hpp>

std::string name_of(const stltsa::Error& error);
std::string name_of(const stltsa::Error& error) {
    return error.name();
}
