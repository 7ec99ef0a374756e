# SPDX-License-Identifier: BSD-3-Clause
"""Motions of the synthetic body. Each is a difference from the standing pose, in its channels."""

import numpy as np

# Cyclic motions: seconds per cycle, and for each channel (mean, cosine, sine, cosine and sine of the
# second harmonic) in degrees, or cm for the place. "walking" is the walker's stride times a factor.
CYCLIC = {
    "walk": (1.1, {"walking": 1}),
    "run": (0.72, {"walking": 1.2, "LeftForeArm.Y": (-55,), "RightForeArm.Y": (55,),
                   "LeftLeg.X": (18, 0, -16), "RightLeg.X": (18, 0, 16), "Hips.X": (8,),
                   "place.Y": (2, 0, 0, 3, 1)}),
    "jumping jack": (1.05, {"LeftArm.Z": (65, -65, 0, 6), "RightArm.Z": (-65, 65, 0, -6),
                            "LeftUpLeg.Z": (12, -12), "RightUpLeg.Z": (-12, 12),
                            "place.Y": (2, -2, 0, 4, 2)}),
    "twist": (1.8, {"Spine.Y": (0, 0, 35), "Neck.Y": (0, 0, -15), "Hips.Y": (0, 0, 12),
                    "LeftArm.Z": (70, 0, 5), "RightArm.Z": (-70, 0, 5)}),
    "arm circles": (1.5, {"LeftArm.Z": (60, 30), "RightArm.Z": (-60, -30),
                          "LeftArm.Y": (0, 0, 30), "RightArm.Y": (0, 0, -30)}),
    "knee raises": (1.6, {"LeftUpLeg.X": (-30, -34, 0, -4), "RightUpLeg.X": (-30, 34, 0, -4),
                          "LeftLeg.X": (34, 38, 0, 4), "RightLeg.X": (34, -38, 0, 4),
                          "LeftArm.Y": (0, 0, 20), "RightArm.Y": (0, 0, 20)}),
    "squats without pause": (2.2, {"LeftUpLeg.X": (-38, 38), "RightUpLeg.X": (-38, 38),
                                   "LeftLeg.X": (76, -76), "RightLeg.X": (76, -76),
                                   "LeftFoot.X": (-38, 38), "RightFoot.X": (-38, 38),
                                   "Spine.X": (15, -15), "place.Y": (-18, 18, 0, -1),
                                   "LeftArm.Y": (-35, 35), "RightArm.Y": (35, -35)}),
    "wave right": (0.7, {"RightArm.Z": (-60, 0, 4), "RightForeArm.Z": (-60, 28),
                         "RightHand.Z": (0, 12, 8)}),
    "wave left": (0.85, {"LeftArm.Z": (70, 0, 4), "LeftForeArm.Z": (50, 0, 30),
                         "LeftHand.Z": (0, 10, 6)}),
    "wave both": (0.9, {"RightArm.Z": (-85, -22), "LeftArm.Z": (85, 22),
                        "RightForeArm.Z": (-30, -20, 6), "LeftForeArm.Z": (30, 20, -6)}),
    "clap": (0.6, {"LeftArm.Y": (-70, 0, 6), "RightArm.Y": (70, 0, -6),
                   "LeftForeArm.Y": (-25, 22), "RightForeArm.Y": (25, -22)}),
    "tap right foot": (0.5, {"RightUpLeg.X": (-12,), "RightLeg.X": (6,),
                             "RightFoot.X": (-4, -12, 4)}),
}

