/* SPDX-License-Identifier: BSD-3-Clause */
/* Mapping of frames and points of matrices, both ways: exact if the result is known, continuous,
 * and independent of the form of the call. */
#include "support.h"

enum { rows = 400, cols = 20 };

static stltsa_model* fitted(const double* x, int64_t count, int64_t k, int64_t d) {
    stltsa_options* options = new_options(k, k, d);
    stltsa_model* model = fitted_rows(x, count, cols, options);
    return model;
}

/* hints, coords, distance and nearest have `count` rows; all but coords may be NULL. */
static void map(const stltsa_model* model, const double* x, int64_t count, const int64_t* hints,
                const stltsa_options* options, double* coords, double* distance, int64_t* nearest) {
    const stltsa_in in = packed_in(x, count, cols);
    const stltsa_out out = packed_out(coords, count, int_of(model, STLTSA_INFO_DIMENSION));
    const stltsa_out far = packed_out(distance, count, 1);
    const stltsa_in near = list_in(hints, count);
    const stltsa_out found = list_out(nearest, count);
    must(stltsa_map(model, &in, hints == NULL ? NULL : &near, options, &out,
                    distance == NULL ? NULL : &far, nearest == NULL ? NULL : &found));
}

static void unmap(const stltsa_model* model, const double* y, int64_t count, const int64_t* hints,
                  const stltsa_options* options, double* x, double* distance, int64_t* nearest) {
    const stltsa_in in = packed_in(y, count, int_of(model, STLTSA_INFO_DIMENSION));
    const stltsa_out out = packed_out(x, count, cols);
    const stltsa_out far = packed_out(distance, count, 1);
    const stltsa_in near = list_in(hints, count);
    const stltsa_out found = list_out(nearest, count);
    must(stltsa_unmap(model, &in, hints == NULL ? NULL : &near, options, &out,
                      distance == NULL ? NULL : &far, nearest == NULL ? NULL : &found));
}

/* Row i is (1 - t) of row i plus t of row i + gap. */
static double* new_between(const double* x, int64_t count, int64_t width, int64_t gap, double t) {
    double* between = new_matrix(count - gap, width);
    for (int64_t i = 0; i < (count - gap) * width; ++i)
        between[i] = (1 - t) * x[i] + t * x[i + gap * width];
    return between;
}

TEST(fitted_rows_go_both_ways_to_the_bit) {
    double* x = new_motion(rows, cols, 11);
    stltsa_model* model = fitted(x, rows, 25, 3);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* mapped = new_matrix(rows, 3);
    double* distance = new_matrix(rows, 1);
    double* back = new_matrix(rows, cols);
    int64_t nearest[rows];
    map(model, x, rows, NULL, NULL, mapped, distance, nearest);
    assert_same_bits(mapped, coords, 3 * rows);
    for (int64_t i = 0; i < rows; ++i) {
        assert_int_equal(nearest[i], i);
        assert_true(distance[i] == 0);
    }
    unmap(model, coords, rows, NULL, NULL, back, distance, nearest);
    assert_same_bits(back, x, rows * cols);
    for (int64_t i = 0; i < rows; ++i)
        assert_true(nearest[i] == i && distance[i] == 0);
}

/* A path that wanders over a plane, as points on that plane. */
static double* new_plane_points(void) {
    double* path = new_matrix(rows, 2);
    uint64_t seed = 3;
    for (int64_t i = 0; i < rows; ++i) {
        path[2 * i] = 0.05 * (double)i + 0.2 * uniform(&seed);
        path[2 * i + 1] = sin(0.3 * (double)i) + 0.2 * uniform(&seed);
    }
    double* plane = new_directions(2, cols, 5);
    double* x = new_product(path, plane, rows, 2, cols);
    return x;
}

/* On a plane the coordinates are an affine image of the points, so a point between two rows has the
 * coordinates between theirs. */
