# SPDX-License-Identifier: BSD-3-Clause
"""A phase for every frame, and signals on 0 to 100 % of each cycle."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._arrays import (
    FloatArray,
    IntArray,
    as_matrix,
    columns,
    read_from,
    read_list,
    write_list,
    write_to,
)
from ._call import Call, check, owned, rebuilt, texts
from ._given import wrong
from ._native import ffi, lib
from ._rows import number_of
from ._text import c_text
from .comparison import Comparison
from .errors import ArgumentError, QualityWarning
from .events import Event, side_of_name

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from ._given import Matrix
    from ._progress import Progress

_NULL = ffi.NULL


def _signals(values: Any) -> Any:
    """Return signals as a matrix; a single one may be 1-D."""
    array = np.asarray(values)
    return as_matrix(array.reshape(-1, 1) if array.ndim == 1 else values, "signals")


def cycles_between(borders: Any, signals: Matrix, *, samples: int = 101) -> Cycles:
    """Resample signals on 0 to 100 % between given borders, linearly in time.

    Parameters
    ----------
    borders : array-like of shape (count + 1,)
        Ascending frames at which cycles begin and end, such as heel strikes; not rounded. The last
        may be the number of frames; samples after the beginning of the last frame are NaN.
    signals : array-like of shape (frames,) or (frames, columns)
        NaN is a missing value, which means leave out.
    samples : int
        Of each cycle; the last one is the first of the next cycle.

    Returns
    -------
    Cycles

    Examples
    --------
    >>> import numpy as np
    >>> import stltsa
    >>> ramp = np.arange(21.0)
    >>> stltsa.cycles_between([0, 10, 20], ramp, samples=3).mean[:, 0].tolist()
    [5.0, 10.0, 15.0]
    """
    given = _signals(signals)
    at = np.ascontiguousarray(borders, dtype=np.float64).reshape(-1, 1)
    out = ffi.new("stltsa_cycles **")
    check(lib.stltsa_cycles_between(read_from(at), read_from(given), samples, out))
    return Cycles(owned("cycles", out), samples, given.shape[1])


class FoundEvent(NamedTuple):
    """A moment that was marked elsewhere.

    `frame` is not rounded; `seconds` is NaN if the frame rate is unknown; `cycle` is an index among
    :attr:`Decomposition.cycles`, -1 outside cycles; `confidence`, 0 to 1, ranks events by the size
    of their likely errors; `marked` is true for a mark itself; `side` is ``"left"``, ``"right"`` or
    ``""``, as the name of the mark states (see :meth:`Phase.events_like`).
    """

    frame: float
    seconds: float
    cycle: int
    confidence: float
    marked: bool
    side: str = ""


class FoundEvents(tuple[FoundEvent, ...]):
    """Events in order of time.

    Attributes
    ----------
    likeness : float
        Correlation of the mean cycles of the two clips; 1 within a clip. Below 0.95 trust events
        less; below 0.6 it is another motion, and there are none.
    warnings : tuple of str
        About marks at several places in the cycle, repetitions without the event, and phases that
        are linear in time.
    """

    likeness: float
    warnings: tuple[str, ...]

    def __new__(cls, handle: Any, timed: bool = True, side: str = "") -> FoundEvents:
        """Read the events of a handle; without seconds if they are not `timed`."""
        found, raw = [], ffi.new("stltsa_event *", {"size": ffi.sizeof("stltsa_event")})
        for index in range(lib.stltsa_events_count(handle)):
            check(lib.stltsa_events_event(handle, index, raw))
            found.append(
                FoundEvent(
                    raw.frame,
                    raw.seconds if timed else np.nan,
                    raw.cycle,
                    raw.confidence,
                    bool(raw.marked),
                    side,
                )
            )
        events = super().__new__(cls, found)
        events.likeness = lib.stltsa_events_likeness(handle)
        events.warnings = texts(lib.stltsa_events_warning_count, lib.stltsa_events_warning, handle)
        return events

    def __reduce__(self) -> Any:
        return rebuilt, (type(self), tuple(self), self.__dict__)


class Cycles:
    """Signals on 0 to 100 % of each cycle, with mean and spread over the cycles."""

    def __init__(self, handle: Any, samples: int, signals: int) -> None:
        self._handle = handle
        self._shape = samples, signals

    def __len__(self) -> int:
        return int(lib.stltsa_cycles_count(self._handle))

    def _pair(self, function: Any, index: int, rows: int, cols: int) -> FloatArray:
        """Return the first or second output of a function."""
        result = columns(rows, cols)
        outputs = [_NULL, _NULL]
        outputs[index] = write_to(result)
        check(function(self._handle, *outputs))
        return result

    @property
    def mean(self) -> FloatArray:
        """Mean over the cycles; shape (samples, columns)."""
        return self._pair(lib.stltsa_cycles_mean, 0, *self._shape)

    @property
    def sd(self) -> FloatArray:
        """Standard deviation over the cycles; shape (samples, columns). NaN of a single cycle."""
        return self._pair(lib.stltsa_cycles_mean, 1, *self._shape)

    @property
    def each(self) -> FloatArray:
        """All cycles; shape (cycles, samples, columns)."""
        result = np.empty((len(self), *self._shape))
        for index, values in enumerate(result):
            check(lib.stltsa_cycles_cycle(self._handle, index, write_to(values)))
        return result

    @property
    def frames(self) -> FloatArray:
        """The frame of each sample, not rounded; shape (cycles, samples)."""
        return self._pair(lib.stltsa_cycles_times, 0, len(self), self._shape[0])

    @property
    def warp(self) -> FloatArray:
        """How much later each sample is than in linear time, as a share of the cycle."""
        return self._pair(lib.stltsa_cycles_times, 1, len(self), self._shape[0])

    @property
    def distance(self) -> FloatArray:
        """Distance of each cycle from the mean, as a share of the mean cycle's deviation."""
        return self._pair(lib.stltsa_cycles_distance, 0, len(self), 1)[:, 0]

    @property
    def column_distance(self) -> FloatArray:
        """Distance of each cycle from the mean in each column, in its unit."""
        return self._pair(lib.stltsa_cycles_distance, 1, len(self), self._shape[1])

    def group_distance(self, owners: Sequence[str]) -> dict[str, FloatArray]:
        """Distance of each cycle from the mean in each joint, in its unit.

        Parameters
        ----------
        owners : sequence of str
            What each column belongs to, such as :attr:`Phase.column_owners`; "" if to nothing.

        Returns
        -------
        dict of str to ndarray of shape (cycles,)
            For each owner the root of the sum of squares over its columns.

        Examples
        --------
        >>> import stltsa
        >>> result = stltsa.decompose("walker.bvh")
        >>> phase = result.phase()
        >>> cycles = phase.resample(result.clip.features())
        >>> len(cycles.group_distance(phase.column_owners)["LeftFoot"])
        3
        """
        names = list(dict.fromkeys(name for name in owners if name))
        number = {name: index for index, name in enumerate(names)}
        groups = np.array([number.get(name, -1) for name in owners], dtype=np.int64)
        result = columns(len(self), len(names))
        check(lib.stltsa_cycles_group_distance(self._handle, read_list(groups), write_to(result)))
        return {name: result[:, index] for name, index in number.items()}

    def compare_left_right(self, names: Sequence[str], *, fps: float | None = None) -> Comparison:
        """Compare the left side of the body with the right side half a cycle later.

        Parameters
        ----------
        names : sequence of str
            One name for each column; ``knee_l`` and ``knee_r`` are a pair, as are ``LeftKnee`` and
            ``RightKnee``. Both signals must have the same sign convention, as flexion has.
        fps : float, optional
            Frames per second of the signals; without it, times are NaN.

        Returns
        -------
        Comparison
            Of the pairs, in cycles in which none of their values is missing. Cycles from
            :func:`cycles_between` should begin with an event of the left side.

        Raises
        ------
        stltsa.UnsupportedError
            The two halves of the cycles are not known to be the same motion of opposite sides, or
            no two names differ only in the side.

        Examples
        --------
        >>> import numpy as np
        >>> import stltsa
        >>> turn = 2 * np.pi * np.arange(301) / 100
        >>> knees = np.stack([np.sin(turn), 0.8 * np.sin(turn - np.pi)], axis=1)
        >>> cycles = stltsa.cycles_between([0, 100, 200, 300], knees)
        >>> (pair,) = cycles.compare_left_right(["knee_l", "knee_r"], fps=100).parts
        >>> round(pair.ratio[0], 3), abs(round(pair.lag.difference, 3))
        (0.8, 0.0)
        """
        if isinstance(names, str):
            raise TypeError(f"names is the string {names!r}, and must be a sequence of strings")
        texts = [c_text(name, "an entry of names") for name in names]
        if len(texts) != self._shape[1]:
            raise ValueError(f"names has {len(texts)} entries; there are {self._shape[1]} columns")
        out = ffi.new("stltsa_comparison **")
        given = (self._handle, ffi.new("char *[]", texts), fps or 0, _NULL)
        check(lib.stltsa_cycles_compare_left_right(*given, out))
        return Comparison(owned("comparison", out), timed=bool(fps))

    def __repr__(self) -> str:
        samples, signals = self._shape
        return f"<Cycles: {len(self)} of {samples} samples x {signals}>"


