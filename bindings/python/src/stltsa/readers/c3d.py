# SPDX-License-Identifier: BSD-3-Clause
"""C3D files, by ezc3d: markers, gaps (negative residuals) and events."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from ..clip import Clip
from ..errors import QualityWarning
from ..events import Event
from . import extra, said_of

if TYPE_CHECKING:
    from pathlib import Path

# Computed quantities, which are not positions: parameters that list them, and ends of their names.
_MODELED = ("ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS")
_ENDS = tuple(f"{word}{s}" for word in ("Angle", "Force", "Moment", "Power") for s in ("", "s"))


def _values(group: Any, name: str) -> list[Any]:
    return list(group[name]["value"]) if name in group else []


def read_events(file: Any, fps: float | None = None) -> tuple[Event, ...]:
    """Return the events of an opened file, in seconds from its first frame; `fps`: another rate."""
    group = file["parameters"].get("EVENT", {})
    labels = [str(label).strip() for label in _values(group, "LABELS")]
    contexts = [str(context).strip() for context in _values(group, "CONTEXTS")]
    if not labels:
        return ()
    minutes, seconds = np.asarray(group["TIMES"]["value"], dtype=np.float64).reshape(2, -1)
    first, rate = (file["header"]["points"][key] for key in ("first_frame", "frame_rate"))
    at = (60 * minutes + seconds - first / rate) * (rate / fps if fps else 1)
    contexts += [""] * (len(labels) - len(contexts))
    return tuple(sorted(map(Event, labels, contexts, at.tolist()), key=lambda e: e.seconds))


def read(path: Path, fps: float | None = None) -> Clip:
    """Return the markers of a file as a clip of points, with its events."""
    ezc3d = extra("ezc3d", "c3d")
    with said_of(path, OSError, RuntimeError, ValueError):
        file = ezc3d.c3d(str(path))  # missing points are NaN
    point = file["parameters"]["POINT"]
    points = np.asarray(file["data"]["points"], dtype=np.float64)[:3].transpose(2, 1, 0)
    names = [str(name).strip() for name in _values(point, "LABELS")[: points.shape[1]]]
    modeled = {str(label).strip() for kind in _MODELED for label in _values(point, kind)}
    guessed = {name for name in names if name.endswith(_ENDS)} - modeled
    if guessed:
        text = f"left out, as their names are of angles or forces: {', '.join(sorted(guessed))}"
        warnings.warn(f"{path}: {text}", QualityWarning, stacklevel=3)
    kept = [i for i, name in enumerate(names) if name not in modeled | guessed]
    rate = fps or float(point["RATE"]["value"][0])
    clip = Clip.from_points(points[:, kept], rate, names=[names[i] for i in kept])
    clip.events = read_events(file, fps)
    return clip
