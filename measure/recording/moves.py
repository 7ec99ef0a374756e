# SPDX-License-Identifier: BSD-3-Clause
"""Mixtures of the short moves in ../shared/data/moves, as features at 30 Hz."""

import csv
from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from .compose import smoothstep
from .motions import smooth_noise
from .truth import Part, Recording

FPS = 30
GAIT = ("walk", "run", "dash", "walk-turn-left", "walk-turn-right")


@dataclass
class Move:
    kind: str
    rows: np.ndarray
    period: float  # seconds; 0: unknown
    swings: float  # 0: all of it is cyclic

    @property
    def cyclic(self):
        return self.kind in GAIT or self.kind.startswith("wave")

    def piece(self):
        """Times and phases, phase 0 where the motion is farthest to one side; or None."""
        if not self.period:
            return None
        times = np.arange(len(self.rows)) / FPS
        velocity = np.gradient(self.rows, axis=0)
        turning = np.exp(-2j * np.pi * times / self.period)
        _, _, directions = np.linalg.svd((turning[:, None] * velocity).sum(0, keepdims=True))
        beat = turning * (velocity @ directions[0].conj())
        length = len(times)
        if self.swings:
            length = min(length, round(self.swings * self.period * FPS))
        sums = np.concatenate([[0], np.cumsum(beat)])
        first = int(np.argmax(np.abs(sums[length:] - sums[:-length])))
        inside = slice(first, first + length)
        return times[inside], times[inside] / self.period + np.angle(beat[inside].sum()) / 2 / np.pi


def read_moves(stltsa, data):
    """{style: [Move]} of the styles with three kinds or more, one of them gait."""
    labels = {row["file"]: row for row in
              csv.DictReader((data / "labels" / "moves.csv").read_text().splitlines())}
    styles = defaultdict(list)
    for path in sorted((data / "moves").glob("dataset-2_*.bvh")):
        _, kind, style, _ = path.stem.split("_")
        row = labels[path.name]
        move = Move(kind, stltsa.read_clip(str(path)).features(), float(row["period_s"] or 0),
                    float(row["swings"] or 0))
        styles[style].append(without_standing(move) if kind in GAIT else move)
    return {style: moves for style, moves in styles.items()
            if len({m.kind for m in moves}) >= 3 and any(m.kind in GAIT for m in moves)}


def without_standing(move):
    """Drops the frames before the body first moves and after it last moves."""
    speed = np.linalg.norm(np.gradient(move.rows, axis=0), axis=1)
    moving = np.flatnonzero(speed > 0.35 * np.median(speed))
    return Move(move.kind, move.rows[moving[0]:moving[-1] + 1], move.period, move.swings)


class Joined:
    """Rows and truth of takes, one after another. A blend fades from the last pose of one take to the
    first of the next."""

    def __init__(self):
        self.chunks, self.parts, self.blends, self.count = [], [], [], 0

    def add(self, kind, label, rows, blend, piece=None):
        """Goes on with the last part if the label is the same."""
        if self.chunks:
            weight = smoothstep(np.arange(1, blend + 1) / (blend + 1))[:, None]
            self.chunks.append((1 - weight) * self.chunks[-1][-1] + weight * rows[0])
            self._blend(label, blend)
        if not self.parts or self.parts[-1].label != label:
            self.parts.append(Part(kind, label, self.parts[-1].end if self.parts else 0, 0))
        begin = self.count / FPS
        self.chunks.append(rows)
        self.count += len(rows)
        self.parts[-1].end = self.count / FPS
        if piece:
            self.parts[-1].pieces.append((piece[0] + begin, piece[1]))

    def _blend(self, label, blend):
        begin = self.count / FPS
        self.count += blend
        if self.parts[-1].label != label:
            self.blends.append((begin, self.count / FPS))
            self.parts[-1].end = (begin + self.count / FPS) / 2

    def recording(self, name, border_at="middle"):
        return Recording(name, FPS, np.concatenate(self.chunks), self.parts, None, self.blends,
                         border_at)


def changed(rng, move):
    """The move, its size and tempo changed at random by up to a quarter and a fifth."""
    mean, tempo = move.rows.mean(axis=0), np.exp(rng.uniform(-0.2, 0.2))
    at = np.arange(0, len(move.rows) - 1, tempo)
    rows = np.stack([np.interp(at, np.arange(len(move.rows)), c) for c in move.rows.T], axis=1)
    return Move(move.kind, mean + rng.uniform(0.75, 1.25) * (rows - mean), move.period / tempo,
                move.swings)