# Single actions: shortest and longest duration, share of it to rise and to fall, and the pose
# reached. They begin and end standing.
SINGLE = {
    "squat": (1.6, 2.4, 0.45, 0.45, {"LeftUpLeg.X": -75, "RightUpLeg.X": -75, "LeftLeg.X": 150,
                                     "RightLeg.X": 150, "LeftFoot.X": -75, "RightFoot.X": -75,
                                     "Spine.X": 28, "place.Y": -60, "LeftArm.Y": -70,
                                     "RightArm.Y": 70}),
    "kick": (0.9, 1.3, 0.4, 0.55, {"RightUpLeg.X": -70, "RightLeg.X": 8, "Spine.X": -8,
                                   "LeftArm.Y": -35, "RightArm.Y": -25}),
    "punch": (0.7, 1.0, 0.35, 0.55, {"RightArm.Y": 85, "Spine.Y": 25, "Hips.Y": 8,
                                     "LeftForeArm.Y": -70, "LeftUpLeg.X": -8}),
    "raise right": (1.8, 2.6, 0.4, 0.4, {"RightArm.Z": -155, "Spine.Z": 3}),
    "raise left": (1.8, 2.6, 0.4, 0.4, {"LeftArm.Z": 150, "Spine.Z": -3}),
    "bow": (1.8, 2.8, 0.4, 0.4, {"Spine.X": 50, "Hips.X": 18, "Neck.X": 12, "place.Z": -8}),
}


def minimum_jerk(u):
    v = np.clip(u, 0, 1)
    return v ** 3 * (10 + v * (-15 + 6 * v))


def smooth_noise(rng, times, knot_s):
    """Gaussian noise of unit variance that changes within knot_s seconds, twice differentiable. It
    takes one number from rng, so that what follows does not depend on the number of frames."""
    at = (times - times[0]) / knot_s
    knots = np.random.default_rng(rng.integers(2 ** 63)).normal(size=int(at[-1]) + 5)
    i = at.astype(int)
    u = at - i
    # Weights of the cubic B-spline; their squares sum to 0.4794 on average.
    weights = ((1 - u) ** 3, 3 * u ** 3 - 6 * u ** 2 + 4, -3 * u ** 3 + 3 * u ** 2 + 3 * u + 1,
               u ** 3)
    return sum(w * knots[i + k] for k, w in enumerate(weights)) / 6 / np.sqrt(0.4794)


def posed(body, poses, n):
    """Adds up channels given by name; values are numbers or one per frame."""
    rows = np.zeros((n, len(body.channels)))
    for channel, value in poses.items():
        rows[:, body.column(channel)] += value
    return rows


def cyclic(body, name, phase):
    """The motion of CYCLIC at each phase."""
    turns = 2 * np.pi * (phase % 1)
    basis = (np.ones_like(turns), np.cos(turns), np.sin(turns), np.cos(2 * turns),
             np.sin(2 * turns))
    waves = dict(CYCLIC[name][1])
    walking = waves.pop("walking", 0)
    rows = posed(body, {channel: sum(c * b for c, b in zip(wave, basis))
                        for channel, wave in waves.items()}, len(phase))
    if walking:
        rows += walking * body.walking(phase)
    return rows


def single(body, name, share):
    """The motion of SINGLE; share of its duration, outside [0, 1] standing."""
    _, _, rise, fall, pose = SINGLE[name]
    height = minimum_jerk(share / rise) * minimum_jerk((1 - share) / fall)
    return height[:, None] * posed(body, pose, 1)


def sway(rng, body, times, degrees):
    """The slow sway of a standing body about its ankles and in its trunk, and as much again within a
    minute."""
    def noise(knot_s):
        return smooth_noise(rng, times, knot_s) + smooth_noise(rng, times, 40 * knot_s)
    waves = {channel: degrees * size * noise(knot_s)
             for channel, size, knot_s in (("Hips.X", 0.7, 1.3), ("Hips.Z", 0.5, 1.7),
                                           ("Spine.X", 0.6, 1.1), ("Spine.Y", 1.0, 1.9),
                                           ("Neck.Y", 1.2, 1.5), ("LeftArm.Y", 0.8, 1.2),
                                           ("RightArm.Y", 0.8, 1.4))}
    waves["place.X"] = 0.6 * degrees * noise(1.6)
    waves["place.Z"] = 0.6 * degrees * noise(1.4)
    return posed(body, waves, len(times))
