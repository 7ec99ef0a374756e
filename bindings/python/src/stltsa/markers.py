# SPDX-License-Identifier: BSD-3-Clause
"""Files of markers and joint coordinates: C3D, and OpenSim's TRC, MOT and STO.

The library does not read these formats: ezc3d reads C3D (``pip install stltsa[c3d]``), pandas the
others (``pip install stltsa[trc]``). Gaps are never ignored: see :meth:`Markers.to_clip`.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._native import lib
from .clip import Clip
from .errors import FormatError, NotFiniteError, QualityWarning

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator

    import numpy.typing as npt

    from ._arrays import FloatArray

_AXES = 3


class Gap(NamedTuple):
    """Frames ``[begin, end)`` in which a marker is missing."""

    name: str
    begin: int
    end: int


@dataclass(frozen=True)
class Markers:
    """Markers or joint coordinates over time, gaps as NaN.

    Attributes
    ----------
    names : tuple of str
        Names of the markers or joint coordinates.
    values : ndarray of shape (frames, names, 3) or (frames, names, 1)
        Positions in the file's unit of length, or joint coordinates in the file's unit of angle.
    fps : float
        Frames per second.
    path : str
        The file that they were read from.
    """

    names: tuple[str, ...]
    values: FloatArray
    fps: float
    path: str

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """The gaps, marker by marker."""
        missing = zip(self.names, ~self._there.T, strict=True)
        return tuple(gap for name, gone in missing for gap in _runs(name, gone))

    @property
    def _there(self) -> npt.NDArray[np.bool_]:
        return np.asarray(np.isfinite(self.values).all(axis=2))

    def to_clip(self, *, gaps: str = "refuse", fps: Any = None, center: bool = True) -> Clip:
        """Return a clip of these numbers.

        Parameters
        ----------
        gaps : {"refuse", "fill"}
            ``"refuse"``: a gap is an error, whose text gives its position. ``"fill"``: fills gaps
            linearly, and with the nearest value at the ends; leaves out markers that are always
            missing; warns what it did.
        fps : float, optional
            Frames per second; overrides the file.
        center : bool, default=True
            Subtract the mean of all markers from each frame, so that the path of the body does not
            hide its movement. Joint coordinates are not changed.

        Raises
        ------
        stltsa.NotFiniteError
            There is a gap, and `gaps` is ``"refuse"``.

        Warns
        -----
        QualityWarning
            Gaps were filled.
        """
        if gaps not in ("refuse", "fill"):
            raise ValueError(f'gaps is {gaps!r}, and must be "refuse" or "fill"')
        found = self.gaps
        if found and gaps == "refuse":
            raise NotFiniteError(
                f"{self.path}: {_described(found)}; gaps='fill' fills gaps linearly",
                lib.STLTSA_E_NOT_FINITE,
                "STLTSA_E_NOT_FINITE",
            )
        values = self._filled(found) if found else self.values
        if center and values.shape[2] == _AXES:
            values = values - values.mean(axis=1, keepdims=True)
        return Clip.from_array(values.reshape(len(values), -1), self.fps if fps is None else fps)

    def _filled(self, gaps: tuple[Gap, ...]) -> FloatArray:
        there = self._there
        kept = np.asarray(there.any(axis=0))
        dropped = [name for name, keep in zip(self.names, kept.tolist(), strict=True) if not keep]
        filled = [g for g in gaps if g.name not in dropped]
        said = [f"filled linearly: {_described(filled)}"] if filled else []
        said += [f"left out, never there: {', '.join(dropped)}"] if dropped else []
        warnings.warn(f"{self.path}: {'; '.join(said)}", QualityWarning, stacklevel=3)
        result = self.values[:, kept].copy()
        time = np.arange(len(result))
        for marker, seen in enumerate(there[:, kept].T):
            for axis in range(result.shape[2]):
                column = result[:, marker, axis]
                column[~seen] = np.interp(time[~seen], time[seen], column[seen])
        return result


def _runs(name: str, missing: Any) -> Iterator[Gap]:
    edges = np.flatnonzero(np.diff(np.concatenate(([0], missing.astype(np.int8), [0]))))
    for begin, end in edges.reshape(-1, 2):
        yield Gap(name, int(begin), int(end))


def _described(gaps: list[Gap] | tuple[Gap, ...]) -> str:
    longest = max(gaps, key=lambda gap: gap.end - gap.begin)
    markers = len({gap.name for gap in gaps})
    return (
        f"{len(gaps)} gap{'s' * (len(gaps) > 1)} in {markers} marker{'s' * (markers > 1)}, "
        f"the longest {longest.end - longest.begin} frames "
        f"({longest.name}, frames [{longest.begin}, {longest.end}))"
    )


def _bad(path: Path, text: str) -> FormatError:
    return FormatError(f"{path}: {text}", lib.STLTSA_E_FORMAT, "STLTSA_E_FORMAT")


def _extra(name: str, extra: str) -> Any:
    import importlib

    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"this needs {name}: pip install 'stltsa[{extra}]'") from error


def _read_c3d(path: Path) -> Markers:
    file = _extra("ezc3d", "c3d").c3d(str(path))  # sets invalid points to NaN
    point = file["parameters"]["POINT"]
    points = np.asarray(file["data"]["points"], dtype=np.float64)[:_AXES]
    names = tuple(str(name) for name in point["LABELS"]["value"][: points.shape[1]])
    return Markers(names, points.transpose(2, 1, 0), float(point["RATE"]["value"][0]), str(path))


def _table(path: Path, skip: int) -> FloatArray:
    pandas = _extra("pandas", "trc")
    try:
        frame = pandas.read_csv(path, sep="\t", skiprows=skip, header=None, dtype=np.float64)
    except (ValueError, pandas.errors.ParserError) as error:
        raise _bad(path, f"the numbers cannot be read: {error}") from error
    return np.asarray(frame)


def _rate(path: Path, time: FloatArray) -> float:
    step = float(np.median(np.diff(time))) if len(time) > 1 else 0.0
    if not step > 0:
        raise _bad(path, "the column of time does not rise")
    return 1.0 / step


def _read_trc(path: Path) -> Markers:
    head = path.read_text(encoding="utf-8", errors="replace").splitlines()[:5]
    if len(head) < 5 or not head[0].startswith("PathFileType"):
        raise _bad(path, "the first line of a TRC file begins with PathFileType")
    names = tuple(name for name in head[3].rstrip().split("\t")[2:] if name)
    facts = dict(zip(head[1].split("\t"), head[2].split("\t"), strict=False))
    table = _table(path, skip=5)
    if table.shape[1] < 2 + _AXES * len(names):
        raise _bad(path, f"{len(names)} markers, but only {table.shape[1]} columns")
    values = table[:, 2 : 2 + _AXES * len(names)].reshape(len(table), len(names), _AXES)
    fps = float(facts.get("DataRate") or 0) or _rate(path, table[:, 1])
    return Markers(names, values, fps, str(path))


def _read_mot(path: Path) -> Markers:
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    ends = [i for i, line in enumerate(lines) if line.strip().lower() == "endheader"]
    if not ends:
        raise _bad(path, "a MOT or STO file has a line endheader")
    columns = lines[ends[0] + 1].split("\t")
    table = _table(path, skip=ends[0] + 2)
    if columns[0].strip().lower() != "time" or table.shape[1] < len(columns):
        raise _bad(path, "the first column is not time, or columns are missing")
    names = tuple(name.strip() for name in columns[1:])
    values = table[:, 1 : len(columns), np.newaxis]
    return Markers(names, values, _rate(path, table[:, 0]), str(path))


def read_markers(path: str | os.PathLike[str]) -> Markers:
    """Read markers (C3D, TRC) or joint coordinates (MOT, STO), gaps as NaN.

    Parameters
    ----------
    path : path
        The suffix determines the format.

    Raises
    ------
    ImportError
        The extra for this format is not installed.
    stltsa.FormatError
        The content of the file does not match its suffix.
    """
    readers = {".c3d": _read_c3d, ".trc": _read_trc, ".mot": _read_mot, ".sto": _read_mot}
    reader = readers.get(Path(path).suffix.lower())
    if reader is None:
        raise ValueError(f"{path}: the suffix is none of {', '.join(readers)}")
    return reader(Path(path))
