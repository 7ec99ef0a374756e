# SPDX-License-Identifier: BSD-3-Clause
"""Axes for papers and notebooks; needs Matplotlib.

:func:`units`
    The coordinate over time, cut into units and cycles (the paper's Fig. 3).
:func:`loop`
    The motion as a loop in two coordinates, with start, direction and frame numbers (Fig. 1).
:func:`cycles`
    The curves of all cycles on 0 to 100 %, with mean and standard deviation.

Each draws into `ax`, or into a new figure that is legible in a column of a paper (88 mm wide).
Color-blind readers can distinguish the colors, and no information is in colors alone. All three in
one figure, with postures and without Matplotlib: ``result.report("walk.svg")``.

Examples
--------
>>> import stltsa
>>> result = stltsa.decompose("walker.bvh")
>>> ax = stltsa.plot.units(result)
>>> ax.get_xlabel()
'time in seconds'
"""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from ._colors import INK, UNIT_COLORS
from ._given import expect
from .decomposition import Decomposition

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes

    from ._arrays import FloatArray
    from ._rows import Part, Segment, Unit

__all__ = ["cycles", "loop", "units"]

_COLUMN = 88 / 25.4  # inches: the width of a column of most journals
_CURVE, _MANY, _THIN, _WIDE = 1.2, 0.45, 0.6, 2.7  # points
_CYCLE = UNIT_COLORS["cycle"]
_PARTS = 8  # of a smooth line between two samples
_MOST_CYCLES, _MOST_LINES, _MOST_NUMBERS = 40, 60, 20

