/* SPDX-License-Identifier: BSD-3-Clause */
/* Plays files to a fuzz target, for compilers without libFuzzer; fails if a file is refused, unless
 * its name begins with "refused". Usage: fuzz_bvh FILE... */
#include "target.h"

static int play(const char* path) {
    FILE* file = fopen(path, "rb");
    uint8_t* data = NULL;
    long size = -1;
    if (file != NULL && fseek(file, 0, SEEK_END) == 0 && (size = ftell(file)) >= 0) {
        rewind(file);
        data = malloc((size_t)size + 1);
    }
    const int before = accepted_inputs;
    int read = data != NULL && fread(data, 1, (size_t)size, file) == (size_t)size;
    if (read)
        LLVMFuzzerTestOneInput(data, (size_t)size);
    else
        fprintf(stderr, "%s: cannot be read\n", path);
    const char* slash = strrchr(path, '/');
    const char* name = slash == NULL ? path : slash + 1;
    if (read && accepted_inputs == before && strncmp(name, "refused", 7) != 0) {
        fprintf(stderr, "%s: refused: %s\n", path, stltsa_last_error());
        read = 0;
    }
    free(data);
    if (file != NULL)
        fclose(file);
    return read;
}

int main(int argc, char** argv) {
    int played = 0;
    for (int i = 1; i < argc; ++i)
        played += play(argv[i]);
    printf("%d of %d files played\n", played, argc - 1);
    return argc > 1 && played == argc - 1 ? 0 : 1;
}
