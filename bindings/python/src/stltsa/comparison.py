# SPDX-License-Identifier: BSD-3-Clause
"""The cycles of two motions, aligned by phase."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from ._arrays import FloatArray, columns, write_to
from ._call import check, json_text, texts
from ._native import ffi, lib
from ._tables import frame
from ._text import c_path, string

if TYPE_CHECKING:
    import os

    from pandas import DataFrame

_NULL = ffi.NULL
_NAN = float("nan")
_UNKNOWN_RATE = (
    "a frame rate is unknown: times are NaN, and times in the JSON assume 30 frames per second; "
    "give fps="
)


class Difference(NamedTuple):
    """A quantity of both mean cycles and its difference, second minus first.

    `low` and `high` are the 95 % confidence interval of the difference, from the spread between
    cycles; `significant` is true if the interval excludes 0. Of 20 differences that are really
    zero, about one is significant by chance. Unknown values are NaN.
    """

    first: float
    first_sd: float
    second: float
    second_sd: float
    difference: float
    standard_error: float
    low: float
    high: float
    significant: bool


class ComparedPart(NamedTuple):
    """A joint, a point or a column of the file, or one of its coordinates.

    `name` and `second_name` differ only for left and right. `axis` is "" for a whole part and for
    the only channel of a part. `rms` is the root mean square, over the cycle, of second minus
    first, and `chance` the value expected from the spread between cycles alone. `lag` is how much
    later in its cycle the second motion does the same, relative to the whole body (left and right:
    to half a cycle), as a share of the cycle; `lag_s` is the lag in seconds with its interval.
    `correlation` is that of the mean curves after the lag is removed. `amplitude` is the largest
    distance between two points of the mean curve (of one channel, its range); `ratio` is the
    amplitude of the second motion divided by that of the first, with its interval. `mean` is the
    mean over the cycle, for a part with one channel.
    """

    name: str
    second_name: str
    axis: str
    rms: float
    chance: float
    correlation: float
    lag: Difference
    amplitude: Difference
    ratio: tuple[float, float, float]
    lag_s: tuple[float, float, float]
    mean: Difference

    def _flat(self) -> dict[str, Any]:
        row: dict[str, Any] = {}
        for name, value in self._asdict().items():
            if isinstance(value, Difference):
                row |= {f"{name}_{field}": each for field, each in value._asdict().items()}
            elif isinstance(value, tuple):
                ends = zip((name, f"{name}_low", f"{name}_high"), value, strict=True)
                row |= dict(ends)
            else:
                row[name] = value
        return row


class Comparison:
    """The differences between the cycles of two motions, and how precisely they are known.

    Attributes
    ----------
    parts, channels : tuple of ComparedPart
        Joints, points or columns; and their coordinates, part by part.
    counts : tuple of int
        Number of cycles of each motion.
    labels : tuple of int
        Labels of their segments, 0 for A.
    cycle_time : Difference
        In seconds; NaN, as all times are, if a frame rate is unknown.
    per_minute : tuple of float
        Cycles per minute of each motion.
    shift : float
        Phase of the second motion at phase 0 of the first, in cycles: the shift at which all parts
        together match best.
    shift_error : float
        Its standard error.
    shift_interval : tuple of float
        Its 95 % confidence interval.
    likeness, runner_up : float
        Correlation of the mean cycles, and that at the next best shift (NaN: there is none).
    turn : float
        Degrees by which the second body was turned about the up axis to face as the first does.
    size_ratio : float
        Size of the second body divided by that of the first; NaN if it is unknown.
    judged, significant : int
        Number of lags and amplitudes of parts that have an interval, and how many of them are
        significant; by chance, a twentieth would be.
    sides : bool
        Whether left and right of one clip are compared.
    mean, sd : tuple of two ndarrays of shape (samples, channels)
        Mean cycles of both motions, and standard deviations between cycles.
    difference, standard_error, margin : ndarray of shape (samples, channels)
        Second minus first at each sample, its standard error, and half the width of its interval.
    left_out : tuple of two tuples of str
        Names in each clip that the other one lacks.
    warnings : tuple of str
        What a user should know about the result.
    """

    def __init__(self, handle: Any, *, timed: bool = True) -> None:
        self._handle = handle
        self._timed = timed
        raw = ffi.new("stltsa_compared_cycles *", {"size": ffi.sizeof("stltsa_compared_cycles")})
        check(lib.stltsa_comparison_cycles(handle, raw))
        self.counts = (raw.first_count, raw.second_count)
        self.labels = (raw.first_label, raw.second_label)
        self.cycle_time = _difference(raw.cycle_time)
        self.per_minute = (raw.first_per_minute, raw.second_per_minute)
        self.shift = raw.shift
        self.shift_error = raw.shift_error
        self.shift_interval = (raw.shift_low, raw.shift_high)
        self.likeness = raw.likeness
        self.runner_up = raw.runner_up
        self.turn = raw.turn
        self.size_ratio = raw.size_ratio
        self.judged, self.significant = raw.judged, raw.significant
        self.sides = bool(raw.sides)
        self.parts, self.channels = _parts(handle), _channels(handle)
        shape = (raw.samples, len(self.channels))
        self.mean = tuple(_curves(handle, which, 0, shape) for which in (0, 1))
        self.sd = tuple(_curves(handle, which, 1, shape) for which in (0, 1))
        self.difference, self.standard_error, self.margin = (columns(*shape) for _ in range(3))
        outputs = (self.difference, self.standard_error, self.margin)
        check(lib.stltsa_comparison_difference(handle, *map(write_to, outputs)))
        self.left_out = tuple(_left_out(handle, which) for which in (0, 1))
        count, text = lib.stltsa_comparison_warning_count, lib.stltsa_comparison_warning
        self.warnings = texts(count, text, handle)
        self._json = json_text(lib.stltsa_comparison_json, handle)
        if not timed:
            self._forget_seconds()

    def _forget_seconds(self) -> None:
        """Set values that depend on the unknown frame rate to NaN."""
        self.cycle_time = Difference._make([*8 * [_NAN], False])
        self.per_minute = (_NAN, _NAN)
        self.parts = tuple(part._replace(lag_s=3 * (_NAN,)) for part in self.parts)
        self.channels = tuple(part._replace(lag_s=3 * (_NAN,)) for part in self.channels)
        self.warnings = (_UNKNOWN_RATE, *self.warnings)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_handle": None}

    def __getitem__(self, name: str) -> ComparedPart:
        """Return the first part of this name."""
        for part in self.parts:
            if part.name == name:
                return part
        raise KeyError(name)

    def to_json(self) -> str:
        """Return the object of schema stltsa-comparison/1, like ``stltsa compare --json``."""
        return self._json

    def report(self, path: str | os.PathLike[str], *, command: str | None = None) -> None:
        """Write a report: one HTML page that a browser shows without a network.

        It has both mean cycles as moving bodies, the largest differences with their intervals, the
        curves of each part with their spread, tables, and warnings.

        Parameters
        ----------
        path : path
            The page, which is written completely or not at all.
        command : str, optional
            The command or call that repeats it, which the page shows.

        Raises
        ------
        stltsa.FileError
            The file cannot be written.
        ValueError
            The comparison was pickled, which keeps only its numbers; or a frame rate is unknown.
        """
        if self._handle is None:
            raise ValueError("a comparison that was pickled cannot write a report: compare again")
        if not self._timed:
            raise ValueError("a report is in seconds, and a frame rate is unknown: give fps=")
        text = _NULL if command is None else ffi.new("char[]", command.encode())
        check(lib.stltsa_comparison_report_save(self._handle, text, c_path(path)))

    def to_frame(self) -> DataFrame:
        """Return one row per part and channel; needs pandas."""
        table = frame([], ComparedPart)  # says what to install
        rows = [each._flat() for each in (*self.parts, *self.channels)]
        return type(table)(rows)

    def __repr__(self) -> str:
        first, second = self.counts
        return (
            f"<Comparison: {first} and {second} cycles, {len(self.parts)} parts, "
            f"{self.significant} of {self.judged} differences significant>"
        )


def _difference(raw: Any) -> Difference:
    values = [getattr(raw, field) for field in Difference._fields[:-1]]
    return Difference._make([*values, bool(raw.significant)])


def _part(handle: Any, raw: Any, axis: str) -> ComparedPart:
    return ComparedPart(
        string(lib.stltsa_comparison_part_name(handle, 0, raw.part)),
        string(lib.stltsa_comparison_part_name(handle, 1, raw.part)),
        axis,
        raw.rms,
        raw.chance,
        raw.correlation,
        _difference(raw.lag),
        _difference(raw.amplitude),
        (raw.ratio, raw.ratio_low, raw.ratio_high),
        (raw.lag_s, raw.lag_low_s, raw.lag_high_s),
        _difference(raw.mean),
    )


def _raw() -> Any:
    return ffi.new("stltsa_compared_part *", {"size": ffi.sizeof("stltsa_compared_part")})


def _parts(handle: Any) -> tuple[ComparedPart, ...]:
    raw, parts = _raw(), []
    for index in range(lib.stltsa_comparison_part_count(handle)):
        check(lib.stltsa_comparison_part(handle, index, raw))
        parts.append(_part(handle, raw, ""))
    return tuple(parts)


def _channels(handle: Any) -> tuple[ComparedPart, ...]:
    raw, channels = _raw(), []
    for index in range(lib.stltsa_comparison_channel_count(handle)):
        check(lib.stltsa_comparison_channel(handle, index, raw))
        axis = string(lib.stltsa_comparison_channel_axis(handle, index))
        channels.append(_part(handle, raw, axis))
    return tuple(channels)


def _curves(handle: Any, which: int, output: int, shape: tuple[int, int]) -> FloatArray:
    values, outputs = columns(*shape), [_NULL, _NULL]
    outputs[output] = write_to(values)
    check(lib.stltsa_comparison_curves(handle, which, *outputs))
    return values


def _left_out(handle: Any, which: int) -> tuple[str, ...]:
    count = lib.stltsa_comparison_left_out_count(handle, which)
    return tuple(string(lib.stltsa_comparison_left_out(handle, which, i)) for i in range(count))
