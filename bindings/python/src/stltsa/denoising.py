# SPDX-License-Identifier: BSD-3-Clause
"""Denoising of coordinates (the paper, section 3.2)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ._arrays import read_from, read_list
from ._call import made
from ._clips import frames_and_lengths, refuse_groups
from ._facts import Described
from ._native import lib
from ._options import rate_given
from ._rows import DenoisedColumn
from ._tables import table
from .clip import Clip, holds_clips
from .model import Model, fit

if TYPE_CHECKING:
    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._arrays import FloatArray
    from ._given import Labels, Motions
    from ._options import Options

_CLEANING = ("gamma", "knot_spacing", "robust", "period_min", "period_max", "progress")


def denoise(
    coords: Model | Motions, *, groups: Labels | None = None, **options: Unpack[Options]
) -> Denoising:
    """Fit a smooth curve to coordinates over time, and move noisy points towards it.

    Parameters
    ----------
    coords : Model, Clip, path, array-like of shape (rows, columns), or list of clips or of arrays
        Rows in temporal order. Each column is cleaned separately; each clip, and each component of
        a model, has its own curve. A clip is fitted first, as by :func:`fit`, and its coordinates
        are cleaned; an array holds coordinates.
    groups : array-like of shape (rows,), optional
        A label for each row of an array with several clips; the rows of a clip are contiguous.
    **options
        Used: `gamma` (distance from the curve beyond which a point is noisy, in units of the
        coordinate), `knot_spacing`, `robust`, `fps`, `period_min`, `period_max`, `progress`; for
        clips those of :func:`fit` too.

    Returns
    -------
    Denoising

    Raises
    ------
    stltsa.TooFewFramesError
        A clip has fewer than 8 rows.
    stltsa.NotFiniteError
        The coordinates contain a NaN or an infinity.

    Examples
    --------
    >>> import numpy as np
    >>> import stltsa
    >>> t = np.arange(200) / 50
    >>> noisy = np.sin(2 * np.pi * t) + np.random.default_rng(0).normal(0, 0.1, 200)
    >>> cleaned = stltsa.denoise(noisy.reshape(-1, 1), fps=50)
    >>> bool(abs(cleaned.curve[:, 0] - np.sin(2 * np.pi * t)).mean() < 0.05)
    True
    """
    if holds_clips(coords):
        coords = fit(cast("Motions", coords), groups=groups, **options)
        options = {n: v for n, v in options.items() if n in _CLEANING}  # type: ignore[assignment]
    model = coords if isinstance(coords, Model) else None
    if model:
        refuse_groups(groups, "a Model knows its components")
        points, rate = model.coords, model.fps
        given: tuple[Any, ...] = lib.stltsa_denoise_model, model._handle
    else:
        points, lengths = frames_and_lengths(coords, groups)
        given = lib.stltsa_denoise, read_from(points), read_list(lengths)
        rate = rate_given(options)
    handle = made("denoising", *given, options=options, rate=rate)
    return Denoising(handle, np.array(points, dtype=np.float64), model)


class Denoising(Described):
    """Coordinates before and after cleaning, and the fitted curve.

    Attributes
    ----------
    points : ndarray of shape (rows, columns)
        The original coordinates.
    model : Model or None
        The model whose coordinates they are; None for an array.
    """

    _kind = "denoising"

    def __init__(self, handle: Any, points: FloatArray, model: Model | None = None) -> None:
        super().__init__(handle)
        self.points = points
        self.model = model

    def poses(self) -> Clip:
        """Return the cleaned coordinates as poses: a clip with the model's skeleton and rate.

        Raises
        ------
        ValueError
            An array was cleaned, which has no model.
        stltsa.UnsupportedError
            The model was fitted to plain numbers.
        """
        if self.model is None:
            raise ValueError("an array has no poses: give denoise the Clip, its path or its Model")
        return self.model.poses(self.cleaned, hints=np.arange(len(self.points)))

    @property
    def curve(self) -> FloatArray:
        """The fitted curve; shape (rows, columns). Use it to find extrema and margins."""
        return self._array("curve")

    @property
    def cleaned(self) -> FloatArray:
        """The points after equation (1) of the paper; shape (rows, columns)."""
        return self._array("cleaned")

    @property
    def moves(self) -> FloatArray:
        """Displacement of each point, 0 if it was not moved; shape (rows, columns)."""
        return self._array("moves")

    @property
    def columns(self) -> DataFrame:
        """Threshold, noise and number of moved points of each column, as a table.

        See :class:`DenoisedColumn`.
        """
        return table(self._list("column"), DenoisedColumn)

    def __repr__(self) -> str:
        rows, cols = self.points.shape
        return f"<Denoising: {rows} rows x {cols}, {int((self.moves != 0).sum())} points moved>"