TEST(plane_is_mapped_exactly) {
    double* x = new_plane_points();
    stltsa_model* model = fitted(x, rows, 12, 2);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    const int64_t count = rows - 3;
    double* between = new_between(x, rows, cols, 3, 0.3);
    double* expected = new_between(coords, rows, 2, 3, 0.3);
    double* mapped = new_matrix(count, 2);
    map(model, between, count, NULL, NULL, mapped, NULL, NULL);
    assert_below(largest_difference(mapped, expected, 2 * count), 1e-9, "error on the plane");
    double* back = new_matrix(count, cols);
    unmap(model, mapped, count, NULL, NULL, back, NULL, NULL);
    /* Rows are 0.3 apart; regularization on the way back pulls slightly towards the nearest ones.
     */
    assert_below(largest_difference(back, between, count * cols), 0.05, "error of the way back");
}

/* Point at `turns` (0 to 1) of a spiral in space; returns the length up to there. */
static double spiral(double turn, double* point) {
    const double a = 3 + 4 * pi * turn; /* r = angle, from 3 on */
    point[0] = a * cos(a);
    point[1] = a * sin(a);
    point[2] = 0.5 * a;
    /* integral of sqrt(r^2 + r'^2 + 1/4) */
    const double c = 1.25;
    const double s = sqrt(a * a + c);
    return 0.5 * (a * s + c * log(a + s));
}

static double* new_spiral(double shift, double* lengths) {
    double* points = new_matrix(rows, 3);
    for (int64_t i = 0; i < rows; ++i)
        lengths[i] = spiral(((double)i + shift) / rows, points + 3 * i);
    double* space = new_directions(3, cols, 9);
    double* x = new_product(points, space, rows, 3, cols);
    return x;
}

/* One coordinate measures length along a rolled-up curve, also between rows. */
TEST(spiral_is_mapped_to_its_length) {
    double lengths[rows], held_lengths[rows];
    double* x = new_spiral(0, lengths);
    double* held = new_spiral(0.5, held_lengths);
    stltsa_model* model = fitted(x, rows, 12, 1);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* mapped = new_matrix(rows, 1);
    map(model, held, rows - 1, NULL, NULL, mapped, NULL, NULL);
    /* Both ends of the curve give the scale. The error of the rows' own coordinate (an eigenvector,
     * not an exact length) is not the mapping's. */
    const double all = lengths[rows - 1] - lengths[0];
    const double slope = (coords[rows - 1] - coords[0]) / all;
    double worst = 0, worst_beside = 0;
    for (int64_t i = 0; i < rows - 1; ++i) {
        const double error = (mapped[i] - coords[0]) / slope - (held_lengths[i] - lengths[0]);
        const double before = (coords[i] - coords[0]) / slope - (lengths[i] - lengths[0]);
        worst = fmax(worst, fabs(error));
        worst_beside = fmax(worst_beside, fabs(error - before));
    }
    assert_below(worst, 0.5 * all / rows, "error of the length, over the step of the rows");
    assert_below(worst_beside, 0.02 * all / rows, "error of the length against the row beside");
}

/* Largest step of the coordinates on a path through the frames, divided into steps. */
static double largest_step(const stltsa_model* model, const double* x, int64_t pieces) {
    const int64_t stops[] = {10, 11, 200, 100, 101, 103, 350};
    const int64_t legs = (int64_t)(sizeof stops / sizeof *stops) - 1;
    double* way = new_matrix(legs * pieces, cols);
    for (int64_t i = 0; i < legs * pieces; ++i) {
        const double t = (double)(i % pieces) / (double)pieces;
        for (int64_t c = 0; c < cols; ++c)
            way[i * cols + c] =
                (1 - t) * x[stops[i / pieces] * cols + c] + t * x[stops[i / pieces + 1] * cols + c];
    }
    double* mapped = new_matrix(legs * pieces, 3);
    map(model, way, legs * pieces, NULL, NULL, mapped, NULL, NULL);
    double largest = 0;
    for (int64_t i = 3; i < 3 * legs * pieces; ++i)
        largest = fmax(largest, fabs(mapped[i] - mapped[i - 3]));
    return largest;
}

