# SPDX-License-Identifier: BSD-3-Clause
"""The intrinsic dimension of a motion (the paper, section 2.3)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import write_list
from ._call import check, owned
from ._facts import Described
from ._native import ffi, lib
from ._text import string
from .clip import call_on_motion

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._arrays import FloatArray
    from ._given import Labels, Motions
    from ._options import Options


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
    out = ffi.new("stltsa_dimension **")
    call_on_motion("estimate_dimension", motion, groups, options, out)
    return Dimension(owned("dimension", out))


class Dimension(Described):
    """Two estimates of the intrinsic dimension; ``None`` means that there is no estimate."""

    _kind = "dimension"

    def __init__(self, handle: Any) -> None:
        self._handle = handle

    def _estimate(self, function: Any) -> tuple[int | None, str]:
        reason = ffi.new("char const **")
        value = function(self._handle, reason)
        return (int(value) or None), string(reason[0])

    @property
    def eigengap(self) -> int | None:
        """The first gap between eigenvalues above the threshold, the paper's estimate.

        It counts the eigenvalue zero. By construction one more eigenvalue than the tangent
        dimension is small, so the estimate depends on the option `dimension`: compare it with
        :attr:`local_pca`.
        """
        return self._estimate(lib.stltsa_dimension_eigengap)[0]

    @property
    def local_pca(self) -> int | None:
        """Median number of principal directions that explain the share `variance`."""
        return self._estimate(lib.stltsa_dimension_local_pca)[0]

    @property
    def reasons(self) -> tuple[str, ...]:
        """Why there is no estimate."""
        functions = lib.stltsa_dimension_eigengap, lib.stltsa_dimension_local_pca
        return tuple(r for _, r in map(self._estimate, functions) if r)

    def _column(self, key: int, function: Any) -> FloatArray:
        count = lib.stltsa_info_count(lib.stltsa_dimension_info(self._handle), key)
        values = np.empty(count, dtype=np.float64)
        check(function(self._handle, write_list(values)))
        return values

    @property
    def eigenvalues(self) -> FloatArray:
        """Eigenvalues of the alignment matrix over k, ascending, starting with zero."""
        return self._column(lib.STLTSA_INFO_EIGENVALUE, lib.stltsa_dimension_eigenvalues)

    @property
    def local_variances(self) -> FloatArray:
        """Mean share of a neighborhood's variance along its principal directions."""
        return self._column(lib.STLTSA_INFO_LOCAL_VARIANCE, lib.stltsa_dimension_local_variances)

    def __repr__(self) -> str:
        return f"<Dimension: local PCA {self.local_pca}, eigengap {self.eigengap}>"
