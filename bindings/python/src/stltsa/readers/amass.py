# SPDX-License-Identifier: BSD-3-Clause
"""AMASS files: rotations of the body joints of a SMPL, SMPL-H or SMPL-X skeleton.

The file has rotations and no lengths of bones, which come from a body model with its own license.
The usual proportions of an adult stand in for them; give `offsets` to use those of a model.
"""

from __future__ import annotations

from typing import TYPE_CHECKING
from zipfile import BadZipFile

import numpy as np

from ..clip import Clip
from . import bad, said_of

if TYPE_CHECKING:
    from pathlib import Path

    import numpy.typing as npt

# Body joints: name, parent, offset in meters (x left, y up, z forward). Hands are left out.
_BODY = (("pelvis", -1, (0, 0.95, 0)), ("left_hip", 0, (0.07, -0.09, 0)),
    ("right_hip", 0, (-0.07, -0.09, 0)), ("spine1", 0, (0, 0.12, -0.02)),
    ("left_knee", 1, (0.03, -0.39, 0)), ("right_knee", 2, (-0.03, -0.39, 0)),
    ("spine2", 3, (0, 0.13, 0)), ("left_ankle", 4, (-0.01, -0.4, -0.03)),
    ("right_ankle", 5, (0.01, -0.4, -0.03)), ("spine3", 6, (0, 0.06, 0.02)),
    ("left_foot", 7, (0.04, -0.06, 0.12)), ("right_foot", 8, (-0.04, -0.06, 0.12)),
    ("neck", 9, (0, 0.21, -0.03)), ("left_collar", 9, (0.08, 0.12, -0.02)),
    ("right_collar", 9, (-0.08, 0.12, -0.02)), ("head", 12, (0, 0.09, 0.05)),
    ("left_shoulder", 13, (0.11, 0.04, -0.01)), ("right_shoulder", 14, (-0.11, 0.04, -0.01)),
    ("left_elbow", 16, (0.26, 0, -0.02)), ("right_elbow", 17, (-0.26, 0, -0.02)),
    ("left_wrist", 18, (0.25, 0, 0)), ("right_wrist", 19, (-0.25, 0, 0)))  # fmt: skip


def read(path: Path, fps: float | None = None, offsets: npt.ArrayLike | None = None) -> Clip:
    """Return the clip of a file; `offsets`: of the 22 body joints, shape (22, 3)."""
    with said_of(path, ValueError, BadZipFile, EOFError), np.load(path) as file:
        rates = [file[k] for k in ("mocap_framerate", "mocap_frame_rate") if k in file]
        # SMPL-X files may have the body in parts.
        parts = [p for p in (("poses",), ("root_orient", "pose_body")) if set(p) <= set(file.files)]
        if not parts or "trans" not in file or not (rates or fps):
            wanted = "poses (or root_orient and pose_body), trans and mocap_framerate"
            has = ", ".join(file.files)
            raise bad(path, f"an AMASS file has the arrays {wanted}; this one has {has}")
        poses = np.concatenate([file[name] for name in parts[0]], axis=1)
        turns = poses[:, : 3 * len(_BODY)].astype(np.float64)
        way = np.asarray(file["trans"], dtype=np.float64)
    turns = turns.reshape(len(turns), -1, 3)  # axis times angle
    half = np.linalg.norm(turns, axis=2, keepdims=True) / 2
    quaternions = np.concatenate([np.cos(half), np.sinc(half / np.pi) / 2 * turns], axis=2)
    names, parents, usual = zip(*_BODY[: quaternions.shape[1]], strict=True)
    places = np.asarray(usual if offsets is None else offsets, dtype=np.float64)
    return Clip.from_skeleton(
        names, parents, places, quaternions, fps or float(rates[0]), root_positions=way + places[0]
    )