/* Through frames, and through points where one frame replaces another in the blend. */
TEST(map_is_continuous) {
    double* x = new_motion(rows, cols, 12);
    stltsa_model* model = fitted(x, rows, 25, 3);
    const double coarse = largest_step(model, x, 500);
    const double fine = largest_step(model, x, 8000);
    assert_below(fine, 0.2 * coarse, "step at a sixteenth of the distance");
}

TEST(frames_far_away_are_flagged) {
    double* x = new_motion(rows, cols, 13);
    stltsa_model* model = fitted(x, rows, 25, 3);
    const double support = real_of(model, STLTSA_INFO_REACH);
    assert_true(support > 0);
    double* between = new_between(x, rows, cols, 1, 0.5);
    double* mapped = new_matrix(rows, 3);
    double* distance = new_matrix(rows, 1);
    map(model, between, rows - 1, NULL, NULL, mapped, distance, NULL);
    for (int64_t i = 0; i < rows - 1; ++i)
        assert_below(distance[i], 1, "distance between two rows");
    /* Displaced by a vector: at most its length away, or closer to another row. */
    double* off = copy_of(x, rows * cols);
    for (int64_t i = 0; i < rows; ++i)
        off[i * cols] += 3 * support;
    map(model, off, rows, NULL, NULL, mapped, distance, NULL);
    for (int64_t i = 0; i < rows; ++i)
        assert_below(distance[i], 3 * (1 + 1e-12), "distance of a shifted row");
    for (int64_t i = 0; i < rows * cols; ++i)
        off[i] = x[i] + 100 * support;
    map(model, off, rows, NULL, NULL, mapped, distance, NULL);
    for (int64_t i = 0; i < rows; ++i)
        assert_true(distance[i] > 50 && isfinite(distance[i]));
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* middle = new_between(coords, rows, 3, 1, 0.5);
    unmap(model, middle, rows - 1, NULL, NULL, between, distance, NULL);
    for (int64_t i = 0; i < rows - 1; ++i)
        assert_below(distance[i], 1, "distance between two points");
    middle[0] += 10;
    unmap(model, middle, 1, NULL, NULL, between, distance, NULL);
    assert_true(distance[0] > 10);
}

/* Frames and points near the fitted ones, their mapping, and their distances. */
struct asked {
    double x[rows * cols], y[3 * rows], distance[rows], back_distance[rows];
    int64_t nearest[rows], back_nearest[rows];
};

static void ask(const stltsa_model* model, const double* near, const double* points,
                int64_t threads, int64_t at_once, struct asked* asked) {
    stltsa_options* options = with_int(STLTSA_OPT_THREADS, threads);
    for (int64_t i = 0; i < rows; i += at_once) {
        map(model, near + i * cols, at_once, NULL, options, asked->y + 3 * i, asked->distance + i,
            asked->nearest + i);
        unmap(model, points + 3 * i, at_once, NULL, options, asked->x + i * cols,
              asked->back_distance + i, asked->back_nearest + i);
    }
}

TEST(threads_and_portions_change_nothing) {
    double* x = new_motion(rows, cols, 14);
    stltsa_model* model = fitted(x, rows, 25, 3);
    double* points = array_of(model, STLTSA_INFO_COORDS);
    uint64_t seed = 8;
    for (int64_t i = 0; i < rows * cols; ++i)
        x[i] += 0.1 * (uniform(&seed) - 0.5);
    for (int64_t i = 0; i < 3 * rows; ++i)
        points[i] += 0.005 * (uniform(&seed) - 0.5);
    struct asked* asked = calloc(4, sizeof *asked);
    ask(model, x, points, 1, rows, &asked[0]);
    ask(model, x, points, 2, rows, &asked[1]);
    ask(model, x, points, 2, 1, &asked[2]);
    ask(model, x, points, 5, 100, &asked[3]);
    for (int a = 1; a < 4; ++a)
        assert_memory_equal(&asked[a], &asked[0], sizeof asked[0]);
    free(asked);
}

