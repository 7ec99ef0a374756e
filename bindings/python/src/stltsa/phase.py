# SPDX-License-Identifier: BSD-3-Clause
"""A phase for every frame, and signals on 0 to 100 % of each cycle."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import FloatArray, IntArray, as_matrix, columns, read_from, read_list, write_to
from ._call import check, made, rebuilt
from ._facts import Described
from ._given import wrong
from ._native import ffi, lib
from ._rows import Event, FileEvent
from ._text import c_text, number_of
from .comparison import Comparison
from .errors import ArgumentError, QualityWarning
from .events import side_of_name

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from ._given import Matrix
    from ._progress import Progress


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
    return Cycles(
        made("cycles", lib.stltsa_cycles_between, read_from(at), read_from(given), samples)
    )


class _EventsHandle(Described):
    _kind = "events"


class FoundEvents(tuple[Event, ...]):
    """Events in order of time.

    Attributes
    ----------
    side : str
        ``"left"``, ``"right"`` or ``""``, as the name of the mark states (see
        :meth:`Phase.events_like`).
    likeness : float
        Correlation of the mean cycles of the two clips; 1 within a clip. Below 0.95 trust events
        less; below 0.6 it is another motion, and there are none.
    warnings : tuple of str
        About marks at several places in the cycle, repetitions without the event, and phases that
        are linear in time.
    """

    side: str
    likeness: float
    warnings: tuple[str, ...]

    def __new__(cls, handle: Any, timed: bool = True, side: str = "") -> FoundEvents:
        """Read the events of a handle; without seconds if they are not `timed`."""
        found = _EventsHandle(handle, timed=timed)
        events = super().__new__(cls, found._list("event"))
        events.side = side
        events.likeness = found._real("likeness")
        events.warnings = found.warnings
        return events

    def __reduce__(self) -> Any:
        return rebuilt, (type(self), tuple(self), self.__dict__)


class Cycles(Described):
    """Signals on 0 to 100 % of each cycle, with mean and spread over the cycles."""

    _kind = "cycles"

    def __len__(self) -> int:
        return len(self.distance)

    @property
    def mean(self) -> FloatArray:
        """Mean over the cycles; shape (samples, columns)."""
        return self._array("mean")

    @property
    def sd(self) -> FloatArray:
        """Standard deviation over the cycles; shape (samples, columns). NaN of a single cycle."""
        return self._array("deviation")

    @property
    def each(self) -> FloatArray:
        """All cycles; shape (cycles, samples, columns)."""
        return np.stack([self._array("values", index) for index in range(len(self))])

    @property
    def frames(self) -> FloatArray:
        """The frame of each sample, not rounded; shape (cycles, samples)."""
        return self._array("sample_frames")

    @property
    def warp(self) -> FloatArray:
        """How much later each sample is than in linear time, as a share of the cycle."""
        return self._array("warp")

    @property
    def distance(self) -> FloatArray:
        """Distance of each cycle from the mean, as a share of the mean cycle's deviation."""
        return self._array("distance")[:, 0]

    @property
    def column_distance(self) -> FloatArray:
        """Distance of each cycle from the mean in each column, in its unit."""
        return self._array("column_distance")

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
        >>> round(pair.amplitude_ratio.value, 3), abs(round(pair.lag.difference, 3))
        (0.8, 0.0)
        """
        if isinstance(names, str):
            raise TypeError(f"names is the string {names!r}, and must be a sequence of strings")
        texts = [c_text(name, "an entry of names") for name in names]
        signals = self.mean.shape[1]
        if len(texts) != signals:
            raise ValueError(f"names has {len(texts)} entries; there are {signals} columns")
        given = (self._handle, ffi.new("char *[]", texts), fps or 0)
        handle = made("comparison", lib.stltsa_cycles_compare_left_right, *given)
        return Comparison(handle, timed=bool(fps))

    def __repr__(self) -> str:
        samples, signals = self.mean.shape
        return f"<Cycles: {len(self)} of {samples} samples x {signals}>"


class Phase(Described):
    """Where each frame lies on the mean cycle of its motion, in turns.

    The phase rises strictly. Cycle k of the decomposition goes from phase 0 to 1: borders lie at
    phase 0 on average, and within about 1 % of it.
    """

    _kind = "phase"

    @property
    def values(self) -> FloatArray:
        """Phase of each frame in [0, 1); NaN outside cycles."""
        return self._array("phase")[:, 0]

    def zero(self, label: str = "A") -> float:
        """Return the phase at which the body is at the same place in every clip and person.

        It does not depend on where cycles begin: the legs pass each other there, if the sides of
        the body are known and swing. It is 0 for repetitions.

        Parameters
        ----------
        label : str
            Of the segments.

        Raises
        ------
        stltsa.ArgumentError
            The label has neither cycles nor repetitions.
        """
        zeros = dict(enumerate(self._list("phase_zero")))
        zero = zeros.get(number_of(label), np.nan)
        if np.isnan(zero):
            text = f"label {label} has neither cycles nor repetitions"
            raise ArgumentError(text, lib.STLTSA_E_ARGUMENT, "STLTSA_E_ARGUMENT")
        return float(zero)

    @property
    def residual(self) -> FloatArray:
        """Distance from the mean cycle, as a share of the deviation; NaN outside cycles."""
        return self._array("phase_residual")[:, 0]

    @property
    def cycle(self) -> IntArray:
        """Index of the cycle of each frame among :attr:`Decomposition.cycles`; -1 outside."""
        return self._integers("phase_cycle")

    @property
    def column_owners(self) -> tuple[str, ...]:
        """The joint, point or column of the file that each column of the features belongs to."""
        return self._list("owner")

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
        >>> compared.whole.likeness > 0.99, abs(compared["LeftFoot"].lag.difference) < 0.01
        (True, True)
        """
        labels = (-1 if each is None else number_of(each) for each in (label, second_label))
        first_number, second_number = labels
        given = (self._handle, first_number, second._handle, second_number, samples)
        handle = made("comparison", lib.stltsa_compare, *given, options={"progress": progress})
        return Comparison(handle, timed=self._timed and second._timed)

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
        target = other or self
        given = (self._handle, read_from(at), target._handle)
        handle = made("events", lib.stltsa_events_find, *given, options={"progress": progress})
        return FoundEvents(handle, target._timed, side)

    def events_like(
        self,
        labels: Iterable[FileEvent],
        other: Phase | None = None,
        *,
        progress: Progress = False,
    ) -> dict[str, FoundEvents]:
        """Find events that a file labels, such as foot strikes of a C3D file, in every cycle.

        Parameters
        ----------
        labels : iterable of FileEvent
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
        stltsa.ShapeError
            The features of the clips differ.
        """
        marks: dict[str, list[float]] = {}
        for label in labels:
            if not isinstance(label, FileEvent):
                raise wrong("a label", label, "a stltsa.FileEvent")
            marks.setdefault(f"{label.context} {label.label}".strip(), []).append(label.frame)
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
        motion = (self._handle, number_of(label), read_from(given), samples)
        return Cycles(made("cycles", lib.stltsa_cycles_resample, *motion))

    def __repr__(self) -> str:
        cycle = self.cycle
        return f"<Phase: {len(cycle)} frames, {int((cycle >= 0).sum())} in cycles>"
