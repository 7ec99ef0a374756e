# SPDX-License-Identifier: BSD-3-Clause
"""The same recording seen otherwise: cropped, mirrored, turned, scaled."""

import copy
import dataclasses

import numpy as np

from .body import about


def changed(recording, name, rows, body=None):
    return dataclasses.replace(recording, name=name, rows=rows, body=body or recording.body)


def mirrored(recording):
    """Left and right exchanged: rotations about y and z and the way along x turn round."""
    body = recording.body
    rows = np.empty_like(recording.rows)
    for i, channel in enumerate(body.channels):
        joint, axis = channel.split(".")
        swapped = {"L": "Right" + joint[4:], "R": "Left" + joint[5:]}.get(joint[0]) \
            if joint.startswith(("Left", "Right")) else joint
        turns_round = axis == "X" if joint == "place" else axis in "YZ"
        rows[:, i] = recording.rows[:, body.column(f"{swapped}.{axis}")] * (-1 if turns_round else 1)
    return changed(recording, "mirrored", rows)


def turned(recording, degrees):
    """The whole body turned about the vertical."""
    rows = recording.rows.copy()
    turn = about(1, np.array([float(degrees)]))
    rows[:, :3] = rows[:, :3] @ turn[0].T
    z, x, y = rows[:, 3:6].T
    r = turn @ about(2, z) @ about(0, x) @ about(1, y)
    rows[:, 3:6] = np.degrees(np.stack([np.arctan2(-r[:, 0, 1], r[:, 1, 1]),
                                        np.arcsin(np.clip(r[:, 2, 1], -1, 1)),
                                        np.arctan2(-r[:, 2, 0], r[:, 2, 2])], 1))
    return changed(recording, f"turned by {degrees} degrees", rows)


def scaled(recording, factor):
    """In another unit of length."""
    body = copy.copy(recording.body)
    body.offsets = [factor * offset for offset in body.offsets]
    body.head = [line if "OFFSET" not in line else "OFFSET " + " ".join(
        f"{factor * float(word):.8g}" for word in line.split()[1:]) for line in body.head]
    rows = recording.rows.copy()
    rows[:, :3] *= factor
    return changed(recording, f"scaled by {factor}", rows, body)


def noisy(recording, degrees, seed):
    """White noise on every rotation channel."""
    rows = recording.rows.copy()
    rows[:, 3:] += degrees * np.random.default_rng([seed, 11]).normal(size=rows[:, 3:].shape)
    return changed(recording, f"noise of {degrees} degrees", rows)


def shifted(answer, seconds):
    """The answer to a crop, in seconds of the whole."""
    result = copy.deepcopy(answer)
    for one in (one for name in ("segments", "units", "cycles", "repetitions")
                for one in result[name]):
        one["begin_s"] += seconds
        one["end_s"] += seconds
    return result