TEST(strides_and_float32) {
    double* x = new_motion(rows, cols, 15);
    stltsa_model* model = fitted(x, rows, 25, 2);
    double* between = new_between(x, rows, cols, 1, 0.4);
    double* expected = new_matrix(rows, 2);
    const int64_t count = 50;
    float* narrow = calloc((size_t)(count * cols), sizeof *narrow);
    for (int64_t i = 0; i < count * cols; ++i) {
        narrow[i] = (float)between[i];
        between[i] = (double)narrow[i];
    }
    map(model, between, count, NULL, NULL, expected, NULL, NULL);
    /* Input: from the last row backwards. Output: separate columns of floats. */
    const int64_t row = (int64_t)sizeof(float) * cols;
    const stltsa_in in = {
        narrow + (count - 1) * cols, count, cols, -row, sizeof(float), STLTSA_F32, 0};
    float* mapped = calloc((size_t)(2 * count), sizeof *mapped);
    const stltsa_out out = {mapped,     count, 2, sizeof(float), (int64_t)sizeof(float) * count,
                            STLTSA_F32, 0};
    must(stltsa_map(model, &in, NULL, NULL, &out, NULL, NULL));
    for (int64_t i = 0; i < count; ++i)
        for (int64_t l = 0; l < 2; ++l)
            assert_true(mapped[l * count + i] == (float)expected[2 * (count - 1 - i) + l]);
    free(mapped);
    free(narrow);
}

/* A swing: one coordinate, and two poses for each of its values. */
TEST(hints_tell_to_from_fro) {
    double* x = new_matrix(rows, cols);
    for (int64_t i = 0; i < rows; ++i)
        for (int64_t c = 0; c < cols; ++c)
            x[i * cols + c] = sin(2 * pi * (double)i / 40.3 + 0.3 * (double)c);
    stltsa_model* model = fitted(x, rows, 48, 1);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* middle = new_between(coords, rows, 1, 1, 0.5);
    double* expected = new_between(x, rows, cols, 1, 0.5);
    double* back = new_matrix(rows, cols);
    int64_t hints[rows], nearest[rows];
    stltsa_options* options = new_options(48, 48, 1);
    must(stltsa_options_set_int(options, STLTSA_OPT_HINT_WINDOW, 2));
    for (int64_t i = 0; i < rows; ++i)
        hints[i] = i;
    unmap(model, middle, rows - 1, hints, options, back, NULL, nearest);
    /* Away from the ends of the clip, where the coordinate flattens. */
    const int64_t edge = 40;
    const int64_t inner = rows - 1 - 2 * edge;
    assert_below(largest_difference(back + edge * cols, expected + edge * cols, inner * cols), 0.4,
                 "error with hints");
    for (int64_t i = 0; i < rows - 1; ++i)
        assert_true(llabs(nearest[i] - hints[i]) <= 2);
    unmap(model, middle, rows - 1, NULL, NULL, back, NULL, NULL);
    assert_true(largest_difference(back + edge * cols, expected + edge * cols, inner * cols) > 1);
    /* A hint of -1 means none. */
    double* again = new_matrix(rows, cols);
    for (int64_t i = 0; i < rows; ++i)
        hints[i] = -1;
    unmap(model, middle, rows - 1, hints, NULL, again, NULL, NULL);
    assert_same_bits(again, back, (rows - 1) * cols);
    /* By default a fifth of the neighbors. */
    hints[0] = 100;
    unmap(model, middle + 200, 1, hints, NULL, back, NULL, nearest);
    assert_true(llabs(nearest[0] - 100) <= 48 / 5);
}

/* The window of a hint does not extend into the next clip; a window of one row decides alone. */
TEST(hints_stay_in_their_window) {
    double* x = new_motion(rows, cols, 16);
    const int64_t lengths[] = {150, 250};
    const stltsa_in clips = list_in(lengths, 2);
    stltsa_options* options = new_options(20, 20, 2);
    const stltsa_in in = packed_in(x, rows, cols);
    stltsa_model* model = NULL;
    must(stltsa_fit(&in, &clips, options, &model));
    double y[2];
    int64_t nearest = -1;
    const int64_t hint = 148;
    must(stltsa_options_set_int(options, STLTSA_OPT_HINT_WINDOW, 10));
    map(model, x + 155 * cols, 1, &hint, options, y, NULL, &nearest);
    assert_in_range((uint64_t)nearest, 138, 149);
    must(stltsa_options_set_int(options, STLTSA_OPT_HINT_WINDOW, 3));
    map(model, x + 20 * cols, 1, &hint, options, y, NULL, &nearest);
    assert_in_range((uint64_t)nearest, 145, 149);
    map(model, x + 20 * cols, 1, NULL, options, y, NULL, &nearest);
    assert_int_equal(nearest, 20);
    stltsa_model_free(model);
}

