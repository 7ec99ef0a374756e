# SPDX-License-Identifier: BSD-3-Clause
"""The tasks that scripts/benchmark measures, in the order in which they run."""

import json

import numpy as np
from tasks import DIMENSION, Frames, Task, summary

COMPARED = 9000  # frames of the comparison with others
EXACT = 1000  # frames for which the exact embedding among all frames is quick to compute
PERIOD_K = 12  # temporal neighbors; among all frames so few leave real clips disconnected
ALL_K = 24  # neighbors among all frames: the graph is connected
PEER_SIZES = (1000, 3000, 10_000, 30_000)
SIZES = (1000, 10_000, 100_000)
MILLION = 1_000_000
NEIGHBORS = (12, 24, 48, 140)
CLIPS = ("13_29.amc", "13_30.amc", "86_01.amc")  # with one skeleton, 86.asf


def make_frames(laboratory, data, frames):
    """The given number of synthetic frames, and real frames if there are any, otherwise synthetic
    ones instead."""

    def made(kind, name, *arguments):
        path = laboratory.folder / name
        said = laboratory.program("measure/make_frames", path, *arguments)
        return Frames(kind, str(path), said["frames"], said["features"])

    motion = made("made up", "motion.frames", frames)
    cmu = data / "cmu"
    clips = [cmu / clip for clip in CLIPS]
    if not all(clip.exists() for clip in clips):
        print(f"no real clips in {data} (set STLTSA_DATA to their folder): made-up frames instead")
        return motion, motion
    return motion, made("real", "clips.frames", COMPARED, cmu / "86.asf", *clips)


def compared(frames):
    """The tasks of the comparison with other libraries, by name."""
    n = COMPARED
    return {
        "temporal": Task("stltsa", frames, n, PERIOD_K, "temporal"),
        "temporal2": Task("stltsa", frames, n, PERIOD_K, "temporal", threads=2),
        "all": Task("stltsa", frames, n, ALL_K),
        "all2": Task("stltsa", frames, n, ALL_K, threads=2),
        "tapkee": Task("tapkee", frames, n, ALL_K),
        "tapkee_few": Task("tapkee", frames, n, PERIOD_K),
        "tapkee_unchecked": Task("tapkee", frames, n, PERIOD_K, check=False),
        "sklearn": Task("scikit-learn", frames, n, ALL_K),
        "sklearn_few": Task("scikit-learn", frames, n, PERIOD_K),
    }


def measure_comparison(laboratory, frames, peers, rounds):
    print(f"\n{COMPARED} frames ({frames.kind}), each library doing its job:", flush=True)
    tasks = {name: task for name, task in compared(frames).items()
             if task.program in ("stltsa", *peers)}
    laboratory.measure(tasks.values(), rounds)
    return {name: summary(task, laboratory.runs[task]) for name, task in tasks.items()}


def measure_growth(laboratory, motion, peers, sizes, rounds):
    """Growth with n, on synthetic frames. The library's own sizes alternate, because claims compare
    them, and run often, because the gain from two threads is smaller than the machine's noise."""
    print("\nGrowth with the frames (made up):", flush=True)
    rows = []

    def add(tasks, rounds=1):
        laboratory.measure(tasks, rounds)
        rows.extend(summary(task, laboratory.runs[task]) for task in tasks)

    add([Task("stltsa", motion, n, PERIOD_K, "temporal", threads)
         for n in sizes for threads in (1, 2)], 5 * rounds)
    for program in ("stltsa", *peers):
        for n in PEER_SIZES:
            add([Task(program, motion, n, ALL_K)])
            if "failed" in rows[-1]:
                break
    return rows


def measure_neighbors(laboratory, motion, rounds):
    """Growth with k = w."""
    print("\nGrowth with the neighbors (made-up frames):", flush=True)
    tasks = [Task("stltsa", motion, SIZES[-1], k, "temporal", threads)
             for k in NEIGHBORS for threads in (1, 2)]
    laboratory.measure([task for task in tasks if task not in laboratory.runs], rounds)
    return [summary(task, laboratory.runs[task]) for task in tasks]


def largest_angle(a, b):
    """Sine of the largest principal angle between two column spaces without the constant."""
    a, b = (np.linalg.qr(x - x.mean(axis=0))[0] for x in (a, b))
    return float(np.linalg.norm(b - a @ (a.T @ b), 2))


def measure_angles(laboratory, frames, peers):
    """Angles between embeddings, and between them and the exact ones of tests/reference."""
    print("\nAngles between embeddings:", flush=True)

    def coords(path):
        return np.fromfile(path).reshape(-1, DIMENSION)

    def embedded(task):
        if task not in laboratory.runs:
            laboratory.measure([task])
        return None if laboratory.failed(task) else coords(laboratory.coords_path(task))

    def exact(n, mode, k):
        path = laboratory.folder / f"exact_{mode}.coords"
        laboratory.program("tests/reference/exact", frames.path, n, frames.features, mode, k,
                           DIMENSION, path)
        return coords(path)

    def add(task, to, truth):
        found = embedded(task)
        if found is not None and truth is not None:
            rows.append({"program": task.program, "mode": task.mode, "n": task.n, "k": task.k,
                         "to": to, "angle": largest_angle(found, truth)})
            print("  " + json.dumps(rows[-1]), flush=True)

    rows = []
    add(Task("stltsa", frames, COMPARED, PERIOD_K, "temporal"), "exact",
        exact(COMPARED, "temporal", PERIOD_K))
    truth = exact(EXACT, "spatial", ALL_K)
    for program in ("stltsa", *peers):
        add(Task(program, frames, EXACT, ALL_K), "exact", truth)
    ours = embedded(Task("stltsa", frames, COMPARED, ALL_K))
    for program in peers:
        add(Task(program, frames, COMPARED, ALL_K), "stltsa", ours)
    return rows
