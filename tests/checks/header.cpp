// SPDX-License-Identifier: BSD-3-Clause
// Compiled but never run: includes only the C++ header, twice.
#include <stltsa.hpp>

#include <stltsa.hpp>

std::string name_of(const stltsa::Error& error);
std::string name_of(const stltsa::Error& error) {
    return error.name();
}
