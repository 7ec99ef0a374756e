# SPDX-License-Identifier: BSD-3-Clause
"""The curves of all cycles, overlaid on 0 to 100 %, and how long each cycle lasts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._given import expect
from ..decomposition import Decomposition
from ..phase import cycles_between
from ._style import (
    COLUMN,
    CURVE,
    MANY,
    THIN,
    axes_to_draw_in,
    color_of,
    drawn_values,
    legend_above,
    singled_out,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._rows import Interval

_MOST_LINES = 60


def cycles(result: Decomposition, *, ax: Axes | None = None) -> Axes:
    """Draw the curve of each cycle on 0 to 100 %, with mean and standard deviation.

    The cycles are the representative one or, if no curve was fitted there, the first one with a
    curve, and those of its segment that follow one another before and after it; of more than 60,
    60 are drawn.

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`, with cycles.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValueError
        There are no cycles.
    """
    result = expect(result, Decomposition, "stltsa.plot.cycles", "stltsa.decompose")
    _needs_cycles(result, "stltsa.plot.cycles")
    found = _run_around(result, _enlarged(result))
    first, step = int(result.frames[0]), int(result.facts["frame_step"][0])
    borders = [found[0].begin, *(cycle.end for cycle in found)]
    in_samples = (np.array(borders, dtype=np.float64) - first) / step
    curve = result.curve
    overlaid = cycles_between(np.clip(in_samples, 0, len(curve)), curve)
    percent = np.linspace(0, 100, len(overlaid.mean))
    color = color_of("cycle")
    each = overlaid.each[:, :, 0]
    shown = each[np.arange(min(len(each), _MOST_LINES)) * len(each) // min(len(each), _MOST_LINES)]
    mean, sd = overlaid.mean[:, 0], overlaid.sd[:, 0]
    with axes_to_draw_in(ax, 0.6 * COLUMN) as axes:
        for line in shown:
            axes.plot(percent, line, color=color, linewidth=MANY, alpha=0.25, label="one cycle")
        if len(each) > 1:
            axes.fill_between(
                percent,
                mean - sd,
                mean + sd,
                color=color,
                alpha=0.25,
                linewidth=0,
                label="standard deviation",
            )
        axes.plot(percent, mean, color=color, linewidth=CURVE, label="mean")
        axes.set_xlim(0, 100)
        axes.set_xlabel("share of the cycle in %")
        axes.set_ylabel("motion coordinate")
        legend_above(axes, 1.0)
    drawn: Axes = axes
    return drawn


def _needs_cycles(result: Decomposition, caller: str) -> None:
    if not result.cycle_list:
        raise ValueError(f"{caller}: there are no cycles: {result.reason or 'nothing cycles'}")


def _run_around(result: Decomposition, index: int) -> tuple[Interval, ...]:
    """Return the cycles of a segment that follow one another, this one among them."""
    segments, every = np.asarray(result.cycle_facts["segment"]), result.cycle_list

    def continues(i: int) -> bool:
        return bool(segments[i] == segments[i - 1] and every[i].begin == every[i - 1].end)

    first = last = index
    while first > 0 and continues(first):
        first -= 1
    while last + 1 < len(every) and continues(last + 1):
        last += 1
    return every[first : last + 1]


def _enlarged(result: Decomposition) -> int:
    """Return the index of the representative cycle or, if it has no curve, the first that has."""
    curve, _ = drawn_values(result)
    places = np.array([(cycle.begin + cycle.end) // 2 for cycle in result.cycle_list])
    first, step = int(result.frames[0]), int(result.facts["frame_step"][0])
    known = np.isfinite(curve[np.clip((places - first) // step, 0, len(curve) - 1)])
    representative = int(result.facts["representative"])
    return representative if representative >= 0 and known[representative] else int(known.argmax())


def cycle_times(result: Decomposition, *, ax: Axes | None = None) -> Axes:
    """Draw how long each cycle lasts; of three or more, the representative one is filled.

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`, with cycles.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValueError
        There are no cycles.
    """
    from matplotlib.ticker import MaxNLocator

    result = expect(result, Decomposition, "stltsa.plot.cycle_times", "stltsa.decompose")
    _needs_cycles(result, "stltsa.plot.cycle_times")
    timed = bool(result.clip.fps)
    found = result.cycle_list
    lengths = [c.duration_s if timed else c.end - c.begin for c in found]
    chosen = [c == singled_out(result) for c in found]
    color = color_of("cycle")
    with axes_to_draw_in(ax, 0.45 * COLUMN) as axes:
        axes.scatter(
            range(1, len(found) + 1),
            lengths,
            s=9,
            facecolors=[color if filled else "white" for filled in chosen],
            edgecolors=color,
            linewidths=THIN,
            zorder=3,
        )
        low, high = min(lengths), max(lengths)
        # Equal cycles are a level line, not magnified rounding.
        room = max(0.05 * high, 1.1 * (high - low))
        axes.set_ylim(0.5 * (low + high - room), 0.5 * (low + high + room))
        axes.xaxis.set_major_locator(MaxNLocator(10, integer=True))
        axes.set_xlabel("number of the cycle")
        axes.set_ylabel("cycle time in seconds" if timed else "cycle time in frames")
    drawn: Axes = axes
    return drawn
