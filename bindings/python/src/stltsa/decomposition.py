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


def decompose(motion: Any, **options: Unpack[Options]) -> Decomposition:
    """Cut a clip into motion units and cycles.

    The library finds the period first and derives the neighborhoods from it, so nothing needs
    tuning. A clip without trustworthy cycles is not an error: it is cut into activity and rest, and
    :attr:`Decomposition.reason` explains why.

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
        """The cycles in temporal order, back to back."""
        return self._intervals(lib.stltsa_decomposition_cycle_count, lib.stltsa_decomposition_cycle)

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
        """Why there are no cycles, with the numbers; empty if there are cycles."""
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
