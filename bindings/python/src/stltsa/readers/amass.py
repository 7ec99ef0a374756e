# SPDX-License-Identifier: BSD-3-Clause
"""AMASS files: rotations of the body joints of a SMPL, SMPL-H or SMPL-X skeleton.

The file has rotations and no lengths of bones, which come from a body model with its own license.
The usual proportions of an adult stand in for them; give `offsets` to use those of a model.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any
from zipfile import is_zipfile

import numpy as np

from ..clip import Clip
from . import bad, rate_of, said_of

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path
    from zipfile import ZipInfo

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


# Poses are noisy and shrink little when they are compressed. An array is refused if it is larger
# than this, and so many times as large as what is stored of it: it would fill the memory.
_MOST_BYTES, _MOST_SHRUNK = 64 * 2**20, 100
_MOST = 1e100  # the square of a larger number may be infinite


def _check_sizes(path: Path, members: Iterable[ZipInfo]) -> None:
    """Raise if a small file declares large arrays, before any of them is read."""
    for member in members:
        if member.file_size > max(_MOST_BYTES, _MOST_SHRUNK * member.compress_size):
            raise bad(
                path,
                f"{member.filename} would have {member.file_size} bytes, of which "
                f"{member.compress_size} are stored: poses do not shrink so much",
            )


def _numbers(path: Path, file: Any, name: str, columns: int = 0) -> npt.NDArray[Any]:
    """Return an array of the file, checked: frames in rows, and `columns` columns if given."""
    values: npt.NDArray[Any] = file[name]
    if values.dtype.kind not in "fiu":
        raise bad(path, f"{name} holds {values.dtype}, and must hold real numbers")
    if values.ndim != 2 or not values.size or (columns and values.shape[1] != columns):
        shape = " x ".join(map(str, values.shape))
        raise bad(path, f"{name} is {shape or 'one number'}, and must be frames x {columns or 'n'}")
    wrong = np.flatnonzero(~(np.abs(values) <= _MOST).all(axis=1))
    if len(wrong):
        raise bad(path, f"{name} has a number in frame {wrong[0]} that is NaN or beyond {_MOST}")
    return values


def _rate(path: Path, file: Any) -> float | None:
    """Return the frames per second; None: the file does not say."""
    names = [name for name in ("mocap_framerate", "mocap_frame_rate") if name in file]
    return rate_of(path, names[0], file[names[0]]) if names else None


def _arrays(
    path: Path, fps: float | None
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64], float]:
    """Return the rotations of the body, the way of its root, and the rate."""
    if not is_zipfile(path):
        raise bad(path, "the file cannot be read: it is no npz archive")
    with np.load(path) as file:
        _check_sizes(path, file.zip.infolist())
        rate = fps or _rate(path, file)
        # SMPL-X files may have the body in parts.
        parts = [p for p in (("poses",), ("root_orient", "pose_body")) if set(p) <= set(file.files)]
        if not parts or "trans" not in file or not rate:
            wanted = "poses (or root_orient and pose_body), trans and mocap_framerate"
            has = ", ".join(file.files)
            raise bad(path, f"an AMASS file has the arrays {wanted}; this one has {has}")
        arrays = {name: _numbers(path, file, name) for name in parts[0]}
        way = _numbers(path, file, "trans", 3)
    for name, array in arrays.items():
        if len(array) != len(way) or array.shape[1] % 3:
            shape = " x ".join(map(str, array.shape))
            raise bad(path, f"{name} is {shape}, and must be {len(way)} (as trans) x 3 n")
    turns = np.concatenate(list(arrays.values()), axis=1)[:, : 3 * len(_BODY)]
    return turns.astype(np.float64), way.astype(np.float64), rate


def read(path: Path, fps: float | None = None, offsets: npt.ArrayLike | None = None) -> Clip:
    """Return the clip of a file; `offsets`: of the 22 body joints, shape (22, 3)."""
    with said_of(path, Exception):  # a broken archive raises whatever its parts meet first
        turns, way, rate = _arrays(path, fps)
    turns = turns.reshape(len(turns), -1, 3)  # axis times angle
    half = np.linalg.norm(turns, axis=2, keepdims=True) / 2
    quaternions = np.concatenate([np.cos(half), np.sinc(half / np.pi) / 2 * turns], axis=2)
    names, parents, usual = zip(*_BODY[: quaternions.shape[1]], strict=True)
    places = np.asarray(usual if offsets is None else offsets, dtype=np.float64)
    return Clip.from_skeleton(
        names, parents, places, quaternions, rate, root_positions=way + places[0]
    )
