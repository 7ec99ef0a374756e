/* SPDX-License-Identifier: BSD-3-Clause */
/* An ASF file, a zero, and an AMC file. */
#define _GNU_SOURCE
#include <sys/mman.h>
#include <unistd.h>

#include "target.h"

int accepted_inputs;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const uint8_t* zero = size == 0 ? NULL : memchr(data, 0, size);
    const size_t asf = zero == NULL ? size : (size_t)(zero - data);
    const size_t amc = zero == NULL ? size : asf + 1;
    const int file = memfd_create("skeleton.asf", 0);
    char path[64];
    stltsa_options* options = NULL;
    stltsa_clip* clip = NULL;
    if (file < 0)
        return 0;
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    if (write(file, data, asf) == (ssize_t)asf && stltsa_options_new(&options) == STLTSA_OK) {
        stltsa_options_set_text(options, STLTSA_OPT_SKELETON, path);
        MAKES(stltsa_clip_parse(data + amc, size - amc, STLTSA_FORMAT_AMC, NULL, options, &clip),
              clip);
        if (clip != NULL) {
            ++accepted_inputs;
            use_clip(clip);
        }
    }
    stltsa_clip_free(clip);
    stltsa_options_free(options);
    close(file);
    return 0;
}
