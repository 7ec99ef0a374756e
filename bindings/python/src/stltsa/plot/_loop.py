# SPDX-License-Identifier: BSD-3-Clause
"""Fig. 1 of the paper: the motion as a loop."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import numpy as np

from .._colors import INK
from .._given import expect
from ..decomposition import Decomposition
from ._style import (
    COLUMN,
    CURVE,
    MANY,
    WIDE,
    axes_to_draw_in,
    color_of,
    drawn_values,
    is_dense,
    label_kinds,
    legend_above,
    looped_segment,
    singled_out,
    smooth_path,
    unit_slices,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._arrays import FloatArray

_EIGHT = np.arange(8) * np.pi / 4
_NEAR, _FAR = 3.5, 7.0  # points between a mark and its text


def _outward(path: FloatArray, point: FloatArray) -> FloatArray:
    """Return the direction from the center of the loop to a point."""
    out = point - np.nanmean(path, axis=0)
    return np.asarray(out / (np.linalg.norm(out) or 1.0))


def _draw_arrows(axes: Any, path: FloatArray) -> None:
    """Draw three arrowheads along a path."""
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    length = np.concatenate([[0.0], steps.cumsum()])
    if len(path) < 3 or not length[-1] > 0:
        return
    for share in (1 / 6, 3 / 6, 5 / 6):
        i = int(np.clip(np.searchsorted(length, share * length[-1]), 1, len(path) - 1))
        if not steps[i - 1] > 0:
            continue
        part = (share * length[-1] - length[i - 1]) / steps[i - 1]
        tip = path[i - 1] + part * (path[i] - path[i - 1])
        axes.annotate(
            "",
            tip,
            xytext=path[i - 1] if part > 0.1 else path[max(i - 2, 0)],
            arrowprops={
                "arrowstyle": "-|>,head_length=0.5,head_width=0.25",
                "color": INK,
                "linewidth": 0,
                "shrinkA": 0,
                "shrinkB": 0,
                "mutation_scale": 9,
            },
            zorder=4,
        )


def _write(axes: Any, path: FloatArray, texts: list[tuple[str, FloatArray, str]]) -> None:
    """Write texts beside their points, where they cover neither lines nor each other.

    A number also gets a disk of its color. Texts without room are left out. The axes must have
    their final limits.
    """
    from matplotlib import patheffects
    from matplotlib.transforms import Bbox

    figure = axes.figure
    figure.draw_without_rendering()
    points_to_pixels = figure.dpi / 72
    curve = smooth_path(path).interpolated(1)
    on_line = axes.transData.transform(
        np.concatenate([*curve.to_polygons(closed_only=False), np.empty((0, 2))])
    )
    on_line = _filled(on_line, 2.0)
    halo = [patheffects.withStroke(linewidth=1.6, foreground="white")]
    size = _number_size(axes)
    taken: list[Bbox] = []
    for text, point, color in texts:
        x, y = axes.transData.transform(point)
        outward = _outward(path, point)
        width, height = np.array([0.68 * len(text), 1.25]) * size * points_to_pixels
        places = sorted(
            (away - np.cos(angle) * outward[0] - np.sin(angle) * outward[1], away, angle)
            for away in (_NEAR, _FAR)
            for angle in _EIGHT
        )
        for _, away, angle in places:
            dx = np.cos(angle) * (away * points_to_pixels + width / 2)
            dy = np.sin(angle) * (away * points_to_pixels + height / 2)
            box = Bbox.from_bounds(x + dx - width / 2, y + dy - height / 2, width, height)
            if box.padded(1.5).count_contains(on_line) or box.count_overlaps(taken):
                continue
            taken.append(box)
            axes.annotate(
                text,
                point,
                xytext=(dx / points_to_pixels, dy / points_to_pixels),
                textcoords="offset points",
                ha="center",
                va="center",
                color=INK,
                fontsize=size,
                path_effects=halo,
                zorder=5,
            )
            if text != "start":
                edge = {"markeredgecolor": "white", "markeredgewidth": 0.45}
                axes.plot(*point, "o", color=color, markersize=3.4, zorder=3, **edge)
            break


def _number_size(axes: Any) -> float:
    """Return the font size of numbers, in points."""
    return 0.85 * float(axes.xaxis.label.get_size())


def _filled(points: FloatArray, apart: float) -> FloatArray:
    """Return points with others added between them, so that no text fits between two."""
    parts = [points]
    for a, b in itertools.pairwise(points):
        count = int(np.hypot(*(b - a)) / apart)
        if 0 < count < 1000:
            parts.append(a + (b - a) * (np.arange(1, count + 1) / (count + 1))[:, None])
    return np.concatenate(parts)


def loop(result: Decomposition, *, ax: Axes | None = None, numbers: int = 24) -> Axes:
    """Draw the two coordinates of the loop, with frame numbers (the paper's Fig. 1).

    A square marks the start, arrowheads the direction; with three or more cycles, a wide line is
    the representative one. The curve drifts slowly, so even equal cycles lie side by side: the
    width of the loop shows drift as well as difference. If there
    are several cyclic segments, each has a loop of its own, and one is drawn: that of the segment
    with the representative cycle or, if there is none, of the longest segment.

    Parameters
    ----------
    result : Decomposition
        Result of :func:`stltsa.decompose`.
    ax : matplotlib Axes, optional
        Axes to draw into; a new figure by default.
    numbers : int, default=24
        Largest number of samples with a frame number; numbers without room beside the lines are
        left out.

    Returns
    -------
    matplotlib Axes
    """
    from matplotlib.patches import PathPatch

    result = expect(result, Decomposition, "stltsa.plot.loop", "stltsa.decompose")
    _, coords = drawn_values(result)
    frames, chosen = result.frames, singled_out(result)
    segment = looped_segment(result)
    if segment is not None:
        coords[(frames < segment.begin) | (frames >= segment.end)] = np.nan
    dense = is_dense(result)

    def draw(axes: Any, path: FloatArray, **style: Any) -> None:
        axes.add_patch(PathPatch(smooth_path(path), fill=False, joinstyle="round", **style))

    with axes_to_draw_in(ax, 0.82 * COLUMN) as axes:
        directed = coords[np.isfinite(coords).all(axis=1)]
        if chosen:
            cycle = coords[(frames >= chosen.begin) & (frames <= chosen.end)]
            if np.isfinite(cycle).all():
                directed = cycle
                draw(axes, cycle, color=color_of("cycle"), linewidth=WIDE, alpha=0.45)
        for unit, at in unit_slices(result):
            piece = coords[at][np.isfinite(coords[at]).all(axis=1)]  # outside cycles there is none
            if len(piece) < 2:
                continue
            draw(
                axes,
                piece,
                color=color_of(unit.kind),
                linewidth=MANY if dense else 0.8 * CURVE,
                alpha=0.25 if dense else 1.0,
            )
        known = np.flatnonzero(np.isfinite(coords).all(axis=1))
        axes.set_aspect("equal", adjustable="datalim")
        axes.margins(0.09)
        axes.autoscale_view()
        what = "loop" if result.cycle_list else "curve"
        if segment is not None:
            what += f" of {segment.label}"
        axes.set_xlabel(f"first coordinate of the {what}")
        axes.set_ylabel(f"second coordinate of the {what}")
        if len(known):
            texts = [("start", coords[known[0]], INK)]
            chosen_samples = np.unique(np.linspace(0, len(known) - 1, numbers).round().astype(int))
            for i in known[chosen_samples][1:]:
                kind = next(u.kind for u in result.unit_list if frames[i] < u.end)
                texts.append((f"{frames[i]}", coords[i], color_of(kind)))
            axes.plot(*coords[known[0]], "s", color=INK, markersize=3.2, zorder=4)
            _draw_arrows(axes, directed)
            label_kinds(axes, result)
            legend_above(axes, 1.0)
            _write(axes, coords, texts)
    drawn: Axes = axes
    return drawn
