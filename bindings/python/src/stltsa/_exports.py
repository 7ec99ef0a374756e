# SPDX-License-Identifier: BSD-3-Clause
"""Decompositions and clips for other programs: pandas, xarray, BIDS, BORIS, C3D."""

from __future__ import annotations

import errno
import json
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import readers
from ._native import lib
from ._tables import frame
from ._text import csv_text
from .errors import UnsupportedError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from pandas import DataFrame

    from ._rows import Event
    from .clip import Clip
    from .decomposition import Decomposition
    from .phase import FoundEvents


class Row(NamedTuple):
    """A segment, unit, cycle or repetition, as in the command's table for spreadsheets."""

    level: str
    kind: str
    label: str
    begin: int
    end: int
    begin_s: float
    end_s: float
    duration_s: float
    likeness: float
    confidence: float
    path_length: float
    stride: float
    speed: float
    turn_deg: float


def _row(level: str, kind: str, label: str, part: Any) -> Row:
    numbers = (getattr(part, name, float("nan")) for name in Row._fields[8:])
    times = part.begin, part.end, part.begin_s, part.end_s, part.duration_s
    return Row(level, kind, label, *times, *numbers)


def rows_of(result: Decomposition) -> list[Row]:
    """Return all rows: segments, then units, cycles and repetitions."""
    segments = result.segment_list
    rows = [_row("segment", s.kind, s.label, s) for s in segments]
    rows += [_row("unit", u.kind, segments[u.segment].label, u) for u in result.unit_list]
    for level in ("cycle", "repetition"):
        rows += [_row(level, level, part.label, part) for part in result._list(level)]
    return rows


def to_frame(result: Decomposition) -> DataFrame:
    """Return the rows as a DataFrame."""
    return frame(rows_of(result), Row)


def _per_frame(frames: int, empty: Any, parts: Iterable[tuple[Any, Any]]) -> np.ndarray[Any, Any]:
    """Return the value of the part in which each frame lies, or else `empty`."""
    values = [empty] * frames
    for part, value in parts:
        values[part.begin : part.end] = [value] * (part.end - part.begin)
    return np.array(values)


def to_xarray(result: Decomposition, dataset: Any) -> Any:
    """Return a dataset with the answer as coordinates on time."""
    xarray = readers.extra("xarray", "movement")
    clip = result.clip
    if dataset is None:
        dataset = _dataset(xarray, result)
    elif dataset.sizes.get("time") != len(clip):
        have = dataset.sizes.get("time", "no")
        raise ValueError(f"the dataset has {have} times, and the clip {len(clip)} frames")
    segments = result.segment_list
    coordinates = {
        "segment": _per_frame(len(clip), -1, ((s, i) for i, s in enumerate(segments))),
        "label": _per_frame(len(clip), "", ((s, s.label) for s in segments)),
        "unit": _per_frame(len(clip), "", ((u, u.kind) for u in result.unit_list)),
        "cycle": _per_frame(len(clip), -1, ((c, i) for i, c in enumerate(result.cycle_list))),
    }
    answer = dataset.assign_coords({name: ("time", v) for name, v in coordinates.items()})
    facts = {n: getattr(result, n) for n in ("period", "cyclicity", "reason")}
    return answer.assign_attrs({f"stltsa_{name}": value for name, value in facts.items()})


def _dataset(xarray: Any, result: Decomposition) -> Any:
    clip, frames = result.clip, result.frames
    curve = np.full(len(clip), np.nan)
    coords = np.full((len(clip), 2), np.nan)
    curve[frames], coords[frames] = result.curve, result.coords
    time = np.arange(len(clip)) / (clip.fps or 1.0)
    return xarray.Dataset(
        {"curve": ("time", curve), "coords": (("time", "coordinate"), coords)},
        coords={"time": time, "frame": ("time", np.arange(len(clip)))},
        attrs={"fps": clip.fps, "time_unit": "seconds" if clip.fps else "frames"},
    )


_COLUMNS = {
    "onset": {"Description": "Begin, counted from the first frame", "Units": "s"},
    "duration": {"Description": "Length", "Units": "s"},
    "trial_type": {
        "Description": "What it is: the kind of a segment or unit, a cycle, or a repetition"
    },
    "level": {
        "Description": "What the row describes",
        "Levels": {
            "segment": "Stretch of one behavior",
            "unit": "Motion unit (Li et al. 2012)",
            "cycle": "One period of a cyclic segment",
            "repetition": "One of several actions of the same kind with pauses between them",
            "event": "A moment found from a marked example",
        },
    },
    "label": {"Description": "Letter shared by the segments of the same motion"},
    "likeness": {"Description": "Similarity to the others of the label, from 0 to 1"},
    "confidence": {"Description": "How sure the answer is, from 0 to 1"},
    "side": {"Description": "Side of the body that the name of an event states: left or right"},
}