/* Each row occurs three times; a hint counts poses, not repetitions. */
TEST(repeated_rows_are_one) {
    double* once = new_motion(rows, cols, 17);
    const int64_t copies = 3;
    const int64_t all = copies * rows;
    double* x = new_matrix(all, cols);
    for (int64_t i = 0; i < all; ++i)
        memcpy(x + i * cols, once + i / copies * cols, cols * sizeof *x);
    stltsa_model* model = fitted(x, all, 25, 2);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* mapped = new_matrix(all, 2);
    int64_t* nearest = calloc((size_t)all, sizeof *nearest);
    map(model, x, all, NULL, NULL, mapped, NULL, nearest);
    assert_same_bits(mapped, coords, 2 * all);
    for (int64_t i = 0; i < all; ++i)
        assert_int_equal(nearest[i], i / copies * copies);
    double* between = new_between(once, rows, cols, 1, 0.5);
    stltsa_options* options = new_options(25, 25, 2);
    must(stltsa_options_set_int(options, STLTSA_OPT_HINT_WINDOW, 2));
    for (int64_t i = 0; i < rows - 1; ++i) {
        double y[2], distance;
        const int64_t hint = copies * i + 1;
        map(model, between + i * cols, 1, &hint, options, y, &distance, nearest);
        assert_true(nearest[0] == copies * i || nearest[0] == copies * (i + 1));
        assert_below(distance, 1, "distance between repeated rows");
    }
    free(nearest);
}

/* Local maps with one row, with fewer rows than coordinates, and with more rows than exist. */
TEST(any_number_of_neighbors_and_maps) {
    double* x = new_motion(rows, cols, 18);
    stltsa_model* model = fitted(x, rows, 25, 3);
    double* coords = array_of(model, STLTSA_INFO_COORDS);
    double* between = new_between(x, rows, cols, 1, 0.5);
    const int64_t numbers[][2] = {{1, 1}, {2, 3}, {2147483647, 1}, {3, 2}, {12, 1000}};
    for (int n = 0; n < 5; ++n) {
        stltsa_options* options = new_options(25, 25, 3);
        must(stltsa_options_set_int(options, STLTSA_OPT_MAP_NEIGHBORS, numbers[n][0]));
        must(stltsa_options_set_int(options, STLTSA_OPT_MAP_BLEND, numbers[n][1]));
        double y[9], back[3 * cols];
        map(model, x + 77 * cols, 1, NULL, options, y, NULL, NULL);
        assert_same_bits(y, coords + 3 * 77, 3);
        map(model, between + 77 * cols, 3, NULL, options, y, NULL, NULL);
        /* A blend of everything is its mean. */
        const double loose = numbers[n][1] == 1000 ? 10 : 1;
        assert_below(largest_difference(y, coords + 3 * 77, 9), 0.02 * loose,
                     "from the row beside");
        unmap(model, y, 3, NULL, options, back, NULL, NULL);
        assert_below(largest_difference(back, between + 77 * cols, 3 * cols), loose, "way back");
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fitted_rows_go_both_ways_to_the_bit),
        cmocka_unit_test(plane_is_mapped_exactly),
        cmocka_unit_test(spiral_is_mapped_to_its_length),
        cmocka_unit_test(map_is_continuous),
        cmocka_unit_test(frames_far_away_are_flagged),
        cmocka_unit_test(threads_and_portions_change_nothing),
        cmocka_unit_test(strides_and_float32),
        cmocka_unit_test(hints_tell_to_from_fro),
        cmocka_unit_test(hints_stay_in_their_window),
        cmocka_unit_test(repeated_rows_are_one),
        cmocka_unit_test(any_number_of_neighbors_and_maps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
