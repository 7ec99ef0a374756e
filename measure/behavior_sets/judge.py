# SPDX-License-Identifier: BSD-3-Clause
"""Compares the borders and labels of an answer with those of a recording."""

import dataclasses

from recording import peer
from recording.score import Score, matches, score_borders, score_labels, true_borders

LIMITS = {0.5: "F1 within 0.5 s", 1: "F1 within 1 s"}


def plain_labels(recording):
    """Turning walks count as walks."""
    parts = [dataclasses.replace(part, label="walk" if part.label.startswith("walk-turn") else part.label)
             for part in recording.parts]
    return dataclasses.replace(recording, parts=parts)


def judge(run, recording, path, limits=(None, None, None), options=(), what="", turns=False):
    """Adds rows of F1 and labels of each build. `limits`: of F1 within 0.5 s, within 1 s, of labels."""
    for build, answer in run.ask(path, *options):
        result = Score()
        score_borders(recording, answer, result, (1, 0.5))
        score_labels(recording, answer, result)
        for (tolerance, name), limit in zip(LIMITS.items(), limits):
            run.row(f"{what}{name}", limit).add(build, 2 * result.within[tolerance],
                                                result.borders + result.found_borders)
        run.row(f"{what}labels right", limits[2]).add(build, result.right_s, result.judged_s)
        turned = Score()
        if turns:
            score_labels(plain_labels(recording), answer, turned)
            run.row(f"{what}labels right, turns as walks").add(build, turned.right_s, turned.judged_s)
        run.note(build, False, path, f"F1 {result.f1(0.5):.2f} {result.f1(1):.2f} labels "
                 f"{result.labels:.2f}: {line(answer)}; true {line_of(recording)}")


def change_points(run, recording, rows, count=None, what=""):
    """Adds F1 of kernel change points to the column of the last build."""
    if not run.options.peers:
        return
    true = true_borders(recording, recording.border_at)
    found = peer.borders(recording, rows, count)
    for tolerance, name in LIMITS.items():
        right = sum(i is not None for i in matches(true, found, tolerance))
        run.row(f"{what}{name}: change points alone").add(-1, 2 * right, len(true) + len(found))


def line(answer):
    return " ".join(f"{s['begin_s']:.1f}{s['label'] or '-'}" for s in answer["segments"])


def line_of(recording):
    return " ".join(f"{part.begin:.1f} {part.label or '-'}" for part in recording.parts)