# Within a cell, a tab would begin the next cell, and a new line the next row.
_SPACES = str.maketrans("\t\r\n", "   ")


def _cell(value: Any) -> str:
    unknown = value == "" or (isinstance(value, float) and np.isnan(value))
    return "n/a" if unknown else str(value).translate(_SPACES)


class Moment(NamedTuple):
    """A found event, its name and its side."""

    name: str
    event: Event
    side: str


def _moments(events: Mapping[str, FoundEvents] | None) -> list[Moment]:
    named = (events or {}).items()
    moments = [Moment(name, event, found.side) for name, found in named for event in found]
    return sorted(moments, key=lambda moment: moment.event.seconds)


def _bids(rows: list[Row], moments: list[Moment]) -> str:
    nan = float("nan")
    cells = [
        (r.begin_s, r.duration_s, r.kind, r.level, r.label, r.likeness, r.confidence, "")
        for r in rows
    ]
    cells += [
        (e.seconds, 0.0, name, "event", "", nan, e.confidence, side) for name, e, side in moments
    ]
    lines = ["\t".join(_COLUMNS)]
    lines += ["\t".join(map(_cell, line)) for line in sorted(cells, key=lambda line: line[0])]
    return "\n".join(lines) + "\n"


def _boris(rows: list[Row], moments: list[Moment], result: Decomposition) -> str:
    """Return the tabular events of BORIS: a line at the begin and one at the end of each row."""
    name = Path(result.clip.path or "clip").name
    head = ("Observation id", "Media file name", "FPS (frame/s)", "Subject", "Behavior",
            "Behavioral category", "Behavior type", "Time", "Image index", "Comment")  # fmt: skip
    events = []
    for r in rows:
        for what, time, index in (("START", r.begin_s, r.begin), ("STOP", r.end_s, r.end)):
            line = (Path(name).stem, name, result.clip.fps, "No focal subject", r.kind, r.level,
                    what, time, index, r.label)  # fmt: skip
            events.append((time, what == "START", line))
    for kind, e, side in moments:
        line = (Path(name).stem, name, result.clip.fps, "No focal subject", kind, "event",
                "POINT", e.seconds, round(e.frame), side)  # fmt: skip
        events.append((e.seconds, True, line))
    return csv_text(head, (line for *_, line in sorted(events, key=lambda e: e[:2])))


def _c3d_events(rows: list[Row]) -> list[tuple[float, str]]:
    """Return a moment for the begin of each segment, cycle and repetition, and for the last end."""
    events: dict[tuple[str, float], str] = {}
    for r in (r for r in rows if r.level != "unit"):
        name = f"segment {r.label or r.kind}" if r.level == "segment" else r.level
        events[r.level, r.begin_s] = name
        events.setdefault((r.level, r.end_s), f"{name} end")
    return sorted((time, name) for (_, time), name in events.items())


_EVENT_COLUMNS = (("CONTEXTS", ""), ("DESCRIPTIONS", ""), ("SUBJECTS", ""), ("ICON_IDS", 0),
    ("GENERIC_FLAGS", 0))  # fmt: skip


def _complete_events(file: Any) -> None:
    """Give a file's events the columns that it may lack, without which ezc3d adds none."""
    group = file["parameters"].get("EVENT")
    if not group:
        return
    if not {"USED", "LABELS", "TIMES"} <= set(group):
        del file["parameters"]["EVENT"]  # it holds no events
        return
    count = len(group["LABELS"]["value"])
    for name, empty in _EVENT_COLUMNS:
        values = list(group[name]["value"]) if name in group else []
        values += [empty] * (count - len(values))
        numbers = empty == 0
        value = np.array(values, dtype=np.int64) if numbers else values
        group[name] = {"type": 2 if numbers else -1, "description": "", "is_locked": False,
                       "value": value}  # fmt: skip


def _context(moment: Moment) -> tuple[str, str]:
    """Return the context and label of a C3D event, such as Left and Foot Strike."""
    context = moment.side.capitalize() or "General"
    words = moment.name.split()
    if len(words) > 1 and words[0].capitalize() == context:
        words = words[1:]
    return context, " ".join(words)


