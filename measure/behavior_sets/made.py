# SPDX-License-Identifier: BSD-3-Clause
"""Recordings composed of motions of the synthetic body, or of short recorded moves."""

import measuring
import numpy as np
from recording import moves, synthetic
from recording.compose import Cyclic, Group, Rest, compose

from .judge import change_points, judge, line

MIXED = (0.82, 0.93, 0.75)


def needs_data(measure):
    return measure is moves_mixed or measure.__module__.endswith("real")


def write(run, recording):
    """Path of the recording, and the options to read it with."""
    if recording.body:
        path = run.path(recording.name, ".bvh")
        recording.body.write(path, recording.rows, recording.fps)
        return path, []
    return run.table(recording.name, recording.rows), ["--fps", recording.fps]


def judge_all(run, recording, limits, turns=False):
    path, options = write(run, recording)
    judge(run, recording, path, limits, options, turns=turns)
    rows = (run.stltsa.read_clip(str(path)).features() if recording.body else recording.rows)
    change_points(run, recording, rows)
    motions = sum(part.moving for part in recording.parts)
    judge(run, recording, path, (None, None, None), [*options, "--segments", motions], "number given: ")
    change_points(run, recording, rows, motions - 1, "number given: ")


def mixtures(run):
    for i, _ in run.cases(6):
        judge_all(run, synthetic.mixture(run.body, 100 + i, 300), MIXED)


def moves_mixed(run):
    """Takes of real moves, each with its own size and tempo, with rests and without."""
    styles = moves.read_moves(run.stltsa, measuring.DATA)
    for i, _ in run.cases(6):
        for make in (moves.mixture, moves.mixture_with_rests):
            judge_all(run, make(styles, 100 + i, 300, varied=True), MIXED, True)


def one_motion(run):
    """Walks on a treadmill must not be divided."""
    for i, rng in run.cases(8):
        walk = synthetic.treadmill(run.body, 100 + i, 1)
        if measuring.DATA.is_dir() and i >= 4:
            walk = moves.treadmill(moves.read_moves(run.stltsa, measuring.DATA), 100 + i, 1)
        path, options = write(run, walk)
        count_cuts(run, "walks cut into segments", path, *options)
        features = run.stltsa.read_clip(str(path)).features() if walk.body else walk.rows
        for column in np.argsort(-features.var(0))[:20:5]:
            path = run.table(f"{walk.name}, column {column}", features[:, column:column + 1])
            count_cuts(run, "single columns of walks cut", path, "--fps", walk.fps)


def count_cuts(run, what, path, *options):
    for build, answer in run.ask(path, *options):
        moving = sum(s["kind"] != "rest" for s in answer["segments"])
        run.row(what, 0, "of", True).add(build, moving > 1, 1)
        run.note(build, moving == 1, path, line(answer))


def letters(run):
    """Takes of one motion in other sizes and tempos share a letter; other motions do not."""
    names = ("wave right", "jumping jack", "arm circles", "walk", "knee raises")
    for _, rng in run.cases(8):
        takes = [(name, size) for name in names for size in (0.5, 0.75, 1)]
        sequence = []
        for j in rng.permutation(len(takes)):
            name, size = takes[j]
            period = synthetic.motions.CYCLIC[name][0] * np.exp(rng.uniform(-0.2, 0.2))
            sequence += [Cyclic(name, rng.uniform(5, 9), period, size=size), Rest(rng.uniform(1, 2))]
            if j % 5 == 0:
                sequence += [Group(rng, "raise right", 3), Rest(rng.uniform(1, 2))]
        recording = compose("letters", rng, run.body, sequence)
        path, options = write(run, recording)
        for build, answer in run.ask(path, *options):
            same, other = pairs(recording, answer)
            run.row("takes of one motion: same letter", 0.9).add(build, sum(same), len(same))
            run.row("other motions: same letter", 0.02, "of", True).add(build, sum(other), len(other))


def pairs(recording, answer):
    """Whether each pair of parts shares a letter: pairs of one motion, then of different ones."""
    said = []
    for part in recording.parts:
        if part.moving:
            shares = {}
            for s in answer["segments"]:
                over = max(0, min(part.end, s["end_s"]) - max(part.begin, s["begin_s"]))
                shares[s["label"]] = shares.get(s["label"], 0) + over
            said.append((part.label, max(shares, key=shares.get)))
    both = [(a[0] == b[0], a[1] == b[1] and a[1] is not None)
            for i, a in enumerate(said) for b in said[:i]]
    return [s for one, s in both if one], [s for one, s in both if not one]
