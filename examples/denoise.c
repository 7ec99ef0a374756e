/* SPDX-License-Identifier: BSD-3-Clause */
/* Removes noise from coordinates: prints the error of the smooth curve and of the moved points.
 *
 *     cc denoise.c $(pkg-config --cflags --libs stltsa) -lm -o denoise
 *     ./denoise
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

enum { ROWS = 300 };

static const double fps = 30;

/* One coordinate that swings once per second. */
static double clean(int row) {
    return sin(6.283185307179586 * row / fps);
}

/* The same coordinate with noise, and a spike in every fiftieth row. */
static double noisy(int row) {
    const double noise = 2.0 * rand() / RAND_MAX - 1;
    return clean(row) + 0.2 * noise + (row % 50 == 25 ? 1.5 : 0);
}

/* Root mean square distance from the noiseless coordinate. */
static double error(const double* values) {
    double sum = 0;
    for (int row = 0; row < ROWS; ++row)
        sum += (values[row] - clean(row)) * (values[row] - clean(row));
    return sqrt(sum / ROWS);
}

/* Prints the result; returns STLTSA_OK or the status of the first call that failed. */
static stltsa_status report(const stltsa_denoising* denoising, const double* points) {
    static double cleaned[ROWS], curve[ROWS];
    const stltsa_out cleaned_out = {cleaned, ROWS, 1, 0, 0, STLTSA_F64, 0};
    const stltsa_out curve_out = {curve, ROWS, 1, 0, 0, STLTSA_F64, 0};
    const stltsa_info* info = stltsa_denoising_info(denoising);
    stltsa_denoised_column column;
    stltsa_status status = stltsa_info_array(info, STLTSA_INFO_CLEANED, 0, &cleaned_out);
    if (status == STLTSA_OK)
        status = stltsa_info_array(info, STLTSA_INFO_CURVE, 0, &curve_out);
    if (status == STLTSA_OK)
        status = stltsa_info_rows(info, STLTSA_INFO_COLUMN, 0, 1, &column, sizeof column);
    if (status != STLTSA_OK)
        return status;
    printf("%lld of %d points are farther than %.3f from the curve and were moved\n",
           (long long)column.moved, ROWS, column.gamma);
    printf("error: points %.3f, moved points %.3f, curve %.3f\n", error(points), error(cleaned),
           error(curve));
    return STLTSA_OK;
}

int main(void) {
    static double points[ROWS];
    const stltsa_in in = {points, ROWS, 1, 0, 0, STLTSA_F64, 0};
    stltsa_options* options = NULL;
    stltsa_denoising* denoising = NULL;
    stltsa_status status;

    for (int row = 0; row < ROWS; ++row)
        points[row] = noisy(row);

    /* If the frame rate is known, the period determines the finest detail of the curve. */
    status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = stltsa_options_set_real(options, STLTSA_OPT_FPS, fps);
    if (status == STLTSA_OK)
        status = stltsa_denoise(&in, NULL, options, &denoising);
    if (status == STLTSA_OK)
        status = report(denoising, points);
    if (status != STLTSA_OK)
        fprintf(stderr, "%s\n", stltsa_last_error());

    stltsa_denoising_free(denoising);
    stltsa_options_free(options);
    return status == STLTSA_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
