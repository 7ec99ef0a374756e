# SPDX-License-Identifier: BSD-3-Clause
"""Fig. 1 of the paper: the motion as a loop."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._colors import INK, UNIT_COLORS
from .._given import expect
from ..decomposition import Decomposition
from ._style import COLUMN, axes_to_draw_in, legend_of_kinds, unit_slices

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._arrays import FloatArray

# As shares of the loop's larger side: the distance of a number from its point, and its size.
_AWAY = 0.05
_ROOM = np.array([0.1, 0.05])


def _numbered(loop: FloatArray, count: int) -> list[int]:
    """Choose samples, evenly spaced in time, whose numbers do not overlap."""
    size = np.ptp(loop, axis=0).max() or 1.0
    chosen: list[int] = []
    taken: list[FloatArray] = []
    for i in np.linspace(0, len(loop) - 1, count).round().astype(int):
        place = loop[i] / size + _AWAY * _outward(loop, i)
        if all((np.abs(place - other) > _ROOM).any() for other in taken):
            chosen.append(int(i))
            taken.append(place)
    return chosen


def _outward(loop: FloatArray, i: int) -> FloatArray:
    """Return the direction away from the inside of the loop, perpendicular to the curve."""
    before, after = loop[max(i - 2, 0)], loop[min(i + 2, len(loop) - 1)]
    way = after - before
    across = np.array([way[1], -way[0]])
    out = loop[i] - loop.mean(axis=0)
    if not across.any():
        across = out
    across = across * (1.0 if across @ out >= 0 else -1.0)
    return np.asarray(across / (np.linalg.norm(across) or 1.0))


def _side(along: float, low: str, high: str) -> str:
    """Return the alignment of a text that lies in a direction from its anchor."""
    return high if along > 0.4 else low if along < -0.4 else "center"


def loop(result: Decomposition, *, ax: Axes | None = None, numbers: int = 24) -> Axes:
    """Draw the two coordinates of the loop, with frame numbers (the paper's Fig. 1).

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.
    numbers : int, default=24
        Largest number of samples with a frame number; numbers that would overlap are left out.

    Returns
    -------
    matplotlib Axes
    """
    from matplotlib import patheffects

    result = expect(result, Decomposition, "stltsa.plot.loop", "stltsa.decompose")
    halo = [patheffects.withStroke(linewidth=1.6, foreground="white")]
    coords, frames = result.loop, result.frames
    with axes_to_draw_in(ax, 0.82 * COLUMN) as axes:
        for unit, at in unit_slices(result):
            axes.plot(
                *coords[at].T,
                color=UNIT_COLORS[unit.kind],
                linewidth=0.9,
                marker="o",
                markersize=1.6,
                label=unit.kind,
            )
        for i in _numbered(coords, numbers):
            axes.plot(*coords[i], "o", color=INK, markersize=2.6, zorder=3)
            x, y = _outward(coords, i)
            axes.annotate(
                f"{frames[i]}",
                coords[i],
                xytext=(3.5 * x, 3.5 * y),
                textcoords="offset points",
                ha=_side(x, "right", "left"),
                va=_side(y, "top", "bottom"),
                color=INK,
                fontsize="small",
                path_effects=halo,
                zorder=4,
            )
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.09)
        axes.set_xlabel("first coordinate of the loop")
        axes.set_ylabel("second coordinate of the loop")
        legend_of_kinds(axes, 1.0)
    drawn: Axes = axes
    return drawn
