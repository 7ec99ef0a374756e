/* SPDX-License-Identifier: BSD-3-Clause */
/* Compiled but never run: includes only the header, twice. */
#include <stltsa.h>

#include <stltsa.h>

/* Frozen layouts (64-bit). A negative array size fails to compile in every C and C++. */
#define HOLDS(name, condition) typedef char name[(condition) ? 1 : -1]
HOLDS(size_of_in, sizeof(void*) != 8 || sizeof(stltsa_in) == 48);
HOLDS(size_of_out, sizeof(void*) != 8 || sizeof(stltsa_out) == 48);
HOLDS(size_of_interval, sizeof(stltsa_interval) == 32);
HOLDS(size_of_piece, sizeof(void*) != 8 || sizeof(stltsa_piece) == 40);
HOLDS(size_of_statistics, sizeof(stltsa_statistics) == 40);
HOLDS(size_of_estimate, sizeof(stltsa_estimate) == 72);
HOLDS(size_of_bounded, sizeof(stltsa_bounded) == 24);
HOLDS(size_of_status, sizeof(stltsa_status) == 4);

const char* name_of(stltsa_status status);
const char* name_of(stltsa_status status) {
    return stltsa_status_name(status);
}
