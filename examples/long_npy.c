/* SPDX-License-Identifier: BSD-3-Clause */
/* Fits a recording that is too large to load: maps an NPY file into memory and fits it in place.
 * The library reads packed rows of float64 without copying them, and with STLTSA_OPT_KEEP_FRAMES 0
 * keeps none of them. In addition it needs a few hundred bytes per frame for short windows.
 *
 *     cc long_npy.c $(pkg-config --cflags --libs stltsa) -o long_npy
 *     ./long_npy walk.bvh walk.npy
 *
 * writes the numbers of a clip to walk.npy first; without the clip it uses the existing file. If
 * another program truncates the file while it is mapped, this program ends with SIGBUS.
 */
#define _POSIX_C_SOURCE 200809L
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <stltsa.h>

struct mapping {
    void* data;
    size_t size;
};

static struct mapping map_file(const char* path) {
    struct mapping file = {MAP_FAILED, 0};
    struct stat status;
    const int descriptor = open(path, O_RDONLY);
    if (descriptor < 0)
        return file;
    if (fstat(descriptor, &status) == 0 && status.st_size > 0) {
        file.size = (size_t)status.st_size;
        file.data = mmap(NULL, file.size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    }
    close(descriptor);
    return file;
}

/* Finds the frames of a float64 matrix from numpy.save(); 0: the file holds something else. */
static int frames_of(const struct mapping* file, stltsa_in* frames) {
    const unsigned char* bytes = file->data;
    char header[256] = {0};
    size_t length;
    long long rows, cols;
    const char* shape;
    char end; /* closes the shape after two numbers, unless there are more dimensions */

    if (file->size < 10 || memcmp(bytes, "\x93NUMPY\x01", 7) != 0)
        return 0;
    length = bytes[8] + 256u * bytes[9];
    if (10 + length > file->size)
        return 0;
    memcpy(header, bytes + 10, length < sizeof header ? length : sizeof header - 1);
    shape = strstr(header, "'shape': (");
    if (shape == NULL || strstr(header, "'<f8'") == NULL || strstr(header, "False") == NULL ||
        sscanf(shape, "'shape': (%lld, %lld%c", &rows, &cols, &end) != 3 || end != ')' ||
        rows < 1 || cols < 1 ||
        (file->size - 10 - length) / sizeof(double) / (size_t)cols < (size_t)rows)
        return 0;
    memset(frames, 0, sizeof *frames);
    frames->data = bytes + 10 + length;
    frames->rows = rows;
    frames->cols = cols;
    frames->dtype = STLTSA_F64;
    return 1;
}

static stltsa_status write_npy(const char* clip_path, const char* npy_path) {
    stltsa_clip* clip = NULL;
    stltsa_status status = stltsa_clip_open(clip_path, NULL, &clip);
    if (status == STLTSA_OK)
        status = stltsa_clip_save(clip, npy_path, NULL);
    stltsa_clip_free(clip);
    return status;
}

static stltsa_status fit(const stltsa_in* frames) {
    stltsa_options* options = NULL;
    stltsa_model* model = NULL;
    stltsa_component component;

    stltsa_status status = stltsa_options_new(&options);
    if (status == STLTSA_OK)
        status = stltsa_options_set_int(options, STLTSA_OPT_NEIGHBORS, 12);
    if (status == STLTSA_OK)
        status = stltsa_options_set_int(options, STLTSA_OPT_KEEP_FRAMES, 0);
    if (status == STLTSA_OK)
        status = stltsa_fit(frames, NULL, options, &model);
    if (status == STLTSA_OK)
        status = stltsa_info_rows(stltsa_model_info(model), STLTSA_INFO_COMPONENT, 0, 1, &component,
                                  sizeof component);
    if (status == STLTSA_OK)
        printf("%lld frames of %lld numbers, components: %lld, error estimate of the first %.1e\n",
               (long long)frames->rows, (long long)frames->cols,
               (long long)stltsa_info_count(stltsa_model_info(model), STLTSA_INFO_COMPONENT),
               component.error_estimate_rad);
    stltsa_model_free(model);
    stltsa_options_free(options);
    return status;
}

int main(int argc, char** argv) {
    struct mapping file;
    stltsa_in frames;
    stltsa_status status;

    if (argc != 2 && argc != 3) {
        fprintf(stderr, "usage: %s [CLIP] FILE.npy\n", argv[0]);
        return 2;
    }
    if (argc == 3 && write_npy(argv[1], argv[2]) != STLTSA_OK) {
        fprintf(stderr, "%s\n", stltsa_last_error());
        return 1;
    }
    file = map_file(argv[argc - 1]);
    if (file.data == MAP_FAILED) {
        fprintf(stderr, "%s: cannot be mapped\n", argv[argc - 1]);
        return 1;
    }
    if (!frames_of(&file, &frames)) {
        fprintf(stderr, "%s: not rows of float64 as numpy.save() writes them\n", argv[argc - 1]);
        munmap(file.data, file.size);
        return 1;
    }
    status = fit(&frames);
    if (status != STLTSA_OK)
        fprintf(stderr, "%s\n", stltsa_last_error());
    munmap(file.data, file.size);
    return status == STLTSA_OK ? 0 : 1;
}