_STYLE: dict[Any, Any] = {
    "font.size": 7.0,
    "axes.labelsize": 7.0,
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
def _axes_to_draw_in(given: Any, height: float) -> Iterator[Any]:
    """Return the caller's axes, or new ones in our style and column width."""
    import matplotlib.pyplot as plt

    if given is not None:
        yield given
        return
    with plt.rc_context(_STYLE):
        size = (_COLUMN, height)
        yield plt.subplots(figsize=size, dpi=200, layout="constrained")[1]


def _span(result: Decomposition, interval: Part | Unit) -> tuple[float, float]:
    """Return begin and end on the time axis, which counts frames if the rate is unknown."""
    if result.clip.fps:
        return interval.begin_s, interval.end_s
    return interval.begin, interval.end


def _legend_above(axes: Axes, above: float) -> None:
    """Draw a legend above the axes, with one entry for each label."""
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


def _checked(result: Decomposition, name: str, *, cycles: bool = True) -> Decomposition:
    """Return the result of a decomposition, which may have to have cycles."""
    result = expect(result, Decomposition, f"stltsa.plot.{name}", "stltsa.decompose")
    if cycles and not result.cycle_list:
        why = result.reason or "nothing cycles"
        raise ValueError(f"stltsa.plot.{name}: there are no cycles: {why}")
    return result


def _drawn_values(result: Decomposition) -> FloatArray:
    """Return curve and loop in three columns, with NaN where nothing was fitted."""
    values = np.column_stack([result.curve, result.coords])
    values[(values == 0).all(axis=1)] = np.nan
    return values


def _representative(result: Decomposition) -> Part:
    """Return the representative cycle of a result with cycles."""
    return result.cycle_list[result._int("representative")]


def _looped(result: Decomposition) -> Segment:
    """Return the segment of the representative cycle."""
    return result.segment_list[_representative(result).segment]


def _shown_samples(result: Decomposition) -> slice:
    """Return the samples that one curve connects to the middle of the representative cycle.

    Another curve, of its segment or of the next, has other coordinates.
    """
    cycle = _representative(result)
    segment, frames = _looped(result), result.frames
    known = np.isfinite(_drawn_values(result)[:, 0])
    gaps = np.flatnonzero(~known | (frames < segment.begin) | (frames > segment.end))
    middle = np.searchsorted(frames, (cycle.begin + cycle.end) // 2)
    begin = gaps[gaps < middle].max(initial=-1) + 1
    return slice(begin, gaps[gaps >= middle].min(initial=len(frames)))


def _singled_out(result: Decomposition) -> Part | None:
    """Return the representative cycle, or None if there are fewer than three cycles."""
    return result.representative_cycle if len(result.cycle_list) > 2 else None


def _is_dense(result: Decomposition) -> bool:
    """Return whether there are too many cycles to tell them apart."""
    return len(result.cycle_list) > _MOST_CYCLES


def _unit_slices(result: Decomposition) -> list[tuple[Unit, slice]]:
    """Return the samples of each unit plus the first of the next, so that lines meet."""
    found = []
    for unit in result.unit_list:
        begin, end = np.searchsorted(result.frames, [unit.begin, unit.end])
        found.append((unit, slice(begin, end + 1)))
    return found


def units(result: Decomposition, *, ax: Axes | None = None) -> Axes:
    """Draw the coordinate over time with units and cycles (the paper's Fig. 3).

    There is no curve where nothing was fitted. With three or more cycles, the representative one
    has a darker band.

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.

    Returns
    -------
    matplotlib Axes
    """
    result = _checked(result, "units", cycles=False)
    fps = result.clip.fps or 1.0
    curve, time = _drawn_values(result)[:, 0], result.frames / fps
    chosen, dense = _singled_out(result), _is_dense(result)
    with _axes_to_draw_in(ax, 0.6 * _COLUMN) as axes:
        for unit, at in _unit_slices(result):
            color = UNIT_COLORS[unit.kind]
            axes.axvspan(*_span(result, unit), color=color, alpha=0.13, linewidth=0)
            width = _MANY if dense else _CURVE
            axes.plot(time[at], curve[at], color=color, linewidth=width, label=unit.kind)
        if chosen:
            axes.axvspan(*_span(result, chosen), color=_CYCLE, alpha=0.12, linewidth=0)
        edges = {edge for cycle in result.cycle_list for edge in _span(result, cycle)}
        for edge in () if dense else sorted(edges):
            axes.axvline(edge, color=_CYCLE, linewidth=_THIN, linestyle=(0, (3, 2.5)))
        for number, cycle in enumerate(result.cycle_list, 1):
            if len(result.cycle_list) <= _MOST_NUMBERS:
                axes.annotate(
                    f"cycle {number}" if len(result.cycle_list) <= 4 else f"{number}",
                    (np.mean(_span(result, cycle)), 1.0),
                    xycoords=axes.get_xaxis_transform(),
                    xytext=(0, 1.5),
                    textcoords="offset points",
                    ha="center",
                    va="bottom",
                    fontsize="small",
                    color=_CYCLE,
                )
        axes.set_xlim(0, len(result.clip) / fps)
        axes.set_xlabel("time in seconds" if result.clip.fps else "frame")
        axes.set_ylabel("motion coordinate")
        _legend_above(axes, 1.08)
    drawn: Axes = axes
    return drawn


def _smooth(points: FloatArray) -> FloatArray:
    """Return points of a smooth line through points (a Catmull-Rom spline)."""
    p = np.pad(points, ((1, 1), (0, 0)), mode="edge")
    a, b, c, d = p[:-3], p[1:-2], p[2:-1], p[3:]
    t = (np.arange(_PARTS) / _PARTS)[:, None, None]
    line = b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
    return np.concatenate([line.swapaxes(0, 1).reshape(-1, 2), points[-1:]])


def _draw_arrows(axes: Any, line: FloatArray) -> None:
    """Draw three arrowheads along a line."""
    passed = np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum()
    for share in (1 / 6, 3 / 6, 5 / 6):
        i = int(np.searchsorted(passed, share * passed[-1]))
        style = "-|>,head_length=0.5,head_width=0.25"
        arrow = {"arrowstyle": style, "color": INK, "linewidth": 0, "mutation_scale": 9}
        axes.annotate("", line[i + 1], line[max(i - _PARTS, 0)], arrowprops=arrow, zorder=4)


def _write(axes: Any, line: FloatArray, texts: list[tuple[str, FloatArray, str]]) -> None:
    """Write texts beside their points, where they cover neither lines nor each other.

    Texts without room are left out. The axes must have their final limits.
    """
    from matplotlib.transforms import Bbox

    axes.figure.draw_without_rendering()
    pixels = axes.figure.dpi / 72
    on_line = axes.transData.transform(line)
    size = 0.85 * float(axes.xaxis.label.get_size())
    taken: list[Bbox] = []
    directions = np.exp(1j * np.pi / 4 * np.arange(8))
    for text, point, color in texts:
        x, y = axes.transData.transform(point)
        outward = complex(x, y) - complex(*on_line.mean(axis=0))
        width, height = np.array([0.68 * len(text), 1.25]) * size * pixels
        order = np.argsort(-(directions * np.conj(outward)).real, kind="stable")
        for away, turn in ((away, turn) for away in (3.5, 7.0) for turn in directions[order]):
            dx = turn.real * (away * pixels + width / 2)
            dy = turn.imag * (away * pixels + height / 2)
            box = Bbox.from_bounds(x + dx - width / 2, y + dy - height / 2, width, height)
            if box.padded(1.5).count_contains(on_line) or box.count_overlaps(taken):
                continue
            taken.append(box)
            place = {"xytext": (dx / pixels, dy / pixels), "textcoords": "offset points"}
            axes.annotate(text, point, **place, ha="center", va="center", fontsize=size, color=INK)
            if text != "start":
                axes.plot(*point, "o", color=color, markersize=3.4, markeredgecolor="white")
            break


def loop(result: Decomposition, *, ax: Axes | None = None, numbers: int = 24) -> Axes:
    """Draw the two coordinates of the loop, with frame numbers (the paper's Fig. 1).

    A square marks the start, arrowheads the direction; with three or more cycles, a wide line is
    the representative one. The curve drifts slowly, so even equal cycles lie side by side: the
    width of the loop shows drift as well as difference. Each cyclic segment has a loop of its own;
    the one with the representative cycle is drawn.

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`, with cycles.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.
    numbers : int, default=24
        Largest number of samples with a frame number; numbers without room beside the lines are
        left out.

    Returns
    -------
    matplotlib Axes

    Raises
    ------
    ValueError
        There are no cycles.
    """
    result = _checked(result, "loop")
    shown = _shown_samples(result)
    coords, frames = result.coords, result.frames
    line, chosen, dense = _smooth(coords[shown]), _singled_out(result), _is_dense(result)
    with _axes_to_draw_in(ax, 0.82 * _COLUMN) as axes:
        directed = line
        if chosen:
            inside = (frames[shown] >= chosen.begin) & (frames[shown] <= chosen.end)
            directed = _smooth(coords[shown][inside])
            axes.plot(*directed.T, color=_CYCLE, linewidth=_WIDE, alpha=0.45)
        texts = [("start", line[0], INK)]
        step = -(-(shown.stop - shown.start) // numbers)
        for unit, at in _unit_slices(result):
            begin, end = max(at.start, shown.start), min(at.stop, shown.stop)
            color, alpha, width = UNIT_COLORS[unit.kind], 0.25, _MANY
            if not dense:
                alpha, width = 1.0, 0.8 * _CURVE
            if end - begin > 1:
                piece = _smooth(coords[begin:end]).T
                axes.plot(*piece, color=color, linewidth=width, alpha=alpha, label=unit.kind)
            for i in range(begin - begin % -step, end - 1, step):
                texts.append((f"{frames[i]}", coords[i], color))
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.09)
        axes.autoscale_view()
        several = sum(segment.kind == "cyclic" for segment in result.segment_list) > 1
        label = _looped(result).label
        axes.set_xlabel("first coordinate of the loop" + (f" of {label}" if several else ""))
        axes.set_ylabel("second coordinate of the loop")
        axes.plot(*line[0], "s", color=INK, markersize=3.2, zorder=4)
        _draw_arrows(axes, directed)
        _legend_above(axes, 1.0)
        _write(axes, line, texts)
    drawn: Axes = axes
    return drawn


def cycles(result: Decomposition, *, ax: Axes | None = None) -> Axes:
    """Draw the curve of each cycle on 0 to 100 %, with mean and standard deviation.

    The cycles are those around the representative one that have the same coordinates; of more than
    60, 60 are drawn.

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
    result = _checked(result, "cycles")
    shown = _shown_samples(result)
    frames, curve = result.frames[shown], result.curve[shown]
    percent = np.linspace(0, 100, 101)
    each = np.array(
        [
            np.interp(np.linspace(c.begin, c.end, 101), frames, curve, np.nan, np.nan)
            for c in result.cycle_list
            if frames[0] <= (c.begin + c.end) // 2 <= frames[-1]
        ]
    )
    mean = np.nanmean(each, axis=0)
    count = min(len(each), _MOST_LINES)
    with _axes_to_draw_in(ax, 0.6 * _COLUMN) as axes:
        for line in each[np.arange(count) * len(each) // count]:
            axes.plot(percent, line, color=_CYCLE, linewidth=_MANY, alpha=0.25, label="one cycle")
        if len(each) > 1:
            sd = np.nanstd(each, axis=0, ddof=1)
            band = {"color": _CYCLE, "alpha": 0.25, "linewidth": 0}
            axes.fill_between(percent, mean - sd, mean + sd, label="standard deviation", **band)
        axes.plot(percent, mean, color=_CYCLE, linewidth=_CURVE, label="mean")
        axes.set_xlim(0, 100)
        axes.set_xlabel("share of the cycle in %")
        axes.set_ylabel("motion coordinate")
        _legend_above(axes, 1.0)
    drawn: Axes = axes
    return drawn
