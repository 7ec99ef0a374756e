# SPDX-License-Identifier: BSD-3-Clause
"""Puts motions one after another into a recording with its truth."""

from dataclasses import dataclass

import numpy as np

from . import motions
from .truth import Part, Recording


def smoothstep(u):
    v = np.clip(u, 0, 1)
    return v * v * (3 - 2 * v)


def fast_and_slow(rng, times, knot_s):
    return motions.smooth_noise(rng, times, knot_s) + motions.smooth_noise(rng, times, 30)


@dataclass
class Cyclic:
    """A cyclic motion for some seconds. `period` is a number, or a function of the seconds since it
    began; `jitter` the deviation of the logarithm of a cycle's length, `swing` that of the size, each
    from cycle to cycle and, as much again, within half a minute."""

    name: str
    seconds: float
    period: object = None
    jitter: float = 0.02
    swing: float = 0.03
    size: float = 1
    kind = "cyclic"

    def rows(self, rng, body, times):
        period = self.period or motions.CYCLIC[self.name][0]
        lengths = period(times) if callable(period) else np.full(len(times), period)
        knot = float(np.median(lengths[np.isfinite(lengths)]))
        rate = np.exp(self.jitter * fast_and_slow(rng, times, knot)) / lengths
        steps = np.diff(times) * (rate[1:] + rate[:-1]) / 2
        self.phase = rng.uniform() + np.concatenate([[0], np.cumsum(steps)])
        size = self.size * (1 + self.swing * fast_and_slow(rng, times, knot))
        return size[:, None] * motions.cyclic(body, self.name, self.phase)

    def truth(self, part, times, clean):
        part.pieces = [(times[clean] + part.begin, self.phase[clean])]


@dataclass
class Single:
    """One action, from standing to standing."""

    name: str
    seconds: float
    kind = "action"

    def rows(self, rng, body, times):
        return motions.single(body, self.name, times / self.seconds)

    def truth(self, part, times, clean):
        pass


class Group:
    """The same action several times, with pauses."""

    kind = "repetitions"

    def __init__(self, rng, name, count, pauses=(0.5, 3)):
        shortest, longest = motions.SINGLE[name][:2]
        usual = rng.uniform(shortest, longest)
        self.name = name
        self.lengths = usual * np.exp(0.06 * rng.normal(size=count))
        self.sizes = 1 + 0.05 * rng.normal(size=count)
        pauses = rng.uniform(*pauses, size=count - 1)
        self.begins = np.concatenate([[0], np.cumsum(self.lengths[:-1] + pauses)])
        self.seconds = self.begins[-1] + self.lengths[-1]

    def rows(self, rng, body, times):
        return sum(size * motions.single(body, self.name, (times - begin) / length)
                   for begin, length, size in zip(self.begins, self.lengths, self.sizes))

    def truth(self, part, times, clean):
        ends = self.begins + self.lengths
        part.repetitions = [(part.begin + a, part.begin + b) for a, b in zip(self.begins, ends)]
        part.still = [(part.begin + a, part.begin + b) for a, b in zip(ends[:-1], self.begins[1:])]


@dataclass
class Rest:
    """Standing."""

    seconds: float
    name = ""
    kind = "rest"

    def rows(self, rng, body, times):
        return np.zeros((len(times), len(body.channels)))

    def truth(self, part, times, clean):
        pass


def compose(name, rng, body, sequence, fps=30, blend=(0.1, 0.5), sway=0.3, noise=0.3):
    """The recording of a sequence. At a join both motions go on while one fades into the other within
    `blend` seconds; the border lies in the middle. `sway` and `noise` are deviations in degrees."""
    ends = np.cumsum([motion.seconds for motion in sequence])
    begins = ends - [motion.seconds for motion in sequence]
    half = np.concatenate([[0], rng.uniform(*blend, size=len(sequence) - 1) / 2, [0]])
    clock = np.arange(round(ends[-1] * fps)) / fps
    rows = np.tile(body.stand, (len(clock), 1))
    parts = []
    for motion, begin, end, before, after in zip(sequence, begins, ends, half[:-1], half[1:]):
        first, last = np.searchsorted(clock, [begin - before - 1e-9, end + after - 1e-9])
        times = clock[first:last] - begin
        weight = np.ones(len(times))
        if before:
            weight *= smoothstep((times + before) / (2 * before))
        if after:
            weight *= smoothstep((motion.seconds + after - times) / (2 * after))
        rows[first:last] += weight[:, None] * motion.rows(rng, body, times)
        part = Part(motion.kind, motion.name, begin, end)
        motion.truth(part, times, (times >= before) & (times <= motion.seconds - after))
        parts.append(part)
    if sway:
        rows += motions.sway(rng, body, clock, sway)
    rows[:, 3:] += noise * rng.normal(size=rows[:, 3:].shape)
    blends = [(at - h, at + h) for at, h in zip(begins[1:], half[1:])]
    return Recording(name, fps, rows, parts, body, blends)
