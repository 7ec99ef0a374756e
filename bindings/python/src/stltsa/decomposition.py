# SPDX-License-Identifier: BSD-3-Clause
"""Motion units and cycles (the paper, section 3.1)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _exports, _html
from ._call import Call, made
from ._facts import Described
from ._native import ffi, lib
from ._options import working_rate
from ._rows import Part, Segment, Summary, Unit
from ._statistics import PartStatistics, in_frames, statistics_of
from ._tables import table
from ._text import c_path, c_text, number_of
from .clip import Clip, as_clip, one_matrix, opened
from .comparison import Comparison
from .errors import warn_of_order
from .phase import Phase
from .readers import is_points

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping

    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._arrays import FloatArray, IntArray
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
        Used: `features`, `up_axis`, `gaps`, `min_confidence`, `keep_start`, `sample_rate`,
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
    rate = working_rate(clip.fps, rest)
    handle = made("decomposition", lib.stltsa_decompose, clip._handle, options=rest, rate=rate)
    result = Decomposition(handle, clip, rest)
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
        super().__init__(handle, timed=bool(clip.fps))
        self.clip = clip
        self._options = options

    @property
    def segment_list(self) -> tuple[Segment, ...]:
        """The segments in temporal order; they cover the clip without gap or overlap."""
        return self._list("segment")

    @property
    def unit_list(self) -> tuple[Unit, ...]:
        """The units in temporal order; they cover the clip without gap or overlap."""
        return self._list("unit")

    @property
    def cycle_list(self) -> tuple[Part, ...]:
        """The cycles in temporal order, back to back within a segment."""
        return self._list("cycle")

    @property
    def segments(self) -> DataFrame:
        """The segments as a table: a DataFrame with pandas, otherwise a NumPy record array.

        Columns: those of :class:`Segment`, and duration_s. So are the next tables.
        """
        return table(self.segment_list, Segment)

    @property
    def units(self) -> DataFrame:
        """The units as a table: see :class:`Unit`."""
        return table(self.unit_list, Unit)

    @property
    def cycles(self) -> DataFrame:
        """The cycles with side, likeness and travel of each as a table: see :class:`Part`.

        `representative` and `best` mark :attr:`representative_cycle` and :attr:`best_cycle`.
        """
        rows = self.cycle_list
        chosen = {mark: self._int(mark) for mark in ("representative", "best")}
        marks = {mark: np.arange(len(rows)) == index for mark, index in chosen.items()}
        return table(rows, Part, marks)

    @property
    def steps(self) -> DataFrame:
        """Halves of cycles in which both sides of the body alternate, as a table."""
        return table(self._list("step"), Part)

    @property
    def repetitions(self) -> DataFrame:
        """The actions of the segments that repeat with pauses, as a table."""
        return table(self._list("repetition"), Part)

    @property
    def summary(self) -> DataFrame:
        """How often and how fast, for each label that repeats, as a table: see :class:`Summary`."""
        return table(self._list("summary"), Summary)

    @property
    def label_likeness(self) -> FloatArray:
        """How similar the segments of two labels are, 0 to 1: shape (labels, labels), symmetric.

        The mean over pairs of their segments, at most 24 of each label, in order of labels. It
        compares the postures, the speeds, and which parts of the body move together; moderate
        differences in size and tempo change it little. Segments whose mean likeness is at least
        about 0.65 share a label, except repetitions. NaN for a label with itself if only one
        segment has it.
        """
        return self._array("label_likeness")

    @property
    def statistics(self) -> DataFrame:
        """Time, path length, stride, speed and turn of cycles, steps and repetitions, as a table.

        One row for each label, kind, side and quantity that is known; side -1 is both. Times are in
        seconds, lengths in the unit of the file, turns in degrees. Without a frame rate, times and
        speeds count frames instead of seconds, and trends are NaN.
        """
        labels = sorted({s.label for s in self.segment_list if s.label}, key=number_of)
        rows = statistics_of(self._handle, labels)
        if not self._timed:
            rows = [in_frames(row, _FRAMES_A_SECOND) for row in rows]
        return table(rows, PartStatistics)

    def _cycle(self, name: str) -> Part | None:
        index = self._int(name)
        return self.cycle_list[index] if index >= 0 else None

    @property
    def representative_cycle(self) -> Part | None:
        """The first cycle of the cyclic segment that lasts longest."""
        return self._cycle("representative")

    @property
    def best_cycle(self) -> Part | None:
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
        progress = {"progress": self._options.get("progress")}
        handle = made("phase", lib.stltsa_phase_find, self._handle, options=progress)
        return Phase(handle, timed=self._timed)

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
        >>> sides.whole.sides, sides.parts[0].first, sides.parts[0].second
        (True, 'LeftArm', 'RightArm')
        """
        phase = self.phase()
        if second is not None:
            progress = self._options.get("progress")
            return phase.compare(
                second.phase(), label, second_label, samples=samples, progress=progress
            )
        number = -1 if label is None else number_of(label)
        given = lib.stltsa_compare_left_right, self.clip._handle, phase._handle, number, samples
        rate = working_rate(self.clip.fps, self._options)
        handle = made("comparison", *given, options=self._options, rate=rate)
        return Comparison(handle, timed=self._timed)

    def to_frame(self) -> DataFrame:
        """Return one table of all segments, units, cycles and repetitions; needs pandas.

        Columns, as of the command's ``-o units.csv``: level, kind, label; begin, end in source
        frames; begin_s, end_s, duration_s in seconds; likeness, confidence (NaN for units);
        path_length, stride, speed, turn_deg of cycles and repetitions (see :class:`Part`).
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
        text = ffi.NULL if command is None else c_text(command, "command")
        with Call(self._options, working_rate(self.clip.fps, self._options)) as call:
            given = (self.clip._handle, self._handle, call.options, text, c_path(path))
            call.check(lib.stltsa_report_save(*given))

    @property
    def frames(self) -> IntArray:
        """Source frame of each sample of the curve; shape (samples,)."""
        first, step = self._int("first_frame"), self._int("frame_step")
        return first + step * np.arange(self._int("rows"))

    @property
    def curve(self) -> FloatArray:
        """The smoothed coordinate whose margins count; 0 outside cycles; shape (samples,)."""
        return self._array("curve")[:, 0]

    @property
    def coords(self) -> FloatArray:
        """The curve, and itself a quarter of a cycle behind; shape (samples, 2).

        Together they are the loop of the paper's Fig. 1. Each cyclic segment has coordinates of its
        own, so the loops of two segments cannot share axes.
        """
        return self._array("coords")

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
    def fps(self) -> float:
        """Samples of the curve per second; 0 if the frame rate is unknown."""
        return self._real("fps") if self.clip.fps else 0.0

    @property
    def reason(self) -> str:
        """Why nothing repeats, with the numbers; empty if anything does."""
        return self._text("reason")

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a user should know about the result."""
        found = super().warnings
        return found if self._timed else (_UNKNOWN_RATE, *found)

    def __repr__(self) -> str:
        units = ", ".join(f"{u.kind} {u.begin}..{u.end}" for u in self.unit_list)
        seconds = f"{self.period:.3f} s" if self.clip.fps else f"{self.period_frames:.1f} frames"
        period = f"; period {seconds}" if self.period_frames else ""
        return f"<Decomposition: {units}; {len(self.cycle_list)} cycles{period}>"

    def _repr_html_(self) -> str:
        return _html.decomposition(self)
