# SPDX-License-Identifier: BSD-3-Clause
"""Fig. 3 of the paper: the coordinate over time, cut into units and cycles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._colors import FAINT, FAR_LIMB, INK
from .._given import expect
from ..decomposition import Decomposition
from ._postures import FAR, SideView
from ._style import (
    COLUMN,
    CURVE,
    DASHES,
    MANY,
    THIN,
    axes_to_draw_in,
    color_of,
    drawn_values,
    is_dense,
    label_kinds,
    legend_above,
    seconds,
    singled_out,
    span,
    time_label,
    unit_slices,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._arrays import FloatArray, IntArray

_POSTURE = 29.0  # points: the height of the tallest stick figure
_NUMBER = 18.0  # points: room for the number of a frame
_ROOM = 0.46  # share of the axes' height for the curve, between the two rows of postures
_PADDING = 0.05  # share of the curve's height between it and the postures


def _envelope(axes: Any, time: FloatArray, curve: FloatArray, part: float, color: str) -> bool:
    """Draw the range of the curve in each part of the time; return False if there are too few."""
    parts = int((time[-1] - time[0]) / part) if len(time) else 0
    if parts < 3:
        return False
    edges = np.arange(parts) * len(curve) // parts
    middle = np.add.reduceat(time, edges) / np.diff([*edges, len(time)])
    middle[[0, -1]] = time[[0, -1]]
    low, high = np.minimum.reduceat(curve, edges), np.maximum.reduceat(curve, edges)
    axes.fill_between(middle, low, high, color=color, alpha=0.45, linewidth=MANY)
    return True


def _draw_curve(axes: Any, result: Decomposition, time: FloatArray, postures: bool) -> FloatArray:
    from matplotlib.ticker import MaxNLocator

    curve, _ = drawn_values(result)
    cycles = [np.diff(span(result, cycle))[0] for cycle in result.cycle_list]
    part = float(np.mean(cycles)) if cycles else time[-1] / 160
    for unit, at in unit_slices(result):
        color = color_of(unit.kind)
        axes.axvspan(*span(result, unit), color=color, alpha=0.13, linewidth=0)
        known = np.isfinite(curve[at])
        if not is_dense(result) or not _envelope(
            axes, time[at][known], curve[at][known], part, color
        ):
            axes.plot(time[at], curve[at], color=color, linewidth=CURVE)
    known = np.isfinite(curve)
    low, high = (curve[known].min(), curve[known].max()) if known.any() else (-1.0, 1.0)
    share = _ROOM if postures else 0.9
    room = 0.5 * ((high - low) or 1.0) * (1 / share - 1)
    axes.set_ylim(low - room, high + room)
    axes.set_yticks([t for t in MaxNLocator(4).tick_values(low, high) if low <= t <= high])
    return np.where(known, curve, 0.5 * (low + high))


def _draw_cycles(axes: Any, result: Decomposition, level: FloatArray, postures: bool) -> None:
    chosen = singled_out(result)
    color = color_of("cycle")
    if chosen:
        axes.axvspan(*span(result, chosen), color=color, alpha=0.12, linewidth=0)
    if is_dense(result):
        return
    spans = [span(result, cycle) for cycle in result.cycle_list]
    # Margins end where the postures begin, so that no number lies on a line.
    low, high = axes.get_ylim()
    if postures:
        air = _PADDING * np.ptp(level)
        low, high = level.min() - air, level.max() + air
    for edge in sorted({edge for ends in spans for edge in ends}):
        axes.plot([edge, edge], [low, high], color=color, linewidth=THIN, linestyle=DASHES)
    for number, (begin, end) in enumerate(spans, 1):
        if len(spans) > 20:
            break
        axes.annotate(
            f"cycle {number}" if len(spans) <= 4 else f"{number}",
            (0.5 * (begin + end), 1.0),
            xycoords=axes.get_xaxis_transform(),
            xytext=(0, 1.5),
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize="small",
            color=color,
        )


def _stick_figure(view: SideView, frame: int) -> Any:
    from matplotlib.lines import Line2D
    from matplotlib.offsetbox import DrawingArea
    from matplotlib.patches import Circle

    size = _POSTURE / view.tallest
    points = view.posture(frame) * size
    head = view.middle_of_head(frame)
    left, width = points[:, 0].min(), np.ptp(points[:, 0])
    area = DrawingArea(width, float(points[:, 1].max()) + size * view.radius, 0, 0)
    for far in (True, False):
        for bone, depth in zip(view.bones, view.depth, strict=True):
            if (depth == FAR) == far:
                line = points[list(bone)]
                area.add_artist(
                    Line2D(
                        line[:, 0] - left,
                        line[:, 1],
                        color=FAR_LIMB if far else INK,
                        linewidth=0.85 * CURVE,
                        solid_capstyle="round",
                    )
                )
    if head is not None:
        x, y = head * size
        area.add_artist(Circle((x - left, y), size * view.radius, color=INK, linewidth=0))
    return area


def _spread(x: FloatArray, low: float, high: float, room: float) -> FloatArray:
    """Move ascending places so that they are `room` apart and inside the axes."""
    steps = room * np.arange(len(x))
    placed = np.maximum.accumulate(np.maximum(x - steps, low + 0.5 * room)) + steps
    back = steps[::-1]
    ends = np.minimum.accumulate(np.minimum(placed + back, high - 0.5 * room)[::-1])[::-1]
    return np.asarray(ends - back)


def _draw_postures(
    axes: Any, result: Decomposition, curve: FloatArray, chosen: IntArray, time: FloatArray
) -> None:
    from matplotlib.offsetbox import AnnotationBbox, TextArea, VPacker

    view = SideView(result.clip)
    at = chosen * seconds(result)
    end = len(result.clip) * seconds(result)
    x = at.astype(np.float64)
    figures = [_stick_figure(view, frame) for frame in chosen]
    points = axes.bbox.width / axes.figure.dpi * 72
    room = end / points * max(_NUMBER, *(figure.width + 3 for figure in figures))
    for row in (0, 1):
        x[row::2] = _spread(x[row::2], 0, end, min(room, 2 * end / (len(chosen) + 1)))
    for place, (frame, figure) in enumerate(zip(chosen, figures, strict=True)):
        above = place % 2 == 0
        number = TextArea(f"{frame}", textprops={"fontsize": "small", "color": INK})
        parts = [number, figure] if above else [figure, number]
        dot = at[place], np.interp(at[place], time, curve)
        axes.add_artist(
            AnnotationBbox(
                VPacker(children=parts, align="center", pad=0, sep=1),
                dot,
                xybox=(x[place], 0.99 if above else 0.01),
                boxcoords=axes.get_xaxis_transform(),
                box_alignment=(0.5, 1.0 if above else 0.0),
                frameon=False,
                pad=0.0,
                arrowprops={
                    "arrowstyle": "-",
                    "color": FAINT,
                    "linewidth": 0.75 * THIN,
                    "shrinkB": 1.5,
                },
            )
        )
        axes.plot(
            *dot,
            "o",
            color="white",
            markeredgecolor=INK,
            markersize=2.6,
            markeredgewidth=0.6,
            zorder=4,
        )


def units(result: Decomposition, *, ax: Axes | None = None, postures: int | None = None) -> Axes:
    """Draw the coordinate over time with units, cycles and postures (the paper's Fig. 3).

    With more than 40 cycles or 6000 samples, the curve is an envelope: the range of each cycle.
    There is no curve where nothing was fitted.

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.
    postures : int, optional
        Number of stick figures with frame numbers, at most 24. Their postures differ as much as
        possible. Default: 11 if the clip has a skeleton, otherwise none.

    Returns
    -------
    matplotlib Axes
    """
    result = expect(result, Decomposition, "stltsa.plot.units", "stltsa.decompose")
    time = np.asarray(result.frames * seconds(result), dtype=np.float64)
    if postures is None:
        postures = 11 if result.clip.joints else 0
    with axes_to_draw_in(ax, 0.92 * COLUMN) as axes:
        level = _draw_curve(axes, result, time, postures > 0)
        _draw_cycles(axes, result, level, postures > 0)
        if postures:
            chosen = np.sort(np.array(result.facts["postures"][:postures], dtype=np.int64))
            _draw_postures(axes, result, level, chosen, time)
        axes.set_xlim(0, len(result.clip) * seconds(result))
        axes.set_xlabel(time_label(result.clip.fps))
        axes.set_ylabel("motion coordinate")
        label_kinds(axes, result)
        legend_above(axes, 1.06)
    drawn: Axes = axes
    return drawn
