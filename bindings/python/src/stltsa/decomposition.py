# SPDX-License-Identifier: BSD-3-Clause
"""Motion units and cycles (the paper, section 3.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _html
from ._arrays import FloatArray, IntArray, columns, write_to
from ._call import Call, check, owned, texts
from ._facts import Described
from ._native import ffi, lib
from ._tables import table
from ._text import string
from .clip import Clip, as_clip

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._options import Options


class Interval(NamedTuple):
    """A unit or a cycle: ``[begin, end)`` in source frames, and in seconds.

    Seconds keep fractions of a frame. `kind` is ``"cycle"`` or the library's name of a unit, such
    as ``"preparing"``, ``"cyclic"`` or ``"action"``.
    """

    kind: str
    begin: int
    end: int
    begin_s: float
    end_s: float


class Segment(NamedTuple):
    """A stretch of one behavior: ``[begin, end)`` in source frames, and in seconds.

    `kind` is ``"cyclic"``, ``"repetitions"``, ``"action"`` or ``"rest"``. Segments of the same
    motion share a `label`, "A", "B", ... in order of appearance; that of a rest is empty. `number`
    is that of cycles or repetitions. `carried_by` names the joints, markers or columns that move
    most. Numbers that do not apply are NaN.
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


class Part(NamedTuple):
    """A cycle, a step or a repetition: ``[begin, end)`` in source frames, and in seconds.

    `segment` is an index into the segments; `cycle`, of a step, one into the cycles, else -1.
    `side` tells which side of the body leads, 0 or 1, and -1 if it is unknown.
    """

    segment: int
    cycle: int
    begin: int
    end: int
    begin_s: float
    end_s: float
    side: int
    likeness: float
    confidence: float


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


def _letters(label: int) -> str:
    """Return A, B, ... Z, AA, AB, ...; an empty text for -1."""
    text = ""
    while label >= 0:
        text = chr(ord("A") + label % 26) + text
        label = label // 26 - 1
    return text


def decompose(motion: Any, **options: Unpack[Options]) -> Decomposition:
    """Divide a recording into segments, units and cycles.

    The library finds what is done when and follows the period over time, so nothing needs tuning.
    A recording in which nothing repeats is not an error: :attr:`Decomposition.reason` explains why.

    Parameters
    ----------
    motion : Clip, path, or array-like of shape (frames, channels)
        An array needs the option `fps`, and so does a path if the file has no rate; a Clip has its
        own.
    **options
        Used: `features`, `up_axis`, `keep_start`, `sample_rate`, `smoothing`, `period_min`,
        `period_max`, `neighbors`, `window`, `dimension`, `mode`, `threads`, `fps`, `progress`.
        See :func:`stltsa.options`.

    Returns
    -------
    Decomposition

    Raises
    ------
    stltsa.ArgumentError
        The Clip's frame rate is unknown, or an option is invalid.
    stltsa.TooFewFramesError
        The clip is too short. (A clip without movement is not an error: it is standing.)

    Examples
    --------
    >>> import stltsa
    >>> result = stltsa.decompose("walker.bvh")
    >>> list(result.units["kind"])
    ['preparing', 'initial', 'cyclic', 'final', 'wind-up']
    >>> round(result.period, 2)
    1.1
    """
    rest: dict[str, Any] = dict(options)
    clip = as_clip(motion, rest)
    out = ffi.new("stltsa_decomposition **")
    with Call(rest) as call:
        call.check(lib.stltsa_decompose(clip._handle, call.options, out))
    return Decomposition(owned("decomposition", out), clip)