class Phase:
    """Where each frame lies on the mean cycle of its motion, in turns.

    The phase rises strictly. Cycle k of the decomposition goes from phase 0 to 1: borders lie at
    phase 0 on average, and within about 1 % of it.
    """

    def __init__(self, handle: Any, frames: int, fps: float) -> None:
        self._handle = handle
        self._frames = frames
        self._fps = fps

    def _fill(self, index: int, values: FloatArray | IntArray) -> None:
        outputs = [_NULL, _NULL, _NULL]
        outputs[index] = write_list(values)
        check(lib.stltsa_phase_values(self._handle, *outputs))

    @property
    def values(self) -> FloatArray:
        """Phase of each frame in [0, 1); NaN outside cycles."""
        values = np.empty(self._frames)
        self._fill(0, values)
        return values

    def zero(self, label: str = "A") -> float:
        """Return the phase at which the body is at the same place in every clip and person.

        It does not depend on where cycles begin: the legs pass each other there, if the sides of
        the body are known and swing.

        Parameters
        ----------
        label : str
            Of the segments.

        Raises
        ------
        stltsa.ArgumentError
            The label has neither cycles nor repetitions.
        """
        zero = ffi.new("double *")
        check(lib.stltsa_phase_zero(self._handle, number_of(label), zero))
        return float(zero[0])

    @property
    def residual(self) -> FloatArray:
        """Distance from the mean cycle, as a share of the deviation; NaN outside cycles."""
        residual = np.empty(self._frames)
        self._fill(1, residual)
        return residual

    @property
    def cycle(self) -> IntArray:
        """Index of the cycle of each frame among :attr:`Decomposition.cycles`; -1 outside."""
        cycle = np.empty(self._frames, dtype=np.int64)
        self._fill(2, cycle)
        return cycle

    @property
    def column_owners(self) -> tuple[str, ...]:
        """The joint, point or column of the file that each column of the features belongs to."""
        return texts(lib.stltsa_phase_column_count, lib.stltsa_phase_column_owner, self._handle)

    @property
    def warnings(self) -> tuple[str, ...]:
        """About motions whose phase is linear in time: their mean cycle explains too little."""
        return texts(lib.stltsa_phase_warning_count, lib.stltsa_phase_warning, self._handle)

    def compare(
        self,
        second: Phase,
        label: str | None = None,
        second_label: str | None = None,
        *,
        samples: int = 101,
        progress: Progress = False,
    ) -> Comparison:
        """Align the cycles of another motion with those of this one by phase, and compare them.

        Parameters
        ----------
        second : Phase
            The phase of another clip, such as one of the same person later, or of this clip. Frame
            rates and lengths may differ; joints, points or columns of the same name are compared.
        label, second_label : str, optional
            Labels of the segments whose cycles are compared; by default, the motion of this clip
            with the most frames in cycles, and the motion of the second that is most like it.
        samples : int
            Samples per cycle, 5 to 1001; 101 gives one for each percent.
        progress : bool or callable
            As for :func:`stltsa.decompose`.

        Returns
        -------
        Comparison

        Raises
        ------
        stltsa.StltsaError
            One of the clips has no cycles, or they have nothing in common.

        Examples
        --------
        >>> import stltsa
        >>> first, second = (stltsa.decompose(f"walker.bvh:{part}") for part in ("0-", "150-"))
        >>> compared = first.phase().compare(second.phase())
        >>> compared.likeness > 0.99, abs(compared["LeftFoot"].lag.difference) < 0.01
        (True, True)
        """
        labels = (-1 if each is None else number_of(each) for each in (label, second_label))
        first_number, second_number = labels
        out = ffi.new("stltsa_comparison **")
        motions = (self._handle, first_number, second._handle, second_number)
        with Call({"progress": progress}) as call:
            call.check(lib.stltsa_compare_with(*motions, samples, call.options, out))
        return Comparison(owned("comparison", out), timed=bool(self._fps and second._fps))

    def events(
        self,
        marks: float | Sequence[float],
        other: Phase | None = None,
        *,
        name: str = "",
        progress: Progress = False,
    ) -> FoundEvents:
        """Find the event at one or more marked frames wherever it comes again.

        Parameters
        ----------
        marks : float or sequence of float
            Frames of this clip in cycles or repetitions, such as one heel strike; not rounded.
            If marks lie farther than a tenth of a cycle apart, they mark several places.
        other : Phase, optional
            Of another clip with the same features, such as another person's, in which to look.
        name : str
            Name of the event. If it states a side, as ``"left heel strike"`` does, the found events
            have this side.
        progress : bool or callable
            As for :func:`stltsa.decompose`.

        Returns
        -------
        FoundEvents
            In order of time.

        Raises
        ------
        stltsa.ArgumentError
            A mark lies in no motion that repeats, or the marks are spread all over the cycle.
        stltsa.ShapeError
            The features of the clips differ.

        Examples
        --------
        >>> import stltsa
        >>> phase = stltsa.decompose("walker.bvh").phase()
        >>> events = phase.events(250)
        >>> [round(event.seconds, 2) for event in events if event.cycle >= 0]
        [2.08, 3.18, 4.28]
        """
        at = np.atleast_2d(np.asarray(marks, dtype=np.float64)).reshape(-1, 1)
        side = side_of_name(name)
        if other is not None and not isinstance(other, Phase):
            raise wrong("other", other, "a Phase, the result of Decomposition.phase")
        out = ffi.new("stltsa_events **")
        target = _NULL if other is None else other._handle
        marked = (self._handle, read_from(at), target)
        with Call({"progress": progress}) as call:
            call.check(lib.stltsa_events_find_with(*marked, call.options, out))
        return FoundEvents(owned("events", out), (other or self)._fps > 0, side)

    def events_like(
        self,
        labels: Iterable[Event],
        other: Phase | None = None,
        *,
        progress: Progress = False,
    ) -> dict[str, FoundEvents]:
        """Find events that a file labels, such as foot strikes of a C3D file, in every cycle.

        Parameters
        ----------
        labels : iterable of Event
            Such as :attr:`Clip.events`. A label is left out if it lies in no motion that repeats,
            and so is a name whose labels are spread all over the cycle.
        other : Phase, optional
            Of another clip with the same features, in which to look.
        progress : bool or callable
            As for :func:`stltsa.decompose`; it starts again with each name.

        Returns
        -------
        dict of str to FoundEvents
            By context and label, such as ``"Left Foot Strike"``.

        Warns
        -----
        QualityWarning
            Labels that are left out.

        Raises
        ------
        stltsa.ArgumentError
            The frame rate is unknown, and labels are in seconds.
        stltsa.ShapeError
            The features of the clips differ.
        """
        marks: dict[str, list[float]] = {}
        for label in labels:
            if not isinstance(label, Event):
                raise wrong("a label", label, "a stltsa.Event")
            marks.setdefault(f"{label.context} {label.label}".strip(), []).append(
                label.seconds * self._fps
            )
        if marks and not self._fps > 0:
            raise ArgumentError(
                "labels are in seconds, but the frame rate of the clip is unknown: give fps when "
                "the clip is read",
                lib.STLTSA_E_ARGUMENT,
                "STLTSA_E_ARGUMENT",
            )
        found = {}
        for name, frames in marks.items():
            events = self._events_like(name, frames, other, progress)
            if events is not None:
                found[name] = events
        return found

    def _events_like(
        self, name: str, frames: list[float], other: Phase | None, progress: Progress
    ) -> FoundEvents | None:
        """Find the events at those of the frames that lie in motions that repeat."""
        try:
            return self.events(frames, other, name=name, progress=progress)
        except ArgumentError:
            inside = self._repeating(frames)
        found, left_out = None, ""
        if not inside:
            left_out = f"{name} is left out: none of its labels is in a motion that repeats"
        else:
            try:
                found = self.events(inside, other, name=name, progress=progress)
            except ArgumentError as error:
                left_out = f"{name} is left out: {error}"
            else:
                if len(inside) < len(frames):
                    left_out = (
                        f"{name}: {len(frames) - len(inside)} of {len(frames)} labels are left "
                        "out: they are in no motion that repeats"
                    )
        if left_out:
            warnings.warn(left_out, QualityWarning, stacklevel=3)
        return found

    def _repeating(self, frames: list[float]) -> list[float]:
        """Return the frames in motions that repeat: by halves, as each refusal is a search."""
        try:
            self.events(frames)
        except ArgumentError:
            middle = len(frames) // 2
            return [
                frame
                for half in (frames[:middle], frames[middle:])
                if middle
                for frame in self._repeating(half)
            ]
        return frames

    def resample(self, signals: Matrix, *, label: str = "A", samples: int = 101) -> Cycles:
        """Resample any signals of the clip's frames on 0 to 100 % of each cycle.

        Parameters
        ----------
        signals : array-like of shape (frames,) or (frames, columns)
            Features, joint angles, forces, EMG, ...; NaN is a missing value.
        label : str
            Of the segments whose cycles are meant; if they have no cycles, their repetitions.
        samples : int
            Of each cycle; the last one is phase 0 of the next cycle.

        Returns
        -------
        Cycles
            Samples that the clip does not reach, at the first and the last cycle, are NaN. A cycle
            without a neighbor is closed: samples beyond one end are taken from its other end.

        Raises
        ------
        stltsa.ArgumentError
            The label has neither cycles nor repetitions.
        stltsa.ShapeError
            The signals have another number of frames.
        """
        given = _signals(signals)
        out = ffi.new("stltsa_cycles **")
        check(
            lib.stltsa_cycles_resample(
                self._handle, number_of(label), read_from(given), samples, out
            )
        )
        return Cycles(owned("cycles", out), samples, given.shape[1])

    def __repr__(self) -> str:
        return f"<Phase: {self._frames} frames, {int((self.cycle >= 0).sum())} in cycles>"