def mixture(styles, seed, seconds, blend=9, varied=False):
    """As in the measurements that the limits come from: two or three takes of a gait or one of
    another kind, never the same kind twice in a row, joined within 0.3 s; no rests."""
    rng = np.random.default_rng([seed, 9])
    style = sorted(styles)[seed % len(styles)]
    kinds = sorted({move.kind for move in styles[style]})
    joined, last = Joined(), None
    while joined.count < seconds * FPS:
        kind = str(rng.choice(kinds))
        if kind == last:
            continue
        last = kind
        takes = [move for move in styles[style] if move.kind == kind]
        for i in rng.integers(len(takes), size=rng.integers(2, 4) if kind in GAIT else 1):
            move = changed(rng, takes[i]) if varied else takes[i]
            joined.add("cyclic" if move.cyclic else "action", kind, move.rows, blend, move.piece())
    return joined.recording(f"moves, {style}, {seconds / 60:g} min", "begin")


def mixture_with_rests(styles, seed, seconds, varied=False):
    """Parts of 2 to 20 s, rests of 0.5 to 3 s, blends of 0.1 to 0.5 s. Gaits are repeated to their
    length and cut."""
    rng = np.random.default_rng([seed, 10])
    style = sorted(styles)[seed % len(styles)]
    moves = styles[style]
    kinds = sorted({move.kind for move in moves})
    standing = next(move for move in moves if move.kind not in GAIT).rows[0]
    reach = 0.003 * np.linalg.norm(np.ptp(np.concatenate([m.rows for m in moves]), axis=0))
    joined, last = Joined(), None
    while joined.count < seconds * FPS:
        kind = str(rng.choice(kinds))
        if kind == last:
            continue
        last = kind
        _add_part(rng, joined, [changed(rng, move) if varied else move
                                for move in moves if move.kind == kind])
        if rng.uniform() < 0.4:
            times = np.arange(rng.integers(15, 91)) / FPS
            noise = np.stack([smooth_noise(rng, times, 1) for _ in standing], 1)
            joined.add("rest", "", standing + reach / np.sqrt(len(standing)) * noise,
                       rng.integers(3, 16))
    return joined.recording(f"moves with rests, {style}, {seconds / 60:g} min")


def _add_part(rng, joined, takes):
    kind = takes[0].kind
    left = rng.integers(2 * FPS, 20 * FPS + 1) if kind in GAIT else 1
    while left > 0:
        move = takes[rng.integers(len(takes))]
        rows, piece = move.rows, move.piece()
        if kind in GAIT and left < len(rows):
            rows = rows[:max(left, 10)]
            piece = piece and tuple(column[:len(rows)] for column in piece)
        joined.add("cyclic" if move.cyclic else "action", kind, rows, rng.integers(3, 16), piece)
        left -= len(rows)


def treadmill(styles, seed, minutes, jitter=0.03):
    """The strides of one walk in random order, each warped to a random length."""
    rng = np.random.default_rng([seed, 12])
    walks = [move for moves in styles.values() for move in moves if move.kind == "walk"]
    move = walks[rng.integers(len(walks))]
    times, phase = move.piece()
    marks = np.interp(np.arange(np.ceil(phase[0]), np.floor(phase[-1]) + 1), phase, times)
    count = round(60 * minutes / move.period)
    ends = np.cumsum(move.period * np.exp(jitter * rng.normal(size=count)))
    frames = np.arange(int(ends[-1] * FPS)) / FPS
    phase = np.interp(frames, np.r_[0, ends], np.arange(count + 1))
    order = rng.integers(len(marks) - 1, size=count)
    stride, share = phase.astype(int), (phase % 1)[:, None]
    rows = pose_at(move, marks, order[stride], share[:, 0])
    # Each stride begins where the one before it ended, and loses the difference on its way.
    last, first = (pose_at(move, marks, order, np.full(count, at)) for at in (1.0, 0.0))
    jump = np.concatenate([first[:1] * 0, last[:-1] - first[1:]])
    rows += (1 - smoothstep(share)) * jump[stride]
    rows += 0.002 * np.ptp(move.rows) * rng.normal(size=rows.shape)
    part = Part("cyclic", "walk", 0, len(rows) / FPS, [(frames, phase)])
    return Recording(f"real strides, {minutes:g} min", FPS, rows, [part])


def pose_at(move, marks, stride, share):
    """Poses of a move; stride and share of it, one a row."""
    at = (marks[stride] + share * (marks[stride + 1] - marks[stride])) * FPS
    below = np.minimum(at.astype(int), len(move.rows) - 2)
    rest = (at - below)[:, None]
    return (1 - rest) * move.rows[below] + rest * move.rows[below + 1]
