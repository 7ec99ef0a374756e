# SPDX-License-Identifier: BSD-3-Clause
"""Comparison of left and right over a cycle."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ._arrays import FloatArray, columns, write_to
from ._call import check, rebuilt
from ._native import ffi, lib
from ._tables import frame
from ._text import c_text, string

if TYPE_CHECKING:
    from pandas import DataFrame

_SIDES = {lib.STLTSA_SIDE_LEFT: "left", lib.STLTSA_SIDE_RIGHT: "right"}


def side_of_name(name: str) -> str:
    """Return the side of the body that the name of an event, a joint or a signal states.

    Parameters
    ----------
    name : str
        Such as ``"left heel strike"``, ``"LHS"`` or ``"toe_l"``.

    Returns
    -------
    str
        ``"left"``, ``"right"``, or ``""`` if the name states neither or both.

    Examples
    --------
    >>> import stltsa
    >>> [stltsa.side_of_name(name) for name in ("LHS", "Right Foot Off", "upright")]
    ['left', 'right', '']
    """
    return _SIDES.get(lib.stltsa_side_of_name(c_text(name, "name")), "")


class SidePair(NamedTuple):
    """A signal of the left side of the body and the same one of the right side half a cycle later.

    `left` and `right` are names; `left_column` and `right_column` are the columns of the signals.
    `rms` is the root mean square of left minus right, and `chance` the value expected from the
    spread between cycles alone. `mean` is the mean of left minus the mean of right. The ranges are
    the highest minus the lowest value. `shift` is the delay of right beyond half a cycle after
    left, as a share of the cycle (-0.25 to 0.25). `correlation` is that of the curves after the
    shift is removed. NaN means unknown: `shift` if the curves are not alike (correlation below
    0.7), and both if a curve does not move. `rms`, `chance`, `mean` and the ranges are in the unit
    of the signals.
    """

    left: str
    right: str
    left_column: int
    right_column: int
    rms: float
    chance: float
    mean: float
    left_range: float
    right_range: float
    shift: float
    correlation: float

    @property
    def range_difference(self) -> float:
        """Range of left minus range of right."""
        return self.left_range - self.right_range


class Sides(tuple[SidePair, ...]):
    """Pairs of a left and a right signal, with their mean curves over the cycle.

    Attributes
    ----------
    left, right, difference : ndarray of shape (samples, pairs)
        Mean curves and left minus right. The right curves are shifted by half a cycle and, for
        features, mirrored.
    reason : str
        The reason if there are no pairs; "" if there are pairs.
    """

    left: FloatArray
    right: FloatArray
    difference: FloatArray
    reason: str

    def __new__(cls, handle: Any, samples: int) -> Sides:
        """Read the pairs of a handle."""
        count = lib.stltsa_sides_count(handle)
        sides = super().__new__(cls, [_pair(handle, index) for index in range(count)])
        sides.left, sides.right, sides.difference = (columns(samples, count) for _ in range(3))
        curves = (sides.left, sides.right, sides.difference)
        check(lib.stltsa_sides_curves(handle, *map(write_to, curves)) if count else 0)
        sides.reason = string(lib.stltsa_sides_reason(handle))
        return sides

    def __reduce__(self) -> Any:
        return rebuilt, (type(self), tuple(self), self.__dict__)

    def to_frame(self) -> DataFrame:
        """Return one row per pair; needs pandas."""
        return frame(list(self), SidePair)


def _pair(handle: Any, index: int) -> SidePair:
    raw = ffi.new("stltsa_side_pair *", {"size": ffi.sizeof("stltsa_side_pair")})
    check(lib.stltsa_sides_pair(handle, index, raw))
    return SidePair(
        left=string(lib.stltsa_sides_left_name(handle, index)),
        right=string(lib.stltsa_sides_right_name(handle, index)),
        left_column=raw.left,
        right_column=raw.right,
        rms=raw.rms,
        chance=raw.chance,
        mean=raw.mean,
        left_range=raw.left_range,
        right_range=raw.right_range,
        shift=raw.shift,
        correlation=raw.correlation,
    )
