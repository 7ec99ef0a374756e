/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes a longer motion from a clip: its beginning, its best cycle five times, and its end.
 *
 *     cc synthesize.c $(pkg-config --cflags --libs stltsa) -o synthesize
 *     ./synthesize walk.bvh long.bvh
 */
#include <stdio.h>
#include <stdlib.h>

#include <stltsa.h>

/* Finds the frames of the best cycle; if there is none, prints the reason and returns false. */
static int find_cycle(const stltsa_clip* clip, stltsa_part* cycle) {
    stltsa_decomposition* decomposition = NULL;
    const int decomposed = stltsa_decompose(clip, NULL, &decomposition) == STLTSA_OK;
    const stltsa_info* info = stltsa_decomposition_info(decomposition);
    const char* reason = stltsa_last_error();
    int64_t best = -1;
    const int found =
        decomposed && stltsa_info_int(info, STLTSA_INFO_BEST, 0, &best) == STLTSA_OK && best >= 0 &&
        stltsa_info_rows(info, STLTSA_INFO_CYCLE, best, 1, cycle, sizeof *cycle) == STLTSA_OK;
    if (decomposed && !found)
        stltsa_info_text(info, STLTSA_INFO_REASON, 0, &reason);
    if (!found)
        fprintf(stderr, "no cycle: %s\n", reason);
    stltsa_decomposition_free(decomposition);
    return found;
}

/* Pieces: the frames before the cycle, the cycle five times, the frames after it. Returns their
 * number. */
static int64_t make_pieces(const stltsa_clip* clip, stltsa_part cycle, stltsa_piece pieces[3]) {
    const int64_t end = stltsa_clip_frames(clip);
    const stltsa_piece before = {clip, 0, cycle.begin, 1, 0};
    const stltsa_piece again = {clip, cycle.begin, cycle.end, 5, 0};
    const stltsa_piece after = {clip, cycle.end, end, 1, 0};
    int64_t count = 0;
    if (cycle.begin > 0)
        pieces[count++] = before;
    pieces[count++] = again;
    if (cycle.end < end)
        pieces[count++] = after;
    return count;
}

/* Prints the frame of each seam and measures of its visibility. */
static void print_seams(const stltsa_synthesis* synthesis) {
    const stltsa_info* info = stltsa_synthesis_info(synthesis);
    for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_SEAM); ++i) {
        stltsa_seam seam;
        if (stltsa_info_rows(info, STLTSA_INFO_SEAM, i, 1, &seam, sizeof seam) == STLTSA_OK)
            printf("seam at frame %lld: posture %.2f, step %.2f, acceleration %.2f\n",
                   (long long)seam.frame, seam.posture, seam.step, seam.acceleration);
    }
    for (int64_t i = 0; i < stltsa_info_count(info, STLTSA_INFO_WARNING); ++i) {
        stltsa_warning warning;
        if (stltsa_info_rows(info, STLTSA_INFO_WARNING, i, 1, &warning, sizeof warning) ==
            STLTSA_OK)
            printf("warning: %s\n", warning.text);
    }
}

int main(int argc, char** argv) {
    stltsa_clip* clip = NULL;
    stltsa_synthesis* synthesis = NULL;
    stltsa_piece pieces[3];
    stltsa_part cycle;
    int done = 0;

    if (argc != 3) {
        fprintf(stderr, "usage: %s CLIP NEW_CLIP\n", argv[0]);
        return 2;
    }
    if (stltsa_clip_open(argv[1], NULL, &clip) != STLTSA_OK)
        fprintf(stderr, "%s\n", stltsa_last_error());
    else if (find_cycle(clip, &cycle)) {
        /* Pieces that are consecutive in their clip need no seam, so there are four, between the
         * repeated cycles. The synthesis owns the new clip. */
        const int64_t count = make_pieces(clip, cycle, pieces);
        done = stltsa_synthesize(pieces, count, NULL, &synthesis) == STLTSA_OK &&
               stltsa_clip_save(stltsa_synthesis_clip(synthesis), argv[2], NULL) == STLTSA_OK;
        if (!done)
            fprintf(stderr, "%s\n", stltsa_last_error());
    }
    if (done) {
        printf("%lld frames became %lld\n", (long long)stltsa_clip_frames(clip),
               (long long)stltsa_clip_frames(stltsa_synthesis_clip(synthesis)));
        print_seams(synthesis);
    }
    stltsa_synthesis_free(synthesis);
    stltsa_clip_free(clip);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
