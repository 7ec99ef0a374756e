/* SPDX-License-Identifier: BSD-3-Clause */
#include "target.h"

int accepted_inputs;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    read_as(STLTSA_FORMAT_CSV, data, size);
    read_with(NULL, STLTSA_FORMAT_CSV, data, size); /* at its times */
    return 0;
}
