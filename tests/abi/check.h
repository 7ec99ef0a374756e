/* SPDX-License-Identifier: BSD-3-Clause */
/* What the programs of all versions share. Include it after the stltsa.h of the version. */
#include <stdio.h>

typedef void (*function)(void);

static int failures = 0;

static void check(int true_value, const char* text) {
    if (!true_value) {
        fprintf(stderr, "not so: %s (%s)\n", text, stltsa_last_error());
        ++failures;
    }
}
#define CHECK(what) check(what, #what)
#define MUST(call) check((call) == STLTSA_OK, #call)
