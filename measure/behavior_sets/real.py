# SPDX-License-Identifier: BSD-3-Clause
"""Recordings whose behaviors a person has labeled, in ../shared/data (or $STLTSA_DATA)."""

import csv

import measuring
import numpy as np
from recording.real import parts_of
from recording.score import Score, matches, score_labels
from recording.truth import Part, Recording

from .judge import change_points, judge

PEOPLE = ("86_01", "13_29", "13_30", "14_14")


def people(run):
    """Exercises and a mixed recording of the CMU database, as positions, as rotations, and
    with the number of segments given."""
    skeleton = measuring.DATA / "cmu" / "86.asf"
    for _, name in run.half(PEOPLE):
        path = measuring.DATA / "cmu" / f"{name}.amc"
        clip = run.stltsa.read_clip(str(path), skeleton=str(skeleton))
        parts = parts_of(measuring.DATA / "labels" / f"{name}.csv", clip.fps)
        recording = Recording(name, clip.fps, np.empty((len(clip), 0)), parts)
        options = ["--skeleton", skeleton]
        judge(run, recording, path, (0.85, 0.95, 0.91), options)
        change_points(run, recording, clip.features())
        judge(run, recording, path, (None, None, None), [*options, "--features", "rotations6d"],
              "rotations: ")
        change_points(run, recording, clip.features("rotations6d"), None, "rotations: ")
        judge(run, recording, path, (None, None, None), [*options, "--segments", len(parts)],
              "number given: ")
        change_points(run, recording, clip.features(), len(parts) - 1, "number given: ")


def imu(run):
    """Stand, walk, turn, walk back, stand; rows of both feet and the back at 100 Hz."""
    rows = csv.DictReader((measuring.DATA / "labels" / "imu.csv").read_text().splitlines())
    for _, row in run.half(list(rows)):
        path = measuring.DATA / "imu" / f"{row['file']}.csv"
        rate, numbers = 100, np.loadtxt(path, delimiter=",", skiprows=1)
        true = [int(row[key]) / rate for key in ("walk_begin", "turn_begin", "turn_end", "walk_end")]
        names = ("", "walk", "turn", "walk", "")
        parts = [Part("cyclic" if name else "rest", name, a, b)
                 for name, a, b in zip(names, [0, *true], [*true, len(numbers) / rate])]
        recording = Recording(row["file"], rate, numbers, parts)
        for build, answer in run.ask(path, "--fps", rate):
            found = [s["begin_s"] for s in answer["segments"][1:]]
            for tolerance, limit in ((0.5, 0.65), (1, 0.8)):
                right = sum(i is not None for i in matches([(t, t) for t in true],
                                                           [(t, t) for t in found], tolerance))
                run.row(f"F1 within {tolerance} s", limit).add(build, 2 * right, 4 + len(found))
            result = Score()
            score_labels(recording, answer, result)
            run.row("labels right").add(build, result.right_s, result.judged_s)
            turn = [t for t in found if true[1] - 0.5 <= t <= true[2] + 0.5]
            run.row("trials with a border in the turn", 0.5).add(build, bool(turn), 1)
            run.note(build, False, path, f"{found}; true {true}")
        change_points(run, recording, numbers)
        change_points(run, recording, numbers, len(true), "number given: ")
