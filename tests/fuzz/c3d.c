/* SPDX-License-Identifier: BSD-3-Clause */
#include "target.h"

int accepted_inputs;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    read_as(STLTSA_FORMAT_C3D, data, size);
    return 0;
}
