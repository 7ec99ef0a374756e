# SPDX-License-Identifier: BSD-3-Clause
"""Fig. 3 of the paper: the coordinate over time, cut into units and cycles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._colors import FAINT, INK, UNIT_COLORS
from .._given import expect
from ..decomposition import Decomposition
from ._postures import SideView
from ._style import (
    COLUMN,
    axes_to_draw_in,
    legend_of_kinds,
    seconds,
    span,
    time_label,
    unit_slices,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._arrays import FloatArray

_POSTURE = 29.0  # points: the height of a stick figure
_ROOM = 0.46  # share of the axes' height for the curve, between the two rows of postures


def _draw_curve(axes: Any, result: Decomposition, time: FloatArray) -> None:
    from matplotlib.ticker import MaxNLocator

    curve = result.curve
    for unit, at in unit_slices(result):
        color = UNIT_COLORS[unit.kind]
        axes.axvspan(*span(result, unit), color=color, alpha=0.13, linewidth=0)
        axes.plot(time[at], curve[at], color=color, linewidth=1.3, label=unit.kind)
    low, high = curve.min(), curve.max()
    room = 0.5 * ((high - low) or 1.0) * (1 / _ROOM - 1)
    axes.set_ylim(low - room, high + room)
    axes.set_yticks([t for t in MaxNLocator(4).tick_values(low, high) if low <= t <= high])


def _draw_cycles(axes: Any, result: Decomposition) -> None:
    spans = [span(result, cycle) for cycle in result.cycle_list]
    for edge in [begin for begin, _ in spans] + [end for _, end in spans[-1:]]:
        axes.axvline(edge, color=UNIT_COLORS["cycle"], linewidth=0.7, linestyle=(0, (3, 2)))
    for number, (begin, end) in enumerate(spans, 1):
        shown = f"cycle {number}" if len(spans) <= 4 else f"{number}"
        axes.annotate(
            shown,
            (0.5 * (begin + end), 1.0),
            xycoords=axes.get_xaxis_transform(),
            xytext=(0, 1.5),
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize="small",
            color=UNIT_COLORS["cycle"],
        )


def _stick_figure(view: SideView, frame: int) -> Any:
    from matplotlib.lines import Line2D
    from matplotlib.offsetbox import DrawingArea

    bones = view.posture(frame)
    points = np.concatenate(bones) * _POSTURE
    left, width = points[:, 0].min(), np.ptp(points[:, 0])
    area = DrawingArea(width, _POSTURE, 0, 0)
    for near in (False, True):
        for bone in (b for b, far in zip(bones, view.far, strict=True) if far != near):
            area.add_artist(
                Line2D(
                    bone[:, 0] * _POSTURE - left,
                    bone[:, 1] * _POSTURE,
                    color=INK if near else FAINT,
                    linewidth=0.9,
                    solid_capstyle="round",
                )
            )
    return area


def _draw_postures(axes: Any, result: Decomposition, time: FloatArray, count: int) -> None:
    from matplotlib.offsetbox import AnnotationBbox, TextArea, VPacker

    view, curve, frames = SideView(result.clip), result.curve, result.frames
    samples = (np.arange(count) + 0.5) / count * len(frames)
    for place, i in enumerate(samples.astype(int)):
        above = place % 2 == 0
        number = TextArea(f"{frames[i]}", textprops={"fontsize": "small", "color": INK})
        figure = _stick_figure(view, frames[i])
        parts = [number, figure] if above else [figure, number]
        axes.add_artist(
            AnnotationBbox(
                VPacker(children=parts, align="center", pad=0, sep=1),
                (time[i], curve[i]),
                xybox=(time[i], 0.99 if above else 0.01),
                boxcoords=axes.get_xaxis_transform(),
                box_alignment=(0.5, 1.0 if above else 0.0),
                frameon=False,
                pad=0.0,
                arrowprops={"arrowstyle": "-", "color": FAINT, "linewidth": 0.5, "shrinkB": 1.5},
            )
        )
        axes.plot(
            time[i],
            curve[i],
            "o",
            color="white",
            markeredgecolor=INK,
            markersize=2.6,
            markeredgewidth=0.6,
            zorder=4,
        )


def units(result: Decomposition, *, ax: Axes | None = None, postures: int | None = None) -> Axes:
    """Draw the coordinate over time with units, cycles and postures (the paper's Fig. 3).

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.
    postures : int, optional
        Number of stick figures, evenly spaced in time, with their frame numbers; by default 11 if
        the clip has a skeleton, otherwise none.

    Returns
    -------
    matplotlib Axes
    """
    result = expect(result, Decomposition, "stltsa.plot.units", "stltsa.decompose")
    time = np.asarray(result.frames * seconds(result), dtype=np.float64)
    if postures is None:
        postures = 11 if result.clip.joints else 0
    with axes_to_draw_in(ax, 0.92 * COLUMN) as axes:
        _draw_curve(axes, result, time)
        _draw_cycles(axes, result)
        if postures:
            _draw_postures(axes, result, time, postures)
        axes.set_xlim(0, len(result.clip) * seconds(result))
        axes.set_xlabel(time_label(result))
        axes.set_ylabel(f"coordinate {result.facts['coordinate']}")
        legend_of_kinds(axes, 1.06)
    drawn: Axes = axes
    return drawn
