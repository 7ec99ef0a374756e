# SPDX-License-Identifier: BSD-3-Clause
"""Recordings of the synthetic body: treadmills, changes of tempo, hands, repetitions, mixtures."""

import numpy as np

from . import motions
from .compose import Cyclic, Group, Rest, Single, compose
from .truth import Part, Recording


def treadmill(body, seed, minutes, fps=30):
    rng = np.random.default_rng([seed, 1])
    period = rng.uniform(1, 1.25)
    return compose(f"treadmill, {minutes:g} min", rng, body,
                   [Cyclic("walk", 60 * minutes, period)], fps)


def equal_strides(body, count=1200, fps=30):
    """Strides of 33 frames whose rows repeat to the bit."""
    phase = (np.arange(33 * count) % 33) / 33
    rows = body.stand + body.walking(phase)
    times = np.arange(len(rows)) / fps
    part = Part("cyclic", "walk", 0, len(rows) / fps, [(times, np.arange(len(rows)) / 33)])
    return Recording(f"{count} equal strides", fps, rows, [part], body)


def tempo_ramp(body, seed, seconds=60):
    """From 1.6 to 0.8 s a stride and back."""
    rng = np.random.default_rng([seed, 2])
    walk = Cyclic("walk", 2 * seconds, lambda t: 0.8 + 0.8 * np.abs(t / seconds - 1), 0.01)
    return compose("tempo from 1.6 to 0.8 s and back", rng, body, [walk])


def tempo_steps(body, seed, seconds=20):
    """The period changes by a third within a tenth of a second, four times."""
    rng = np.random.default_rng([seed, 3])
    periods = np.array([1.2, 0.8, 1.2, 0.9, 1.2])

    def period(t):
        edges = seconds * np.arange(1, len(periods))
        return np.interp(t, np.sort(np.r_[edges - 0.05, edges + 0.05]),
                         np.repeat(periods, 2)[1:-1])
    walk = Cyclic("walk", len(periods) * seconds, period, 0.01)
    return compose("tempo in steps of a third", rng, body, [walk])


def slowing(body, seed):
    """Strides of 1.1 s for 15 s, then twice as long every 4 s, then a stop within a second, on one
    leg. It stands when the phase has less than a tenth of its speed."""
    rng = np.random.default_rng([seed, 4])

    def period(t):
        slow = 1.1 * 2 ** (np.clip(t - 15, 0, 8) / 4)
        return slow / np.maximum(1 - motions.minimum_jerk(t - 23), 1e-9)
    walk = Cyclic("walk", 28, period, 0.01, 0)
    recording = compose("slowing to a stop", rng, body, [walk], sway=0, noise=0.1)
    part = recording.parts[0]
    times, phase = part.pieces[0]
    still = float(times[motions.minimum_jerk(times - 23) < 0.9][-1])
    part.pieces = [(times[times <= still], phase[times <= still])]
    part.end = still
    recording.parts.append(Part("rest", "", still, recording.seconds))
    return recording


# Joints that carry the motion; another one may not be named.
CARRIED = {"wave right": ("RightArm", "RightForeArm", "RightHand"),
           "wave left": ("LeftArm", "LeftForeArm", "LeftHand"),
           "wave both": ("LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm",
                         "RightHand"),
           "clap": ("LeftArm", "LeftForeArm", "LeftHand", "RightArm", "RightForeArm", "RightHand"),
           "tap right foot": ("RightUpLeg", "RightLeg", "RightFoot", "RightToeBase")}


def one_part(body, seed, name, seconds=20):
    """One hand or foot moves while the body sways; it stands before and after."""
    rng = np.random.default_rng([seed, 5, sorted(CARRIED).index(name)])
    period = motions.CYCLIC[name][0] * rng.uniform(0.85, 1.2)
    sequence = [Rest(rng.uniform(2, 4)), Cyclic(name, seconds, period, 0.03, 0.08),
                Rest(rng.uniform(2, 4))]
    return compose(f"{name}, swaying", rng, body, sequence, blend=(0.4, 0.8), sway=1.5)


def repetitions(body, seed, name):
    rng = np.random.default_rng([seed, 6, sorted(motions.SINGLE).index(name)])
    group = Group(rng, name, int(rng.integers(5, 13)))
    sequence = [Rest(rng.uniform(1, 3)), group, Rest(rng.uniform(1, 3))]
    return compose(f"{name}, {len(group.lengths)} times", rng, body, sequence)


def mixture(body, seed, seconds=600, rest_share=0.4, fps=30):
    """Five cyclic motions, two single actions and two groups, in parts of 2 to 20 s; between some,
    rests of 0.5 to 3 s."""
    rng = np.random.default_rng([seed, 7])
    actions = rng.permutation(sorted(motions.SINGLE))
    makers = [_cyclic_maker(rng, name) for name in rng.permutation(sorted(motions.CYCLIC))[:5]]
    makers += [lambda name=name: Single(name, rng.uniform(*motions.SINGLE[name][:2]))
               for name in actions[:2]]
    makers += [lambda name=name: Group(rng, name, int(rng.integers(3, 7)))
               for name in actions[2:4]]
    sequence, last = [], None
    while sum(motion.seconds for motion in sequence) < seconds:
        kind = int(rng.integers(len(makers)))
        if kind == last:
            continue
        last = kind
        sequence.append(makers[kind]())
        if rng.uniform() < rest_share:
            sequence.append(Rest(rng.uniform(0.5, 3)))
    return compose(f"mixture {seed}, {seconds / 60:g} min", rng, body, sequence, fps)


def _cyclic_maker(rng, name):
    period = motions.CYCLIC[name][0] * rng.uniform(0.87, 1.15)
    size = rng.uniform(0.85, 1.1)
    return lambda: Cyclic(name, rng.uniform(2, 20), period * np.exp(0.03 * rng.normal()), size=size)


def acyclic(body, seed, minutes):
    """Recordings in which nothing repeats."""
    rng = np.random.default_rng([seed, 8])
    fps, n = 30, round(minutes * 60 * 30)
    times = np.arange(n) / fps

    def plain(name, rows):
        return Recording(f"{name}, {minutes:g} min", fps, rows,
                         [Part("free", "noise", 0, n / fps)])
    yield plain("white noise, 30 columns", rng.normal(size=(n, 30)))
    for columns in (30, 4):
        for knot in (0.1, 0.3, 1):
            yield plain(f"noise of {knot} s, {columns} columns", np.stack(
                [motions.smooth_noise(rng, times, knot) for _ in range(columns)], 1))
    drift = np.cumsum(rng.normal(size=(n, 12)), 0) / np.sqrt(n)
    yield plain("slow drift", drift + 0.002 * rng.normal(size=drift.shape))
    yield compose(f"standing and swaying, {minutes:g} min", rng, body, [Rest(60 * minutes)], sway=2)
    sequence = [Rest(2)]
    for name in rng.permutation(sorted(motions.SINGLE)):
        sequence += [Single(name, rng.uniform(*motions.SINGLE[name][:2])), Rest(rng.uniform(1, 3))]
    yield compose("each action once", rng, body, sequence)
