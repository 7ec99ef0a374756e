# SPDX-License-Identifier: BSD-3-Clause
"""Stick figures: the body of a clip, seen from its right or left side."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .._arrays import FloatArray
    from ..clip import Clip


class SideView:
    """Postures in the plane of largest movement, toes pointing right.

    Root position and yaw are removed as in the library's features `positions`.

    Attributes
    ----------
    bones : list of (int, int)
        Pairs of joints to connect.
    far : ndarray of bool
        Which bones are on the far side of the body.
    """

    def __init__(self, clip: Clip) -> None:
        body = clip.features("positions").reshape(len(clip), -1, 3)
        up = "xyz".index(json.loads(clip.to_json())["up_axis"])
        height = body[:, :, up]
        flat = np.delete(body, up, axis=2)
        self.bones = [(p, j) for j, p in enumerate(clip.parents) if p >= 0]
        forward = self._forward(flat, height)
        ground = np.median(height.min(axis=1))
        across = flat.mean(axis=0) @ np.array([-forward[1], forward[0]])
        sides = across[[j for _, j in self.bones]] / max(float(np.abs(across).max()), 1e-12)
        self.far = sides > 0.1
        self._points = np.stack([flat @ forward, height - ground], axis=2)
        self._points /= max(float(np.ptp(self._points[:, :, 1])), 1e-12)

    def _forward(self, flat: FloatArray, height: FloatArray) -> FloatArray:
        """Return the direction of largest movement, with the toes in front."""
        moving = (flat - flat.mean(axis=0)).reshape(-1, 2)
        direction = np.linalg.eigh(moving.T @ moving)[1][:, -1]
        low, mean = height.mean(axis=0), flat.mean(axis=0)
        knee = low.min() + 0.2 * np.ptp(low)
        feet = [mean[j] - mean[p] for p, j in self.bones if low[j] < knee and low[p] < knee]
        sign = 1.0 if not feet or np.sum(feet, axis=0) @ direction >= 0 else -1.0
        return np.asarray(sign * direction)

    def posture(self, frame: int) -> list[FloatArray]:
        """Return each bone as two points, in units of the largest height of the clip."""
        return [self._points[frame, list(bone)] for bone in self.bones]
