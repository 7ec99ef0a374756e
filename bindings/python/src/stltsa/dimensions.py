# SPDX-License-Identifier: BSD-3-Clause
"""The intrinsic dimension of a motion (the paper, section 2.3)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np

from .model import Model, fitted

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._arrays import FloatArray
    from ._given import Labels, Motions
    from ._options import Options


class Dimension(NamedTuple):
    """Two estimates of the intrinsic dimension; ``None`` means that there is no estimate.

    Attributes
    ----------
    eigengap : int or None
        The first gap between eigenvalues above the threshold, the paper's estimate. It counts the
        eigenvalue zero. By construction one more eigenvalue than the tangent dimension is small, so
        the estimate depends on the option `dimension`: compare it with `local_pca`.
    local_pca : int or None
        Median number of principal directions that explain the share `variance`.
    reasons : tuple of str
        Why there is no estimate.
    eigenvalues : ndarray
        Eigenvalues of the alignment matrix over k, ascending, starting with zero.
    local_variances : ndarray
        Mean share of a neighborhood's variance along its principal directions.
    model : Model
        The model that was fitted, with all facts.
    """

    eigengap: int | None
    local_pca: int | None
    reasons: tuple[str, ...]
    eigenvalues: FloatArray
    local_variances: FloatArray
    model: Model

    def __repr__(self) -> str:
        return f"<Dimension: local PCA {self.local_pca}, eigengap {self.eigengap}>"


def dimension(
    motion: Motions, *, groups: Labels | None = None, **options: Unpack[Options]
) -> Dimension:
    """Estimate the intrinsic dimension of a motion by two methods.

    Parameters
    ----------
    motion : Clip, path, array-like of shape (frames, features), or list of such arrays
        As in :func:`fit`.
    groups : array-like of shape (frames,), optional
        As in :func:`fit`.
    **options
        The options of :func:`fit`, and `eigengap` and `variance`.

    Returns
    -------
    Dimension

    Examples
    --------
    >>> import numpy as np
    >>> import stltsa
    >>> t = np.linspace(0, 6 * np.pi, 300)
    >>> circle = np.column_stack([np.cos(t), np.sin(t)])
    >>> stltsa.dimension(circle, neighbors=110).local_pca
    2
    """
    model = fitted(motion, groups, cast("Any", {**options, "intrinsic": True}))
    facts = model.facts
    return Dimension(
        facts["eigengap"] or None,
        facts["local_pca"] or None,
        tuple(filter(None, (facts["eigengap_reason"], facts["local_pca_reason"]))),
        np.array(facts["eigenvalue"]),
        np.array(facts["local_variance"]),
        model,
    )
