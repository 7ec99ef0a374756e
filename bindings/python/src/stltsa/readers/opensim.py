# SPDX-License-Identifier: BSD-3-Clause
"""OpenSim's text files, by pandas: TRC (markers), MOT and STO (joint coordinates)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..clip import Clip
from . import bad, extra

if TYPE_CHECKING:
    from pathlib import Path

    from .._arrays import FloatArray


def _table(path: Path, skip: int) -> FloatArray:
    pandas = extra("pandas", "trc")
    try:
        frame = pandas.read_csv(path, sep="\t", skiprows=skip, header=None, dtype=np.float64)
    except (ValueError, pandas.errors.ParserError) as error:
        raise bad(path, f"the numbers cannot be read: {error}") from error
    return np.asarray(frame)


def read(path: Path, fps: float | None = None) -> Clip:
    """Return the markers or the joint coordinates of a file."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    clip = (_trc if path.suffix.lower() == ".trc" else _mot)(path, lines, fps)
    clip.path = str(path)
    return clip


def _trc(path: Path, lines: list[str], fps: float | None) -> Clip:
    if len(lines) < 5 or not lines[0].startswith("PathFileType"):
        raise bad(path, "the first line of a TRC file begins with PathFileType")
    names = [name for name in lines[3].rstrip().split("\t")[2:] if name]
    table = _table(path, skip=5)
    if not names or table.shape[1] < 2 + 3 * len(names):
        raise bad(path, f"{len(names)} markers, but only {table.shape[1]} columns")
    points = table[:, 2 : 2 + 3 * len(names)].reshape(len(table), len(names), 3)
    rate = dict(zip(lines[1].split("\t"), lines[2].split("\t"), strict=False)).get("DataRate")
    times = None if rate or fps else table[:, 1]
    return Clip.from_points(points, fps or float(rate or 0) or None, names=names, times=times)


def _mot(path: Path, lines: list[str], fps: float | None) -> Clip:
    ends = [i for i, line in enumerate(lines) if line.strip().lower() == "endheader"]
    if not ends or ends[0] + 1 >= len(lines):
        raise bad(path, "a MOT or STO file has a line endheader, and names after it")
    table, names = _table(path, skip=ends[0] + 2), lines[ends[0] + 1].split("\t")
    if names[0].strip().lower() != "time" or table.shape[1] < len(names):
        raise bad(path, "the first column is not time, or columns are missing")
    step = float(np.median(np.diff(table[:, 0]))) if len(table) > 1 else 0.0
    if not step > 0:
        raise bad(path, "the column of time does not increase")
    return Clip.from_array(table[:, 1 : len(names)], fps or 1.0 / step)
