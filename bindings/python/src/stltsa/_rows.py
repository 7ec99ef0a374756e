# SPDX-License-Identifier: BSD-3-Clause
"""Rows of the tables of a decomposition."""

from __future__ import annotations

from typing import Any, NamedTuple, TypeVar

Row = TypeVar("Row", "Interval", "Segment", "Part", "Summary")


class Interval(NamedTuple):
    """A unit or a cycle: ``[begin, end)`` in source frames, and in seconds.

    Seconds keep fractions of a frame; they are NaN if the frame rate is unknown. `kind` is
    ``"cycle"`` or the library's name of a unit, such as ``"preparing"``, ``"cyclic"`` or
    ``"action"``.
    """

    kind: str
    begin: int
    end: int
    begin_s: float
    end_s: float

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.end_s - self.begin_s


class Segment(NamedTuple):
    """A stretch of one behavior: ``[begin, end)`` in source frames, and in seconds.

    `kind` is ``"cyclic"``, ``"repetitions"``, ``"action"`` or ``"rest"``. Segments of the same
    motion share a `label`, "A", "B", ... in order of appearance; that of a rest is empty. `number`
    is that of cycles or repetitions. `carried_by` names the joints, markers or columns that move
    most. The first step of a cycle takes `first_step_share` of it; its 95 % interval reaches
    `first_step_margin` to each side. `steps_reason` says why there are no steps. If the
    `reason` of a rest is "nothing recorded", most of the body is missing. Numbers that do not apply
    are NaN.
    """

    kind: str
    label: str
    begin: int
    end: int
    begin_s: float
    end_s: float
    number: int
    period_s: float
    candidate_period_s: float
    likeness: float
    confidence: float
    begin_confidence: float
    open_begin: bool
    open_end: bool
    carried_by: tuple[str, ...]
    reason: str
    first_step_share: float
    first_step_margin: float
    steps_reason: str

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.end_s - self.begin_s


class Part(NamedTuple):
    """A cycle, a step or a repetition: ``[begin, end)`` in source frames, and in seconds.

    `segment` is an index into the segments; `cycle`, of a step, one into the cycles, else -1.
    `side` tells which side of the body leads, 0 or 1, and -1 if it is unknown; `side_name` is
    "left" or "right" if names state it, else empty. `way` is the length
    of the body's path over the ground, `stride` the distance between its ends, `speed` `way` a
    second, all in the unit of the file, and `turn` in degrees, counterclockwise as seen from above.
    NaN: unknown.
    """

    segment: int
    cycle: int
    begin: int
    end: int
    begin_s: float
    end_s: float
    side: int
    side_name: str
    likeness: float
    confidence: float
    way: float
    stride: float
    speed: float
    turn: float

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.end_s - self.begin_s


class Summary(NamedTuple):
    """The cycles or repetitions of one label: their number, how often, how long (seconds).

    `cv` is ``sd_s / mean_s``; `trend` the relative change of the length per minute.
    """

    label: str
    number: int
    per_minute: float
    mean_s: float
    sd_s: float
    cv: float
    trend: float


class Statistics(NamedTuple):
    """Mean, standard deviation and trend of one quantity of the parts of one label.

    `kind` is ``"cycle"``, ``"step"`` or ``"repetition"``; `side` 0 or 1, or -1 for both; `quantity`
    ``"time"`` (seconds), ``"way"``, ``"stride"``, ``"speed"`` or ``"turn"`` (see :class:`Part`).
    `cv` is ``sd / mean``, `trend` the relative change per minute; both are NaN of turns.
    """

    label: str
    kind: str
    side: int
    quantity: str
    number: int
    mean: float
    sd: float
    cv: float
    trend: float


def letters(label: int) -> str:
    """Return A, B, ... Z, AA, AB, ...; an empty text for -1."""
    text = ""
    while label >= 0:
        text = chr(ord("A") + label % 26) + text
        label = label // 26 - 1
    return text


_MOST_LABELS = 2**31 - 1  # numbers of labels are int32_t


def number_of(label: str) -> int:
    """Return the number of a label: 0 for A, 26 for AA."""
    if not (isinstance(label, str) and label.isascii() and label.isalpha() and label.isupper()):
        raise ValueError(f"label is {label!r}, and must be letters such as 'A'")
    number = 0
    for letter in label:
        number = 26 * number + ord(letter) - ord("A") + 1
    if number > _MOST_LABELS:
        raise ValueError(f"label is {label!r}, and no motion has so many labels")
    return number - 1


def without_seconds(row: Row) -> Row:
    """Return the row of a motion whose rate is unknown: what depends on the rate is NaN."""
    times = [n for n in row._fields if n.endswith("_s") or n in ("per_minute", "trend", "speed")]
    unknown: dict[str, Any] = dict.fromkeys(times, float("nan"))
    return row._replace(**unknown)
