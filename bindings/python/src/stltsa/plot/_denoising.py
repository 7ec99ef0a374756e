# SPDX-License-Identifier: BSD-3-Clause
"""Fig. 2 of the paper: coordinates before and after cleaning."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._colors import CURVE, POINTS
from .._given import expect
from ..denoising import Denoising
from ._style import COLUMN, axes_to_draw_in

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
) -> tuple[Axes, Axes]:
    """Draw coordinates and the fitted curve, before and after cleaning (the paper's Fig. 2).

    Parameters
    ----------
    result : Denoising
        Result of :func:`stltsa.denoise`.
    column : int, default=0
        Index of the coordinate.
    fps : float, optional
        Rows per second: the time axis is in seconds, otherwise in rows. Default: the model's.
    ax : sequence of two matplotlib Axes, optional
        Axes to draw into; a new figure by default.

    Returns
    -------
    tuple of two matplotlib Axes
    """
    result = expect(result, Denoising, "stltsa.plot.denoising", "stltsa.denoise")
    if fps is None and result.model is not None:
        fps = result.model.fps
    time = np.arange(len(result.points)) / (fps or 1.0)
    panels = (("(a) before", result.points), ("(b) after", result.cleaned))
    with axes_to_draw_in(ax, 0.58 * COLUMN, count=2) as axes:
        for panel, (title, points) in zip(axes, panels, strict=True):
            panel.plot(
                time,
                points[:, column],
                "*",
                color=POINTS,
                markersize=3.2,
                markeredgewidth=0,
                label="coordinates",
            )
            curve = result.curve[:, column]
            panel.plot(time, curve, color=CURVE, linewidth=1.0, label="fitted curve", zorder=3)
            panel.set_title(title)
            panel.set_xlabel("time in seconds" if fps else "row")
        axes[0].set_ylabel(f"coordinate {column + 1}")
        axes[0].legend(
            loc="lower left",
            bbox_to_anchor=(0.0, 1.16),
            ncols=2,
            handlelength=1.2,
            columnspacing=1.0,
            handletextpad=0.4,
            borderaxespad=0.1,
        )
    before, after = axes
    return before, after
