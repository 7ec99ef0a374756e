# SPDX-License-Identifier: BSD-3-Clause
"""Made-up motion: bodies of points, columns, hands. Lengths in meters unless said otherwise."""

import numpy as np
from recording.body import about
from recording.motions import minimum_jerk, smooth_noise

# Forward, left, up of the left side and the middle; points of the right side are mirrored.
STAND = {"Ankle": (0, 0.10, 0.08), "Knee": (0.02, 0.10, 0.50), "Hip": (0, 0.10, 0.95),
         "Shoulder": (0, 0.19, 1.45), "Elbow": (0, 0.24, 1.15), "Wrist": (0.05, 0.22, 0.92),
         "Head": (0, 0, 1.70), "Sacrum": (-0.1, 0, 1.0)}
POINTS = [(side + name, name) for name in STAND for side in ("L", "R") if name not in ("Head", "Sacrum")]
POINTS += [("Head", "Head"), ("Sacrum", "Sacrum")]
NAMES = [full for full, _ in POINTS]
# Shortest and longest duration in seconds, shares of it to rise and to fall, and for each point the
# way to the other end, and from its middle to the arc.
ACTIONS = {
    "squat": (1.6, 2.6, 0.45, 0.47, {
        "Knee": ((0.25, 0.05, -0.08), (0.02, 0, 0.02)), "Hip": ((-0.2, 0, -0.42), (-0.03, 0, 0)),
        "Shoulder": ((0.05, 0, -0.45), (0.03, 0, 0)), "Elbow": ((0.3, 0, -0.3), (0.05, 0.02, -0.05)),
        "Wrist": ((0.55, 0, 0.05), (0.1, 0, -0.15)), "Head": ((0.1, 0, -0.45), (0.05, 0, 0)),
        "Sacrum": ((-0.25, 0, -0.42), (-0.03, 0, 0))}),
    "jack": (0.9, 1.3, 0.46, 0.46, {
        "Ankle": ((0, 0.25, 0), (0, 0, 0.06)), "Knee": ((0, 0.14, -0.02), (0, 0, 0.06)),
        "Hip": ((0, 0.02, -0.04), (0, 0, 0.07)), "Shoulder": ((0, 0, -0.02), (0, 0, 0.07)),
        "Elbow": ((0, 0.1, 0.6), (0, 0.3, 0.07)), "Wrist": ((0, 0.02, 1.1), (0, 0.6, 0.07)),
        "Head": ((0, 0, -0.04), (0, 0, 0.07)), "Sacrum": ((0, 0, -0.04), (0, 0, 0.07))}),
    "bow": (1.8, 3, 0.4, 0.45, {
        "Knee": ((-0.02, 0, 0), (0, 0, 0)), "Hip": ((-0.1, 0, -0.01), (0, 0, 0)),
        "Shoulder": ((0.35, 0, -0.25), (0.03, 0, 0.08)), "Elbow": ((0.3, 0, -0.25), (-0.02, 0, 0.08)),
        "Wrist": ((0.25, 0, -0.25), (-0.04, 0, 0.05)), "Head": ((0.55, 0, -0.4), (0.05, 0, 0.12)),
        "Sacrum": ((-0.12, 0, 0.03), (0, 0, 0))}),
}


def pose(kind, legs, arms):
    """Frames x points x 3; `legs` and `arms` go from 0, standing, to 1."""
    places = []
    for full, name in POINTS:
        way, arc = np.array(ACTIONS[kind][4].get(name, np.zeros((2, 3))))
        share = (arms if name in ("Elbow", "Wrist") else legs)[:, None]
        place = STAND[name] + share * way + 4 * share * (1 - share) * arc
        places.append(place * (1, -1 if full[0] == "R" else 1, 1))
    return np.stack(places, 1)


def still(rng, times, sway, breath, noise):
    """Sway and breathing of a body (deviations in meters), and noise of its points."""
    height = np.array([STAND[name][2] for _, name in POINTS])
    sways = np.stack([smooth_noise(rng, times, 1.3) for _ in "xy"], 1)
    out = np.zeros((len(times), len(NAMES), 3))
    out[:, :, :2] = sway * sways[:, None] * (height / 1.7)[:, None]
    rate = 0.27 * np.exp(0.15 * rng.normal() + 0.1 * smooth_noise(rng, times, 4))
    chest = (height > 0.9) * rng.uniform(0.3, 1, len(height))
    wave = np.sin(2 * np.pi * np.cumsum(rate) * (times[1] - times[0])) * breath
    out += wave[:, None, None] * chest[:, None] * np.array([0.8, 0, 0.6])
    return out + noise * rng.normal(size=out.shape)


