# SPDX-License-Identifier: BSD-3-Clause
"""Stick figures: the body of a clip seen from its right, as the command draws it."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .._arrays import FloatArray
    from ..clip import Clip

FAR, MIDDLE, NEAR = -1, 0, 1


class SideView:
    """Postures in the plane in which the body walks or, in place, in its plane of symmetry.

    The path and the yaw of the root are removed (tools/plot/side_view.cpp).

    Attributes
    ----------
    bones : list of (int, int)
        Pairs of joints to connect.
    depth : list of int
        FAR, MIDDLE or NEAR for each bone: the side of the body on which it is.
    head : (int, int) or None
        The bone around whose middle the head is drawn.
    radius : float
        Radius of the head.
    """

    def __init__(self, clip: Clip) -> None:
        up = "xyz".index(json.loads(clip.to_json())["up_axis"])
        first, second = (up + 1) % 3, (up + 2) % 3
        start = clip.facts["body_root"]  # joints above the body are left out
        places, rotations = clip.positions[:, start:], clip.rotations[:, start]
        yaw = 2 * np.arctan2(rotations[:, 1 + up], rotations[:, 0])
        self._turn = np.stack([np.cos(yaw), np.sin(yaw)], axis=1)
        root = places[:, 0, [first, second]]
        u, v = self._unturned(places[:, :, first] - root[:, :1], places[:, :, second] - root[:, 1:])
        height = places[:, :, up]
        parents = [int(p) - start for p in clip.parents[start:]]
        self.bones = [(p, j) for j, p in enumerate(parents) if p >= 0]
        forward = self._travel(root, float(np.ptp(height.mean(axis=0))))
        if forward is None:
            forward = self._toes(u.mean(axis=0), v.mean(axis=0), height.mean(axis=0))
        along = u * forward[0] + v * forward[1]
        right = (u * forward[1] - v * forward[0]).mean(axis=0)
        sides = right / max(float(np.abs(right).max()), 1e-300)
        self.depth = [
            NEAR if sides[j] > 0.1 else FAR if sides[j] < -0.1 else 0 for _, j in self.bones
        ]
        self._points = np.stack([along, height - self._ground(height)[:, None]], axis=2)
        self.head = self._head([name.lower() for name in clip.joints[start:]])
        self.radius = float(np.ptp(height.mean(axis=0))) / 16 if self.head else 0.0
        self.tallest = float(self._points[:, :, 1].max()) + self.radius

    def _unturned(self, x: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return horizontal vectors of each frame without the yaw."""
        cos, sin = self._turn[:, :1], self._turn[:, 1:]
        return cos * x + sin * y, cos * y - sin * x

    def _travel(self, root: FloatArray, body: float) -> FloatArray | None:
        """Return the direction of travel relative to the body; None if it stays in place."""
        steps = np.zeros_like(root)
        steps[1:] = np.diff(root, axis=0)
        u, v = self._unturned(steps[:, :1], steps[:, 1:])
        net = np.array([u.sum(), v.sum()])
        length, path = np.hypot(*net), np.hypot(*steps.T).sum()
        if length < 0.5 * path or length < 0.5 * body or length == 0:
            return None
        return np.asarray(net / length)

    def _toes(self, x: FloatArray, y: FloatArray, height: FloatArray) -> FloatArray:
        """Return the direction across which the body is widest, with the toes in front."""
        widest = 0.5 * np.arctan2(2 * x @ y, x @ x - y @ y)
        across = np.array([-np.sin(widest), np.cos(widest)])
        knee = height.min() + 0.2 * np.ptp(height)
        feet = sum(
            (x[j] - x[p]) * across[0] + (y[j] - y[p]) * across[1]
            for p, j in self.bones
            if height[j] < knee and height[p] < knee
        )
        return -across if feet < 0 else across

    def _ground(self, height: FloatArray) -> FloatArray:
        """Return one floor for all frames or, if the body climbs, the lowest joint of each."""
        lowest = height.min(axis=1)
        tallest = np.ptp(height, axis=1).max()
        low, middle, high = np.quantile(lowest, [0.05, 0.5, 0.95], method="lower")
        level = high - low < 0.5 * tallest
        return np.full_like(lowest, middle) if level else lowest

    def _head(self, names: list[str]) -> tuple[int, int] | None:
        for parent, joint in self.bones:
            head = parent if "head" in names[parent] else joint
            if "head" in names[head]:
                beyond = [bone for bone in self.bones if bone[0] == head]
                return beyond[0] if beyond else (parent, joint)
        return None

    def posture(self, frame: int) -> FloatArray:
        """Return the joints as points: forward of the root, and above the ground."""
        return np.asarray(self._points[frame])

    def middle_of_head(self, frame: int) -> FloatArray | None:
        """Return the middle of the head; None if no joint has "head" in its name."""
        if self.head is None:
            return None
        neck, crown = self._points[frame, self.head[0]], self._points[frame, self.head[1]]
        length = np.linalg.norm(crown - neck)
        share = max(0.5, self.radius / length) if length > 0 else 0.0
        return np.asarray(neck + share * (crown - neck))