def _write_c3d(path: Path, rows: list[Row], moments: list[Moment], source: Path) -> None:
    from .clip import read_clip  # it needs this module

    file = readers.extra("ezc3d", "c3d").c3d(str(source))
    _complete_events(file)
    header = file["header"]["points"]
    first = header["first_frame"] / header["frame_rate"]
    for seconds, name in _c3d_events(rows):
        minutes, rest = divmod(seconds + first, 60.0)
        file.add_event(time=[minutes, rest], context="General", label=name)
    there = read_clip(source).events
    for moment in moments:
        context, label = _context(moment)
        near = 0.5 / header["frame_rate"]
        if any((e.label, e.context) == (label, context) and
               abs(e.seconds - moment.event.seconds) < near for e in there):  # fmt: skip
            continue  # the mark itself
        minutes, rest = divmod(moment.event.seconds + first, 60.0)
        file.add_event(time=[minutes, rest], context=context, label=label)
    _replace(path, lambda to: file.write(str(to)))


def _positions(clip: Clip) -> Any:
    """Return frames x points x 3, with NaN for missing points, which features would fill."""
    with tempfile.TemporaryDirectory(prefix="stltsa-") as folder:
        clip.save(Path(folder) / "clip.npy")
        return np.load(Path(folder) / "clip.npy")


def save_c3d(clip: Clip, path: Path) -> None:
    """Write the points of a clip and its events."""
    stated = clip.facts
    values: Any = _positions(clip) if stated["features"] == "points" else np.empty(0)
    in_space = values.ndim == 3 and values.shape[2] == 3
    if not in_space or not clip.fps:
        text = f"{path}: a C3D file holds points in space and their frame rate, and this clip "
        lack = "has no frame rate" if in_space else "has none"
        raise UnsupportedError(text + lack, lib.STLTSA_E_UNSUPPORTED, "STLTSA_E_UNSUPPORTED")
    file = readers.extra("ezc3d", "c3d").c3d()
    point = file["parameters"]["POINT"]
    point["RATE"]["value"] = [clip.fps]
    names = stated["channel"][::3] or [f"p{i + 1}_x" for i in range(values.shape[1])]
    point["LABELS"]["value"] = [name[:-1].rstrip("_. :-") for name in names]
    if stated["length_unit"]:
        point["UNITS"]["value"] = [stated["length_unit"]]
    if stated["file_up_axis"] != "none":
        file.add_parameter("POINT", "Y_SCREEN", [f"+{stated['file_up_axis'].upper()}"])
    missing = np.isnan(values).any(axis=2).T
    points = np.ones((4, *missing.shape))
    points[:3] = np.nan_to_num(values).transpose(2, 1, 0)
    masks = np.zeros((7, *missing.shape), dtype=bool)
    file["data"]["points"] = points
    file["data"]["meta_points"] = {"residuals": np.where(missing, -1.0, 0.0)[np.newaxis],
                                   "camera_masks": masks}  # fmt: skip
    for event in clip.events:
        minutes, rest = divmod(event.seconds, 60.0)
        file.add_event(time=[minutes, rest], context=event.context, label=event.label)
    _replace(path, lambda to: file.write(str(to)))


def _replace(path: Path, write: Callable[[Path], Any]) -> None:
    """Write a file completely or not at all; links are followed, as by the library."""
    path = Path(os.path.realpath(path))
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, "there is no such folder", str(path.parent))
    with tempfile.TemporaryDirectory(dir=path.parent) as folder:
        made = Path(folder) / path.name
        write(made)
        made.replace(path)


def write_text(path: Path, text: str) -> None:
    """Write a text completely or not at all."""
    _replace(path, lambda to: to.write_text(text, encoding="utf-8"))


def save_events(
    result: Decomposition, to: Any, source: Any, events: Mapping[str, FoundEvents] | None
) -> None:
    """Write the rows and the found events in the format that the suffix names."""
    path = Path(to)
    suffix = path.suffix.lower()
    if suffix not in (".tsv", ".csv", ".c3d"):
        raise ValueError(f"{path}: the suffix must be .tsv (BIDS), .csv (BORIS) or .c3d")
    if not result.clip.fps:
        raise ValueError("events are in seconds, and the frame rate is unknown: give fps=")
    rows, moments = rows_of(result), _moments(events)
    if suffix == ".c3d":
        read = Path(source or result.clip.path or "")
        if read.suffix.lower() != ".c3d":
            raise ValueError("events are added to a C3D file: give source=")
        _write_c3d(path, rows, moments, read)
    elif suffix == ".csv":
        write_text(path, _boris(rows, moments, result))
    else:
        write_text(path, _bids(rows, moments))
        write_text(path.with_suffix(".json"), json.dumps(_COLUMNS, indent=2) + "\n")