def repetitions(rng, kind, count, pauses, rate):
    """Frames x points x 3; begins and ends in seconds. From standing to standing."""
    shortest, longest, rise, fall, _ = ACTIONS[kind]
    lengths = rng.uniform(shortest, longest) * np.exp(0.04 * rng.normal(size=count))
    sizes = 1 + 0.05 * rng.normal(size=count)
    before, after = rng.uniform(0.8, 3, 2)
    waits = rng.uniform(*pauses, size=count) if pauses else np.zeros(count)
    begins = before + np.concatenate([[0], np.cumsum(lengths + waits)[:-1]])
    times = np.arange(round((begins[-1] + lengths[-1] + after) * rate)) / rate
    legs = arms = 0
    for begin, length, size in zip(begins, lengths, sizes):
        share = (times - begin) / length
        legs = legs + size * minimum_jerk(share / rise) * minimum_jerk((1 - share) / fall)
        arms = arms + size * minimum_jerk(share / (rise - 0.05)) * minimum_jerk((1 - share) / (fall + 0.06))
    points = pose(kind, legs, arms)
    points += still(rng, times, rng.uniform(0.001, 0.003), 0.001, rng.uniform(0.0005, 0.002))
    return points, begins, begins + lengths


def clock(rng, seconds, rate, period, jitter):
    """Times, and turns whose pace varies by `jitter`; `period` is a number or a function of time."""
    times = np.arange(round(seconds * rate)) / rate
    lengths = period(times) if callable(period) else np.full(len(times), period)
    pace = np.exp(jitter * smooth_noise(rng, times, float(lengths.mean()))) / lengths
    return times, rng.uniform() + np.cumsum(pace) / rate


def columns(rng, turns, count=6, harmonics=4):
    """Columns of fixed harmonics, of about one unit."""
    h = np.arange(1, harmonics + 1)
    shape = rng.normal(size=(count, 2, harmonics)) / h ** 1.5
    angle = 2 * np.pi * turns[:, None] * h
    return np.cos(angle) @ shape[:, 0].T + np.sin(angle) @ shape[:, 1].T


def hand(rng, kind, seconds=30, rate=100):
    """Millimeters; times and turns; loops within a turn of a spiral."""
    period = {"to and fro": rng.uniform(0.8, 1.3), "there and back": rng.uniform(2.2, 3.2),
              "spiral": rng.uniform(3.2, 4.2)}[kind]
    times, turns = clock(rng, seconds, rate, period, 0.05)
    size = 1 + 0.05 * smooth_noise(rng, times, period)
    swing = (1 - np.cos(2 * np.pi * turns)) / 2
    loops = rng.integers(3, 7)
    if kind == "to and fro":
        x = 150 * np.cos(2 * np.pi * turns)
        y = 0.1 * x * np.sin(2 * np.pi * turns)
    elif kind == "there and back":
        angle = 2 * np.pi * rng.uniform(0.85, 1) * swing
        x, y = 120 * np.cos(angle), 120 * np.sin(angle)
    else:
        radius = 20 + 110 * swing
        angle = 2 * np.pi * loops * turns + 0.15 * smooth_noise(rng, times, period)
        x, y = radius * np.cos(angle), radius * np.sin(angle)
    depth = 0.15 * x + 20 * smooth_noise(rng, times, 6)
    rows = size[:, None] * np.stack([x, depth, y], 1)
    rows += np.stack([8 * smooth_noise(rng, times, 3) for _ in "xyz"], 1)
    turn = about(0, np.array([rng.uniform(0, 360)]))[0] @ about(2, np.array([rng.uniform(0, 360)]))[0]
    return rows @ turn.T + (300, 250, 1500) + 0.3 * rng.normal(size=rows.shape), times, turns, loops


def walk(body, turns, heading=None, treadmill=False):
    """Points of the walker in meters, z up, and their names; heading in degrees."""
    rows = body.stand + body.walking(turns)
    points = body.positions(rows)[:, [n is not None for n in body.names]] / 100
    points = points[:, :, [2, 0, 1]]
    place = np.zeros((len(turns), 3))
    angle = np.zeros(len(turns)) if heading is None else heading
    turn = about(2, angle)
    if not treadmill:
        steps = np.gradient(turns) * body.stride_length / 100
        place[:, :2] = np.cumsum(steps[:, None] * turn[:, :2, 0], 0)
    points = np.einsum("nij,npj->npi", turn, points)
    return points + place[:, None], [n for n in body.names if n]