class Decomposition(Described):
    """Units and cycles of a clip, and the curve from which they were cut.

    Attributes
    ----------
    clip : Clip
        The decomposed clip.
    """

    _kind = "decomposition"

    def __init__(self, handle: Any, clip: Clip) -> None:
        self._handle = handle
        self.clip = clip

    def _intervals(self, count: Any, get: Any) -> tuple[Interval, ...]:
        result, raw = [], ffi.new("stltsa_interval *")
        for index in range(count(self._handle)):
            check(get(self._handle, index, raw))
            kind = string(lib.stltsa_unit_name(raw.kind))
            result.append(Interval(kind, raw.begin, raw.end, raw.begin_s, raw.end_s))
        return tuple(result)

    @property
    def unit_list(self) -> tuple[Interval, ...]:
        """The units in temporal order; they cover the clip without gap or overlap."""
        return self._intervals(lib.stltsa_decomposition_unit_count, lib.stltsa_decomposition_unit)

    @property
    def cycle_list(self) -> tuple[Interval, ...]:
        """The cycles in temporal order, back to back within a segment."""
        return self._intervals(lib.stltsa_decomposition_cycle_count, lib.stltsa_decomposition_cycle)

    @property
    def segment_list(self) -> tuple[Segment, ...]:
        """The segments in temporal order; they cover the clip without gap or overlap."""
        result, raw = [], ffi.new("stltsa_segment *")
        for index in range(lib.stltsa_decomposition_segment_count(self._handle)):
            check(lib.stltsa_decomposition_segment(self._handle, index, raw))
            result.append(
                Segment(
                    kind=string(lib.stltsa_segment_name(raw.kind)),
                    label=_letters(raw.label),
                    begin=raw.begin,
                    end=raw.end,
                    begin_s=raw.begin_s,
                    end_s=raw.end_s,
                    number=raw.count,
                    period_s=raw.period_s or np.nan,
                    candidate_period_s=raw.candidate_period_s or np.nan,
                    likeness=raw.likeness,
                    confidence=raw.confidence,
                    begin_confidence=raw.begin_confidence,
                    open_begin=bool(raw.open_begin),
                    open_end=bool(raw.open_end),
                    carried_by=self._carriers(index),
                    reason=string(lib.stltsa_decomposition_segment_reason(self._handle, index)),
                )
            )
        return tuple(result)

    def _carriers(self, segment: int) -> tuple[str, ...]:
        count = lib.stltsa_decomposition_carrier_count(self._handle, segment)
        return tuple(
            string(lib.stltsa_decomposition_carrier(self._handle, segment, index))
            for index in range(count)
        )

    def _parts(self, kind: int) -> tuple[Part, ...]:
        result, raw = [], ffi.new("stltsa_part *")
        for index in range(lib.stltsa_decomposition_part_count(self._handle, kind)):
            check(lib.stltsa_decomposition_part(self._handle, kind, index, raw))
            result.append(
                Part(
                    segment=raw.segment,
                    cycle=raw.parent,
                    begin=raw.begin,
                    end=raw.end,
                    begin_s=raw.begin_s,
                    end_s=raw.end_s,
                    side=raw.side,
                    likeness=raw.likeness,
                    confidence=raw.confidence,
                )
            )
        return tuple(result)

    @property
    def segments(self) -> Any:
        """The segments as a table: a DataFrame with pandas, otherwise a NumPy record array."""
        return table(self.segment_list, Segment)

    @property
    def steps(self) -> Any:
        """Halves of cycles in which both sides of the body alternate, as a table."""
        return table(self._parts(lib.STLTSA_PART_STEP), Part)

    @property
    def repetitions(self) -> Any:
        """The actions of the segments that repeat with pauses, as a table."""
        return table(self._parts(lib.STLTSA_PART_REPETITION), Part)

    @property
    def cycle_facts(self) -> Any:
        """Segment, side, likeness and confidence of each cycle, as a table."""
        return table(self._parts(lib.STLTSA_PART_CYCLE), Part)

    @property
    def summary(self) -> Any:
        """How often and how fast, for each label that repeats, as a table."""
        result, raw = [], ffi.new("stltsa_summary *")
        for index in range(lib.stltsa_decomposition_summary_count(self._handle)):
            check(lib.stltsa_decomposition_summary(self._handle, index, raw))
            result.append(
                Summary(
                    _letters(raw.label),
                    raw.count,
                    raw.per_minute,
                    raw.mean_s,
                    raw.sd_s,
                    raw.cv,
                    raw.trend,
                )
            )
        return table(tuple(result), Summary)

    @property
    def units(self) -> Any:
        """The units as a table: a DataFrame with pandas, otherwise a NumPy record array.

        Columns: kind; begin, end in source frames, half-open; begin_s, end_s in seconds.
        """
        return table(self.unit_list, Interval)

    @property
    def cycles(self) -> Any:
        """The cycles as a table with the same columns as :attr:`units`."""
        return table(self.cycle_list, Interval)

    def _cycle(self, name: str) -> Interval | None:
        index = self._int(name)
        return self.cycle_list[index] if index >= 0 else None

    @property
    def representative_cycle(self) -> Interval | None:
        """The cycle chosen by the paper's rule: from the first margin to the third."""
        return self._cycle("representative")

    @property
    def best_cycle(self) -> Interval | None:
        """The cycle that is most similar to the others."""
        return self._cycle("best")

    @property
    def frames(self) -> IntArray:
        """Source frame of each sample of the curve; shape (samples,)."""
        first = self._int("first_frame")
        step = self._int("frame_step")
        return first + step * np.arange(self._int("rows"))

    def _columns(self, function: Any, count: int) -> FloatArray:
        result = columns(self._int("rows"), count)
        check(function(self._handle, write_to(result)))
        return result

    @property
    def curve(self) -> FloatArray:
        """The smoothed coordinate from which units and cycles were cut; shape (samples,)."""
        return self._columns(lib.stltsa_decomposition_curve, 1)[:, 0]

    @property
    def coords(self) -> FloatArray:
        """All coordinates of the fit that was cut, not smoothed; shape (samples, dimension)."""
        width = self._int("dimension")
        return self._columns(lib.stltsa_decomposition_coords, width)

    @property
    def loop(self) -> FloatArray:
        """The two coordinates of the loop, the paper's Fig. 1; shape (samples, 2)."""
        return self._columns(lib.stltsa_decomposition_loop, 2)

    @property
    def period(self) -> float:
        """Period in seconds; 0 if none was found."""
        return self._real("period")

    @property
    def cyclicity(self) -> float:
        """How well that coordinate repeats once per period; 1 is a perfect oscillation."""
        return self._real("cyclicity")

    @property
    def lag_quality(self) -> float:
        """Similarity of the clip to itself one period later; 1 is perfect."""
        return self._real("lag_quality")

    @property
    def fps(self) -> float:
        """Samples of the curve per second."""
        return self._real("fps")

    @property
    def neighbors(self) -> int:
        """Neighbors (k), in samples."""
        return self._int("neighbors")

    @property
    def window(self) -> int:
        """Window (w), in samples."""
        return self._int("window")

    @property
    def dimension(self) -> int:
        """Tangent dimension."""
        return self._int("dimension")

    @property
    def reason(self) -> str:
        """Why nothing repeats, with the numbers; empty if anything does."""
        return string(lib.stltsa_decomposition_reason(self._handle))

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the result."""
        return texts(
            lib.stltsa_decomposition_warning_count, lib.stltsa_decomposition_warning, self._handle
        )

    def __repr__(self) -> str:
        units = ", ".join(f"{u.kind} {u.begin}..{u.end}" for u in self.unit_list)
        period = f"; period {self.period:.3f} s" if self.period else ""
        return f"<Decomposition: {units}; {len(self.cycle_list)} cycles{period}>"

    def _repr_html_(self) -> str:
        return _html.decomposition(self)
