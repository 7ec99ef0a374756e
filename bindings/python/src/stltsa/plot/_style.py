# SPDX-License-Identifier: BSD-3-Clause
"""Style shared by the figures."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy as np
    import numpy.typing as npt
    from matplotlib.axes import Axes

    from .._arrays import IntArray
    from .._rows import Interval
    from ..decomposition import Decomposition

COLUMN = 88 / 25.4  # inches: the width of a column of most journals

STYLE: dict[Any, Any] = {
    "font.size": 7.0,
    "axes.labelsize": 7.0,
    "axes.titlesize": 7.5,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.labelsize": 6.5,
    "ytick.labelsize": 6.5,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "legend.fontsize": 6.5,
    "legend.frameon": False,
    "svg.fonttype": "none",
}


@contextmanager
def axes_to_draw_in(given: Any, height: float, count: int = 1) -> Iterator[Any]:
    """Return the caller's axes, or new ones in our style and column width."""
    import matplotlib.pyplot as plt

    if given is not None:
        yield given
        return
    with plt.rc_context(STYLE):
        _, axes = plt.subplots(
            1, count, figsize=(COLUMN, height), dpi=200, sharey=True, layout="constrained"
        )
        yield axes


def seconds(result: Decomposition) -> float:
    """Return the seconds of a frame; 1 if the rate is unknown: time is in frames then."""
    return 1 / (result.clip.fps or 1.0)


def time_label(result: Decomposition) -> str:
    """Return the label of the time axis."""
    return "time in seconds" if result.clip.fps else "frame"


def span(result: Decomposition, interval: Interval) -> tuple[float, float]:
    """Return begin and end of an interval on the time axis."""
    if result.clip.fps:
        return interval.begin_s, interval.end_s
    return interval.begin, interval.end


def legend_of_kinds(axes: Axes, above: float) -> None:
    """Draw a legend above the axes, with one entry for each kind of unit."""
    handles, labels = axes.get_legend_handles_labels()
    kinds = dict(zip(labels, handles, strict=True))
    axes.legend(
        kinds.values(),
        kinds.keys(),
        loc="lower center",
        bbox_to_anchor=(0.5, above),
        ncols=5,
        columnspacing=0.9,
        handlelength=1.0,
        handletextpad=0.4,
        borderaxespad=0.1,
    )


def unit_slices(result: Decomposition) -> list[tuple[Interval, slice]]:
    """Return the samples of each unit plus the first of the next, so that lines meet."""
    frames = result.frames
    found = []
    for unit in result.unit_list:
        inside: IntArray | npt.NDArray[np.bool_] = (frames >= unit.begin) & (frames < unit.end)
        (at,) = inside.nonzero()
        if len(at):
            found.append((unit, slice(at[0], min(at[-1] + 2, len(frames)))))
    return found
