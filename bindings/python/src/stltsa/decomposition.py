# SPDX-License-Identifier: BSD-3-Clause
"""Motion units and cycles (the paper, section 3.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _exports, _html
from ._arrays import FloatArray, IntArray, columns, write_to
from ._call import Call, check, owned, texts
from ._facts import Described
from ._native import ffi, lib
from ._options import working_rate
from ._rows import (
    Interval,
    Part,
    Row,
    Segment,
    Statistics,
    Summary,
    letters,
    number_of,
    without_seconds,
)
from ._statistics import in_frames, statistics_of
from ._tables import table
from ._text import c_path, string
from .clip import Clip, as_clip, one_matrix, opened
from .comparison import Comparison
from .errors import in_keywords, warn_of_order
from .phase import Phase
from .readers import is_points

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping

    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._given import Matrix, Motion
    from ._options import Options
    from .phase import FoundEvents
    from .readers.movement import Dataset


# To the library an array without a rate has this one; the answer is in frames.
_FRAMES_A_SECOND = 30.0
_UNKNOWN_RATE = (
    f"the frame rate is unknown: texts, facts and JSON count {_FRAMES_A_SECOND:g} frames as a "
    "second; give fps="
)
_SHORTEST_PERIOD, _LONGEST_PERIOD = 4, 1000  # frames, if the rate is unknown


class _ClipInFrames(Clip):
    """A clip whose rate is unknown, although the library has one."""

    @property
    def fps(self) -> float:
        return 0.0


def _in_frames(frames: Matrix, options: dict[str, Any]) -> tuple[Clip, dict[str, Any]]:
    """Return a clip of an array without a rate, and the options with their lengths in frames."""
    of_points = is_points(frames)
    make = _ClipInFrames.from_points if of_points else _ClipInFrames.from_array
    clip = make(frames if of_points else one_matrix(frames), _FRAMES_A_SECOND)
    longest = min(len(clip) // 2, _LONGEST_PERIOD)
    lengths: dict[str, Any] = {
        "period_min": _SHORTEST_PERIOD,
        "period_max": max(longest, _SHORTEST_PERIOD),
    }
    lengths.update({n: v for n, v in options.items() if n in (*lengths, "smoothing")})
    for name, value in lengths.items():
        if not isinstance(value, int | float):
            raise ValueError(f"{name} is {value!r}, and the frame rate is unknown: give fps=")
    in_seconds = {name: value / _FRAMES_A_SECOND for name, value in lengths.items()}
    return clip, {**options, **in_seconds}


def decompose(motion: Motion, **options: Unpack[Options]) -> Decomposition:
    """Divide a recording into segments, units and cycles.

    The library finds what is done when and follows the period over time, so nothing needs tuning.
    A recording in which nothing repeats is not an error: :attr:`Decomposition.reason` explains why.

    Parameters
    ----------
    motion : Clip, path, dataset, or array-like of shape (frames, channels) or (frames, points, 2|3)
        An array needs the option `fps` for an answer in seconds. Without it the period is looked
        for in frames, up to 1000, and everything in seconds is NaN; `period_min`, `period_max` and
        `smoothing` are in frames then. A path needs `fps` if the file has no rate; a Clip has its
        own. A dataset is one of `movement`; `individual` names one of several in it or in a file.
    **options
        Used: `features`, `up_axis`, `gaps`, `least_confidence`, `keep_start`, `sample_rate`,
        `smoothing`, `period_min`, `period_max`, `segments`, `threads`, `fps`, `individual`,
        `progress`. See :func:`stltsa.options`.

    Returns
    -------
    Decomposition

    Raises
    ------
    stltsa.ArgumentError
        The Clip's frame rate is unknown, or an option is invalid.
    stltsa.TooFewFramesError
        The clip is too short. (A clip without movement is not an error: it is standing.)

    Warns
    -----
    QualityWarning
        The rows of an array show no order in time.

    Examples
    --------
    >>> import stltsa
    >>> result = stltsa.decompose("walker.bvh")
    >>> list(result.units["kind"])
    ['preparing', 'initial', 'cyclic', 'final', 'wind-up']
    >>> round(result.period, 2)
    1.1
    """
    rest = {name: value for name, value in options.items() if value is not None}
    given = opened(motion, options)
    rest.pop("individual", None)
    if isinstance(given, Clip) or rest.get("fps", "auto") != "auto":
        clip = as_clip(given, rest)
    else:
        clip, rest = _in_frames(given, rest)
    out = ffi.new("stltsa_decomposition **")
    with Call(rest, working_rate(clip.fps, rest)) as call:
        call.check(lib.stltsa_decompose(clip._handle, call.options, out))
    result = Decomposition(owned("decomposition", out), clip, rest)
    warn_of_order(result.warnings)
    return result


def report(
    motion: Motion, path: str | os.PathLike[str], **options: Unpack[Options]
) -> Decomposition:
    """Decompose a recording and write a report of it: one HTML page.

    Parameters
    ----------
    motion : Clip, path, dataset, or array-like
        As for :func:`decompose`.
    path : path
        The page; see :meth:`Decomposition.report`.
    **options
        As for :func:`decompose`.

    Returns
    -------
    Decomposition

    Raises
    ------
    ValueError
        The frame rate is unknown, as of an array without ``fps``.

    Examples
    --------
    >>> import stltsa
    >>> stltsa.report("walker.bvh", "walker.html").period > 1
    True
    """
    result = decompose(motion, **options)
    result.report(path)
    return result


class Decomposition(Described):
    """Units and cycles of a clip, and the curve from which they were cut.

    Attributes
    ----------
    clip : Clip
        The decomposed clip.
    """

    _kind = "decomposition"

    def __init__(self, handle: Any, clip: Clip, options: dict[str, Any]) -> None:
        self._handle = handle
        self.clip = clip
        self._options = options

    def _rows(self, rows: list[Row]) -> tuple[Row, ...]:
        """Return rows, without seconds if the rate is unknown."""
        return tuple(rows if self.clip.fps else map(without_seconds, rows))

    def _intervals(self, count: Any, get: Any) -> tuple[Interval, ...]:
        result, raw = [], ffi.new("stltsa_interval *")
        for index in range(count(self._handle)):
            check(get(self._handle, index, raw))
            kind = string(lib.stltsa_unit_name(raw.kind))
            result.append(Interval(kind, raw.begin, raw.end, raw.begin_s, raw.end_s))
        return self._rows(result)

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
        result, raw, step = [], ffi.new("stltsa_segment *"), ffi.new("double[2]")
        for index in range(lib.stltsa_decomposition_segment_count(self._handle)):
            check(lib.stltsa_decomposition_segment(self._handle, index, raw))
            check(lib.stltsa_decomposition_first_step(self._handle, index, step, step + 1))
            result.append(
                Segment(
                    kind=string(lib.stltsa_segment_name(raw.kind)),
                    label=letters(raw.label),
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
                    first_step_share=step[0],
                    first_step_margin=step[1],
                    steps_reason=string(lib.stltsa_decomposition_steps_reason(self._handle, index)),
                )
            )
        return self._rows(result)

    def _carriers(self, segment: int) -> tuple[str, ...]:
        count = lib.stltsa_decomposition_carrier_count(self._handle, segment)
        return tuple(
            string(lib.stltsa_decomposition_carrier(self._handle, segment, index))
            for index in range(count)
        )

    def _parts(self, kind: int) -> tuple[Part, ...]:
        result, raw, travel = [], ffi.new("stltsa_part *"), ffi.new("stltsa_travel *")
        sides = {lib.STLTSA_SIDE_LEFT: "left", lib.STLTSA_SIDE_RIGHT: "right"}
        for index in range(lib.stltsa_decomposition_part_count(self._handle, kind)):
            check(lib.stltsa_decomposition_part(self._handle, kind, index, raw))
            check(lib.stltsa_decomposition_travel(self._handle, kind, index, travel))
            result.append(
                Part(
                    segment=raw.segment,
                    cycle=raw.parent,
                    begin=raw.begin,
                    end=raw.end,
                    begin_s=raw.begin_s,
                    end_s=raw.end_s,
                    side=raw.side,
                    side_name=sides.get(lib.stltsa_decomposition_side(self._handle, raw.side), ""),
                    likeness=raw.likeness,
                    confidence=raw.confidence,
                    way=travel.way,
                    stride=travel.stride,
                    speed=travel.speed,
                    turn=travel.turn,
                )
            )
        return self._rows(result)

    @property
    def _cycles(self) -> tuple[Part, ...]:
        return self._parts(lib.STLTSA_PART_CYCLE)

    @property
    def _repetitions(self) -> tuple[Part, ...]:
        return self._parts(lib.STLTSA_PART_REPETITION)

    @property
    def segments(self) -> DataFrame:
        """The segments as a table: a DataFrame with pandas, otherwise a NumPy record array."""
        return table(self.segment_list, Segment)

    @property
    def steps(self) -> DataFrame:
        """Halves of cycles in which both sides of the body alternate, as a table."""
        return table(self._parts(lib.STLTSA_PART_STEP), Part)

    @property
    def repetitions(self) -> DataFrame:
        """The actions of the segments that repeat with pauses, as a table."""
        return table(self._repetitions, Part)

    @property
    def cycle_facts(self) -> DataFrame:
        """Segment, side, likeness, confidence and travel of each cycle, as a table."""
        return table(self._cycles, Part)

    @property
    def summary(self) -> DataFrame:
        """How often and how fast, for each label that repeats, as a table."""
        result, raw = [], ffi.new("stltsa_summary *")
        for index in range(lib.stltsa_decomposition_summary_count(self._handle)):
            check(lib.stltsa_decomposition_summary(self._handle, index, raw))
            result.append(
                Summary(
                    letters(raw.label),
                    raw.count,
                    raw.per_minute,
                    raw.mean_s,
                    raw.sd_s,
                    raw.cv,
                    raw.trend,
                )
            )
        return table(self._rows(result), Summary)

    @property
    def label_likeness(self) -> FloatArray:
        """How similar the segments of two labels are, 0 to 1: shape (labels, labels), symmetric.

        The mean over pairs of their segments, at most 24 of each label, in order of labels. It
        compares the postures, the speeds, and which parts of the body move together; moderate
        differences in size and tempo change it little. Segments whose mean likeness is at least
        about 0.65 share a label, except repetitions. NaN for a label with itself if only one
        segment has it.
        """
        raw, out = ffi.new("stltsa_segment *"), ffi.new("double *")
        labels = 0
        for index in range(lib.stltsa_decomposition_segment_count(self._handle)):
            check(lib.stltsa_decomposition_segment(self._handle, index, raw))
            labels = max(labels, raw.label + 1)
        result = np.empty((labels, labels))
        for label, other in np.ndindex(result.shape):
            check(lib.stltsa_decomposition_label_likeness(self._handle, label, other, out))
            result[label, other] = out[0]
        return result

    @property
    def statistics(self) -> DataFrame:
        """Times, ways, strides, speeds and turns of cycles, steps and repetitions, as a table.

        One row for each label, kind, side and quantity that is known; side -1 is both. Times are in
        seconds, lengths in the unit of the file, turns in degrees. Without a frame rate, times and
        speeds count frames instead of seconds, and trends are NaN.
        """
        labels = sorted({s.label for s in self.segment_list if s.label}, key=number_of)
        rows = statistics_of(self._handle, labels)
        if not self.clip.fps:
            rows = [in_frames(row, _FRAMES_A_SECOND) for row in rows]
        return table(tuple(rows), Statistics)

    @property
    def units(self) -> DataFrame:
        """The units as a table: a DataFrame with pandas, otherwise a NumPy record array.

        Columns: kind; begin, end in source frames, half-open; begin_s, end_s, duration_s in
        seconds.
        """
        return table(self.unit_list, Interval)

    @property
    def cycles(self) -> DataFrame:
        """The cycles as a table with the columns of :attr:`units`, and two marks.

        `representative` and `best` mark :attr:`representative_cycle` and :attr:`best_cycle`.
        """
        numbers = range(len(self.cycle_list))
        marks = {
            mark: [self._int(mark) == i for i in numbers] for mark in ("representative", "best")
        }
        return table(self.cycle_list, Interval, marks)

    def _cycle(self, name: str) -> Interval | None:
        index = self._int(name)
        return self.cycle_list[index] if index >= 0 else None

    @property
    def representative_cycle(self) -> Interval | None:
        """The first cycle of the cyclic segment that lasts longest."""
        return self._cycle("representative")

    @property
    def best_cycle(self) -> Interval | None:
        """The cycle that is most similar to the others."""
        return self._cycle("best")

    def phase(self) -> Phase:
        """Find the phase of every frame of the cycles: where it lies on the mean cycle.

        Returns
        -------
        Phase

        Examples
        --------
        >>> import numpy as np
        >>> import stltsa
        >>> result = stltsa.decompose("walker.bvh")
        >>> phase = result.phase()
        >>> bool(np.nanmax(phase.residual) < 0.5)
        True
        >>> cycles = phase.resample(result.clip.features())
        >>> len(cycles), cycles.mean.shape[0]
        (3, 101)
        """
        out = ffi.new("stltsa_phase **")
        with Call({"progress": self._options.get("progress")}) as call:
            call.check(lib.stltsa_phase_find(self._handle, call.options, out))
        return Phase(owned("phase", out), len(self.clip), self.clip.fps)

    def compare(
        self,
        second: Decomposition | None = None,
        label: str | None = None,
        second_label: str | None = None,
        *,
        samples: int = 101,
    ) -> Comparison:
        """Compare the cycles with those of another clip or, without one, left with right.

        Parameters
        ----------
        second : Decomposition, optional
            Another clip, such as the same person later. Without it, the left side of the body is
            compared with the mirror image of the right side half a cycle later. For other
            signals than features, see :meth:`Cycles.compare_left_right`.
        label, second_label, samples
            See :meth:`Phase.compare`.

        Returns
        -------
        Comparison

        Examples
        --------
        >>> import stltsa
        >>> sides = stltsa.decompose("walker.bvh").compare()
        >>> sides.sides, sides.parts[0].name, sides.parts[0].second_name
        (True, 'LeftArm', 'RightArm')
        """
        phase = self.phase()
        if second is not None:
            progress = self._options.get("progress")
            return phase.compare(
                second.phase(), label, second_label, samples=samples, progress=progress
            )
        out = ffi.new("stltsa_comparison **")
        with Call(self._options, working_rate(self.clip.fps, self._options)) as call:
            number = -1 if label is None else number_of(label)
            given = (self.clip._handle, phase._handle, number, samples)
            call.check(lib.stltsa_compare_left_right(*given, call.options, out))
        return Comparison(owned("comparison", out), timed=bool(self.clip.fps))

    def to_frame(self) -> DataFrame:
        """Return one table of all segments, units, cycles and repetitions; needs pandas.

        Columns, as of the command's ``-o units.csv``: level, kind, label; begin, end in source
        frames; begin_s, end_s, duration_s in seconds; likeness, confidence (NaN for units); way,
        stride, speed, turn_deg of cycles and repetitions (see :class:`Part`).
        """
        return _exports.to_frame(self)

    def to_xarray(self, dataset: Dataset | None = None) -> Dataset:
        """Return the answer as coordinates on time, for xarray and netCDF; needs xarray.

        Parameters
        ----------
        dataset : xarray.Dataset, optional
            Data of the same frames, such as the dataset that was decomposed. By default a new
            dataset, with the time of the clip in seconds, or in frames if the rate is unknown.

        Returns
        -------
        xarray.Dataset
            The data, with the coordinates `segment` and `cycle` (an index; cycle: -1 outside of
            cycles), `label` and `unit` on the dimension ``time``; the attributes begin with
            ``stltsa_``. A new dataset has the curve and the coordinates of the fit, too, NaN in
            frames which are not samples.

        Examples
        --------
        >>> import stltsa
        >>> data = stltsa.decompose("walker.bvh").to_xarray()  # doctest: +SKIP
        >>> data.sel(time=data.unit == "cyclic")  # doctest: +SKIP
        """
        return _exports.to_xarray(self, dataset)

    def save_events(
        self,
        path: str | os.PathLike[str],
        *,
        source: str | os.PathLike[str] | None = None,
        events: Mapping[str, FoundEvents] | None = None,
    ) -> None:
        """Write segments, units, cycles and repetitions as events; the suffix says how.

        Parameters
        ----------
        path : path
            ``.tsv``: BIDS, with a JSON file of the columns beside it; ``.csv``: the tabular events
            of BORIS; ``.c3d``: a copy of a C3D file, with an event at the begin of each segment,
            cycle and repetition and at the end of the last; needs ezc3d.
        source : path, optional
            The C3D file that is copied; by default the one that was read.
        events : mapping of str to FoundEvents, optional
            Found events by name, as :meth:`Phase.events_like` returns them. They are also written,
            with the side that the name states (in C3D files, as the context). Events that a C3D
            file already has are not repeated.

        Raises
        ------
        ValueError
            The suffix is none of these, the frame rate is unknown, or there is no C3D file.
        """
        _exports.save_events(self, path, source, events)

    def report(self, path: str | os.PathLike[str], *, command: str | None = None) -> None:
        """Write a report: one HTML page that a browser shows without a network.

        The page has the moving skeleton or points, segments, units, cycles and repetitions over
        time, the curve and the loop, mean cycles with standard deviation, left beside right,
        tables, and warnings. If the path ends in ``.svg``, a figure is written instead: the curve
        over time with units, cycles and postures, the loop, and the cycles on 0 to 100 %. The same
        input gives the same bytes.

        Parameters
        ----------
        path : path
            The page or the figure, which is written completely or not at all.
        command : str, optional
            The command or call that makes the report again, for the page to show.

        Raises
        ------
        stltsa.FileError
            The file cannot be written.
        ValueError
            The frame rate is unknown.

        Examples
        --------
        >>> import stltsa
        >>> result = stltsa.decompose("walker.bvh")
        >>> result.report("walker.html")
        >>> result.report("walker.svg")
        """
        if not self.clip.fps:
            raise ValueError("a report is in seconds, and the frame rate is unknown: give fps=")
        text = ffi.NULL if command is None else ffi.new("char[]", command.encode())
        with Call(self._options, working_rate(self.clip.fps, self._options)) as call:
            given = (self.clip._handle, self._handle, call.options, text, c_path(path))
            call.check(lib.stltsa_report_save(*given))

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
        """The smoothed coordinate whose margins count; 0 outside cycles; shape (samples,)."""
        return self._columns(lib.stltsa_decomposition_curve, 1)[:, 0]

    @property
    def coords(self) -> FloatArray:
        """The curve and a coordinate a quarter of a cycle behind; shape (samples, 2)."""
        return self._columns(lib.stltsa_decomposition_coords, 2)

    @property
    def loop(self) -> FloatArray:
        """The two coordinates of the loop, the paper's Fig. 1; shape (samples, 2).

        Each cyclic segment has coordinates of its own, so the loops of two segments cannot share
        axes.
        """
        return self._columns(lib.stltsa_decomposition_loop, 2)

    @property
    def period(self) -> float:
        """Period in seconds; 0 if none was found; NaN if the frame rate is unknown."""
        period = self._real("period")
        return period if self.clip.fps or not period else float("nan")

    @property
    def period_frames(self) -> float:
        """Period in source frames; 0 if none was found."""
        return self._real("period") * (self.clip.fps or _FRAMES_A_SECOND)

    @property
    def cyclicity(self) -> float:
        """How well that coordinate repeats once per period; 1 is a perfect oscillation."""
        return self._real("cyclicity")

    @property
    def lag_quality(self) -> float:
        """Match of the velocities one period apart; 1 is perfect."""
        return self._real("lag_quality")

    @property
    def fps(self) -> float:
        """Samples of the curve per second; 0 if the frame rate is unknown."""
        return self._real("fps") if self.clip.fps else 0.0

    @property
    def neighbors(self) -> int:
        """Neighbors (k) of the fit, in samples of 24 per cycle; 0 if nothing is cyclic."""
        return self._of_fit("neighbors")

    @property
    def window(self) -> int:
        """Window (w) of the fit, in samples of 24 per cycle; 0 if nothing is cyclic."""
        return self._of_fit("window")

    @property
    def dimension(self) -> int:
        """Tangent dimension of the fit; 0 if nothing is cyclic."""
        return self._of_fit("dimension")

    def _of_fit(self, name: str) -> int:
        return int(next(iter(self._fact(name)), 0))

    @property
    def reason(self) -> str:
        """Why nothing repeats, with the numbers; empty if anything does."""
        return string(lib.stltsa_decomposition_reason(self._handle))

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the result."""
        count = lib.stltsa_decomposition_warning_count
        found = in_keywords(texts(count, lib.stltsa_decomposition_warning, self._handle))
        if self.clip.fps:
            return found
        return (_UNKNOWN_RATE, *found)

    def __repr__(self) -> str:
        units = ", ".join(f"{u.kind} {u.begin}..{u.end}" for u in self.unit_list)
        seconds = f"{self.period:.3f} s" if self.clip.fps else f"{self.period_frames:.1f} frames"
        period = f"; period {seconds}" if self.period_frames else ""
        return f"<Decomposition: {units}; {len(self.cycle_list)} cycles{period}>"

    def _repr_html_(self) -> str:
        return _html.decomposition(self)
