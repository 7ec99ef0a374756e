# SPDX-License-Identifier: BSD-3-Clause
"""Style and marks shared by the figures (docs/figures.md)."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from .._colors import UNIT_COLORS

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy.typing as npt
    from matplotlib.axes import Axes

    from .._arrays import FloatArray, IntArray
    from .._rows import Interval, Segment
    from ..decomposition import Decomposition

COLUMN = 88 / 25.4  # inches: the width of a column of most journals

# Widths in points, in the same proportions as in the command's figures.
CURVE, MANY, THIN, WIDE = 1.2, 0.45, 0.6, 2.7
DASHES = (0, (3, 2.5))
MOST_CYCLES = 40  # more are drawn as an envelope
MOST_SAMPLES = 6000

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
def axes_to_draw_in(
    given: Any, height: float, rows: int = 1, ratios: tuple[float, ...] | None = None
) -> Iterator[Any]:
    """Return the caller's axes, or new ones in our style and column width."""
    import matplotlib.pyplot as plt

    if given is not None:
        yield given
        return
    with plt.rc_context(STYLE):
        _, axes = plt.subplots(
            rows,
            1,
            figsize=(COLUMN, height),
            dpi=200,
            sharex=rows > 1,
            height_ratios=ratios,
            layout="constrained",
        )
        yield axes


def seconds(result: Decomposition) -> float:
    """Return the seconds of a frame; 1 if the rate is unknown: time is in frames then."""
    return 1 / (result.clip.fps or 1.0)


def time_label(fps: float | None, unit: str = "frame") -> str:
    """Return the label of the time axis."""
    return "time in seconds" if fps else unit


def span(result: Decomposition, interval: Interval) -> tuple[float, float]:
    """Return begin and end of an interval on the time axis."""
    if result.clip.fps:
        return interval.begin_s, interval.end_s
    return interval.begin, interval.end


def legend_above(axes: Axes, above: float) -> None:
    """Draw a legend above the axes, with one entry for each label."""
    handles, labels = axes.get_legend_handles_labels()
    kinds = dict(zip(labels, handles, strict=True))
    if not kinds:
        return
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


def label_kinds(axes: Axes, result: Decomposition) -> None:
    """Add an entry for each kind of unit to the legend."""
    for kind in dict.fromkeys(unit.kind for unit in result.unit_list):
        axes.plot([], [], color=UNIT_COLORS[kind], linewidth=CURVE, label=kind)


def drawn_values(result: Decomposition) -> tuple[FloatArray, FloatArray]:
    """Return curve and loop, with NaN where they are zero because nothing was fitted."""
    curve, loop = result.curve.copy(), result.loop.copy()
    nothing = (curve == 0) & (loop == 0).all(axis=1)
    curve[nothing], loop[nothing] = np.nan, np.nan
    return curve, loop


def looped_segment(result: Decomposition) -> Segment | None:
    """Return the segment whose loop is drawn, or None if there are fewer than two with cycles.

    Each such segment has coordinates of its own. The one with the representative cycle is drawn
    or, if there is none, the longest.
    """
    cyclic = [segment for segment in result.segment_list if segment.kind == "cyclic"]
    if len(cyclic) < 2:
        return None
    chosen = singled_out(result)
    if chosen is not None:
        return next(segment for segment in cyclic if segment.begin <= chosen.begin < segment.end)
    return max(cyclic, key=lambda segment: segment.end - segment.begin)


def singled_out(result: Decomposition) -> Interval | None:
    """Return the representative cycle, or None if there are fewer than three cycles."""
    return result.representative_cycle if len(result.cycle_list) > 2 else None


def is_dense(result: Decomposition) -> bool:
    """Return whether there are too many cycles to draw them side by side."""
    return len(result.cycle_list) > MOST_CYCLES or len(result.frames) > MOST_SAMPLES


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


def color_of(kind: str) -> str:
    """Return the color of a kind of unit."""
    return UNIT_COLORS[kind]


def smooth_path(points: FloatArray) -> Any:
    """Return a smooth path through points (a Catmull-Rom spline); NaN breaks it."""
    from matplotlib.path import Path

    vertices: list[FloatArray] = []
    codes: list[Any] = []
    real = np.asarray(np.isfinite(points).all(axis=1))
    for part in np.split(np.arange(len(points)), np.flatnonzero(np.diff(real)) + 1):
        p = points[part]
        if len(p) < 2 or not real[part[0]]:
            continue
        tangents = np.concatenate([p[1:2] - p[:1], p[2:] - p[:-2], p[-1:] - p[-2:-1]]) / 6
        tangents = tangents.reshape(len(p), 2)
        curves = np.stack([p[:-1] + tangents[:-1], p[1:] - tangents[1:], p[1:]], axis=1)
        vertices += [p[:1], curves.reshape(-1, 2)]
        codes += [Path.MOVETO] + [Path.CURVE4] * (3 * (len(p) - 1))
    return Path(np.concatenate(vertices), codes) if vertices else Path(np.empty((0, 2)))
