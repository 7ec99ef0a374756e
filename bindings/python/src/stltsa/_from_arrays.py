# SPDX-License-Identifier: BSD-3-Clause
"""Handles of clips from arrays of points or of a skeleton."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import as_matrix, read_from, unmasked
from ._call import made, new
from ._native import ffi, lib
from ._text import c_text

if TYPE_CHECKING:
    from collections.abc import Sequence

_FORMS = {2: lib.STLTSA_ROTATIONS_CHANNELS, 3: lib.STLTSA_ROTATIONS_QUATERNION,
          4: lib.STLTSA_ROTATIONS_MATRIX}  # fmt: skip


def _flat(values: Any, shape: str, dimensions: tuple[int, ...], what: str) -> Any:
    """Return an array with a row per frame; `shape` is what is expected."""
    array = np.asarray(unmasked(values))
    if array.ndim not in dimensions or (array.ndim > 2 and array.shape[0] == 0):
        raise ValueError(f"{what} must have the shape {shape}; it has {array.shape}")
    return as_matrix(array if array.ndim == 2 else array.reshape(len(array), -1), what)


def _texts(values: Sequence[str]) -> list[Any]:
    return [c_text(str(value), "a name") for value in values]


def points_handle(
    positions: Any,
    *,
    fps: float | None,
    names: Sequence[str] | None,
    confidence: Any,
    times: Any,
    min_confidence: float | None,
) -> Any:
    """Return a handle of a clip of points; arguments as of ``Clip.from_points``."""
    array = np.asarray(unmasked(positions))
    rows = _flat(array, "(frames, points, 2 or 3)", (3,), "positions")
    if names is not None and len(names) != array.shape[1]:
        raise ValueError(f"there are {len(names)} names for {array.shape[1]} points")
    texts = _texts(names or ())
    given: dict[str, Any] = {"confidence": None, "times": None}
    if confidence is not None:
        given["confidence"] = _flat(confidence, "(frames, points)", (2,), "confidence")
    if times is not None:
        given["times"] = as_matrix(np.asarray(times, dtype=np.float64).reshape(-1, 1), "times")
    raw = ffi.new("stltsa_points *", {"size": ffi.sizeof("stltsa_points")})
    raw.space = array.shape[2]
    raw.positions = read_from(rows)[0]
    pointers = ffi.new("char const *[]", texts) if texts else ffi.NULL
    raw.names = pointers
    for name, values in given.items():
        if values is not None:
            setattr(raw, name, read_from(values)[0])
    raw.fps = 0.0 if fps is None else float(fps)
    options = {"min_confidence": min_confidence}
    return made("clip", lib.stltsa_clip_from_points, raw, options=options)


def skeleton_handle(
    names: Sequence[str],
    *,
    parents: Any,
    offsets: Any,
    rotations: Any,
    fps: float,
    root_positions: Any,
    channels: Sequence[str | None] | None,
    end_sites: Any,
) -> Any:
    """Return a handle of a clip of a skeleton; arguments as of ``Clip.from_skeleton``."""
    array = np.asarray(rotations)
    shape = "(frames, joints, 4), (frames, joints, 3, 3) or (frames, channels)"
    rows = _flat(array, shape, tuple(_FORMS), "rotations")
    places = np.asarray(offsets, dtype=np.float64)
    count = len(names)
    if places.shape != (count, 3) or len(parents) != count:
        raise ValueError(
            f"there are {count} names, {len(parents)} parents, and offsets of the shape "
            f"{places.shape}: expected ({count}, 3)"
        )
    ends = np.zeros(count, dtype=bool) if end_sites is None else np.asarray(end_sites, dtype=bool)
    if ends.shape != (count,) or (channels is not None and len(channels) != count):
        raise ValueError(f"end_sites and channels must have an entry for each of {count} joints")
    texts = _texts(names)
    words = [None if c is None else c_text(c, "an entry of channels") for c in channels or ()]
    joints = ffi.new("stltsa_joint[]", count)
    for j, joint in enumerate(joints):
        joint.name, joint.parent = texts[j], int(parents[j])
        joint.offset = places[j].tolist()
        joint.is_end_site = int(ends[j])
        if words and words[j] is not None:
            joint.channels = words[j]
    root = None if root_positions is None else as_matrix(root_positions, "root_positions")
    return new(
        "clip",
        lib.stltsa_clip_from_skeleton,
        joints,
        ffi.sizeof("stltsa_joint"),
        count,
        _FORMS[array.ndim],
        read_from(rows),
        ffi.NULL if root is None else read_from(root),
        float(fps),
    )
