# SPDX-License-Identifier: BSD-3-Clause
"""Fig. 2 of the paper: coordinates before and after cleaning."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._colors import CURVE as CURVE_COLOR
from .._colors import FAINT, POINTS
from .._given import expect
from ..denoising import Denoising
from ._style import COLUMN, CURVE, axes_to_draw_in, legend_above, time_label

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt
    from matplotlib.axes import Axes


def denoising(
    result: Denoising,
    *,
    column: int = 0,
    fps: float | None = None,
    ax: Sequence[Axes] | npt.NDArray[np.object_] | None = None,
) -> tuple[Axes, Axes, Axes]:
    """Draw coordinates before and after cleaning (the paper's Fig. 2), and the residuals.

    Points that are moved are filled. The band is the noise threshold on both sides of the fitted
    curve. The residuals are the points before cleaning, minus the fitted curve.

    Parameters
    ----------
    result : Denoising
        Result of :func:`stltsa.denoise`.
    column : int, default=0
        Index of the coordinate.
    fps : float, optional
        Rows per second: the time axis is in seconds, otherwise in rows. Default: the model's.
    ax : sequence of three matplotlib Axes, optional
        Axes to draw into; a new figure by default.

    Returns
    -------
    tuple of three matplotlib Axes
    """
    result = expect(result, Denoising, "stltsa.plot.denoising", "stltsa.denoise")
    if fps is None and result.model is not None:
        fps = result.model.fps
    time = np.arange(len(result.points)) / (fps or 1.0)
    before, after = result.points[:, column], result.cleaned[:, column]
    curve, gamma = result.curve[:, column], float(result.facts["gamma"][column])
    moved = result.moves[:, column] != 0
    panels = (
        ("before denoising", before, curve),
        ("after denoising", after, curve),
        ("residuals before denoising", before - curve, np.zeros_like(curve)),
    )
    with axes_to_draw_in(ax, 1.15 * COLUMN, rows=3, ratios=(1.0, 1.0, 0.6)) as axes:
        for panel, (title, points, line) in zip(axes, panels, strict=True):
            panel.fill_between(
                time,
                line - gamma,
                line + gamma,
                color=CURVE_COLOR,
                alpha=0.22,
                linewidth=0,
                label="noise threshold",
            )
            panel.plot(
                time[~moved],
                points[~moved],
                "o",
                markerfacecolor="none",
                markeredgecolor=FAINT,
                markersize=2.0,
                markeredgewidth=0.5,
                label="coordinate",
            )
            panel.plot(time, line, color=CURVE_COLOR, linewidth=CURVE, label="fitted curve")
            panel.plot(
                time[moved],
                points[moved],
                "o",
                color=POINTS,
                markersize=2.4,
                markeredgewidth=0,
                label="noisy, moved",
            )
            panel.set_title(title)
        values = np.concatenate([before, after, curve])
        room = 0.06 * (np.ptp(values) or 1.0)
        for panel in axes[:2]:
            panel.set_ylim(values.min() - room, values.max() + room)
        axes[0].set_ylabel(f"coordinate {column + 1}")
        axes[1].set_ylabel(f"coordinate {column + 1}")
        axes[2].set_ylabel("distance")
        axes[2].set_xlabel(time_label(fps, "row"))
        legend_above(axes[0], 1.16)
    first, second, third = axes
    return first, second, third
