/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes the coordinates of a clip's model, computed in C, to stdout as doubles. */
#include <stdio.h>
#include <stdlib.h>
#include <stltsa.h>

static int give_up(void) {
    fprintf(stderr, "%s\n", stltsa_last_error());
    return 1;
}

int main(int argc, char** argv) {
    stltsa_clip* clip = NULL;
    stltsa_model* model = NULL;
    int64_t rows = 0, cols = 0;
    if (argc != 2)
        return 2;
    if (stltsa_clip_open(argv[1], NULL, &clip) != STLTSA_OK ||
        stltsa_fit_clips((const stltsa_clip* const*)&clip, 1, NULL, &model) != STLTSA_OK ||
        stltsa_info_shape(stltsa_model_info(model), STLTSA_INFO_COORDS, &rows, &cols) != STLTSA_OK)
        return give_up();
    double* coords = malloc((size_t)(rows * cols) * sizeof *coords);
    const stltsa_out out = {coords, rows, cols, 0, 0, STLTSA_F64, 0};
    if (coords == NULL ||
        stltsa_info_array(stltsa_model_info(model), STLTSA_INFO_COORDS, 0, &out) != STLTSA_OK)
        return give_up();
    fwrite(coords, sizeof *coords, (size_t)(rows * cols), stdout);
    free(coords);
    stltsa_model_free(model);
    stltsa_clip_free(clip);
    return 0;
}
