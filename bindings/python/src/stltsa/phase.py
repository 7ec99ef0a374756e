# SPDX-License-Identifier: BSD-3-Clause
"""A phase for every frame, and signals on 0 to 100 % of each cycle."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import FloatArray, IntArray, as_matrix, columns, read_from, write_to
from ._call import check, owned, texts
from ._native import ffi, lib
from ._rows import number_of

if TYPE_CHECKING:
    from ._given import Matrix

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
        Ascending frames at which cycles begin and end, such as heel strikes; not rounded.
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
        """Distance of each cycle from the mean, as a share of the deviation along the mean cycle."""
        return self._pair(lib.stltsa_cycles_distance, 0, len(self), 1)[:, 0]

    @property
    def column_distance(self) -> FloatArray:
        """Distance of each cycle from the mean in each column, in its unit."""
        return self._pair(lib.stltsa_cycles_distance, 1, len(self), self._shape[1])

    def __repr__(self) -> str:
        samples, signals = self._shape
        return f"<Cycles: {len(self)} of {samples} samples x {signals}>"


class Phase:
    """Where each frame lies on the mean cycle of its motion, in turns.

    The phase rises strictly and is continuous across the borders of cycles; 0 is at the same place
    of the body in every cycle and clip.
    """

    def __init__(self, handle: Any, frames: int) -> None:
        self._handle = handle
        self._frames = frames

    def _column(self, index: int) -> Any:
        result: Any = columns(self._frames, 1)
        if index == 2:
            result = np.empty((self._frames, 1), dtype=np.int64)
        outputs = [_NULL, _NULL, _NULL]
        outputs[index] = write_to(result)
        check(lib.stltsa_phase_values(self._handle, *outputs))
        return result[:, 0]

    @property
    def values(self) -> FloatArray:
        """Phase of each frame in [0, 1); NaN outside cycles."""
        return self._column(0)

    @property
    def residual(self) -> FloatArray:
        """Distance from the mean cycle, as a share of the motion's deviation; NaN outside cycles."""
        return self._column(1)

    @property
    def cycle(self) -> IntArray:
        """Index of the cycle of each frame among :attr:`Decomposition.cycles`; -1 outside."""
        return self._column(2)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Of motions whose phase is linear in time, because the mean cycle explains too little."""
        return texts(lib.stltsa_phase_warning_count, lib.stltsa_phase_warning, self._handle)

    def resample(self, signals: Matrix, *, label: str = "A", samples: int = 101) -> Cycles:
        """Resample any signals of the clip's frames on 0 to 100 % of each cycle.

        Parameters
        ----------
        signals : array-like of shape (frames,) or (frames, columns)
            Features, joint angles, forces, EMG, ...; NaN is a missing value.
        label : str
            Of the segments whose cycles are meant.
        samples : int
            Of each cycle; the last one is phase 0 of the next cycle.

        Returns
        -------
        Cycles
            Samples that the clip does not reach, at the first and the last cycle, are NaN.

        Raises
        ------
        stltsa.ArgumentError
            The label has no cycles.
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
