# SPDX-License-Identifier: BSD-3-Clause
"""The cycles of two motions, aligned by phase."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._call import Call
from ._facts import Described
from ._native import ffi, lib
from ._rows import Compared, ComparedMotion, ComparedPart
from ._tables import frame
from ._text import c_path, c_text

if TYPE_CHECKING:
    import os

    from pandas import DataFrame

_UNKNOWN_RATE = (
    "a frame rate is unknown: times are NaN, and times in the JSON assume 30 frames per second; "
    "give fps="
)


class Comparison(Described):
    """The differences between the cycles of two motions, and how precisely they are known.

    Attributes
    ----------
    whole : Compared
        The comparison as a whole: shift, likeness, cycle time, number of significant differences.
    motions : tuple of two ComparedMotion
        The two motions.
    parts, channels : tuple of ComparedPart
        Joints, points or columns; and their coordinates, part by part.
    mean, sd : tuple of two ndarrays of shape (samples, channels)
        Mean cycles of both motions, and standard deviations between cycles.
    difference, standard_error, margin : ndarray of shape (samples, channels)
        Second minus first at each sample, its standard error, and half the width of its interval.
    """

    _kind = "comparison"

    def __init__(self, handle: Any, *, timed: bool = True) -> None:
        super().__init__(handle, timed=timed)
        self.whole: Compared = self._list("comparison")[0]
        self.motions: tuple[ComparedMotion, ...] = self._list("motion")
        self.parts: tuple[ComparedPart, ...] = self._list("part")
        self.channels: tuple[ComparedPart, ...] = self._list("part_channel")
        self.mean = tuple(self._array("mean", motion) for motion in (0, 1))
        self.sd = tuple(self._array("deviation", motion) for motion in (0, 1))
        self.difference = self._array("difference")
        self.standard_error = self._array("standard_error")
        self.margin = self._array("margin")
        self._warnings = (*[_UNKNOWN_RATE] * (not timed), *super().warnings)
        self._json = super().to_json()

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a user should know about the result."""
        return self._warnings

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_handle": None}

    def __getitem__(self, name: str) -> ComparedPart:
        """Return the first part of this name."""
        for part in self.parts:
            if part.first == name:
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
        text = ffi.NULL if command is None else c_text(command, "command")
        with Call() as call:
            given = self._handle, call.options, text, c_path(path)
            call.check(lib.stltsa_comparison_report_save(*given))

    def to_frame(self) -> DataFrame:
        """Return one row per part and channel; needs pandas."""
        return frame((*self.parts, *self.channels), ComparedPart)

    def __repr__(self) -> str:
        first, second = (motion.cycles for motion in self.motions)
        return (
            f"<Comparison: {first} and {second} cycles, {len(self.parts)} parts, "
            f"{self.whole.significant} of {self.whole.judged} differences significant>"
        )
