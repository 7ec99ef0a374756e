# SPDX-License-Identifier: BSD-3-Clause
"""The sides of the body that names state."""

from __future__ import annotations

from ._native import lib
from ._text import c_text

_SIDES = {lib.STLTSA_SIDE_LEFT: "left", lib.STLTSA_SIDE_RIGHT: "right"}


def side_of_name(name: str) -> str:
    """Return the side of the body that the name of an event, a joint or a signal states.

    Parameters
    ----------
    name : str
        Such as ``"left heel strike"``, ``"LHS"`` or ``"toe_l"``.

    Returns
    -------
    str
        ``"left"``, ``"right"``, or ``""`` if the name states neither or both.

    Examples
    --------
    >>> import stltsa
    >>> [stltsa.side_of_name(name) for name in ("LHS", "Right Foot Off", "upright")]
    ['left', 'right', '']
    """
    return _SIDES.get(lib.stltsa_side_of_name(c_text(name, "name")), "")
