# SPDX-License-Identifier: BSD-3-Clause
"""Events of a recording, such as heel strikes, and the sides that names state."""

from __future__ import annotations

from typing import NamedTuple

from ._native import lib
from ._text import c_text

_SIDES = {lib.STLTSA_SIDE_LEFT: "left", lib.STLTSA_SIDE_RIGHT: "right"}


class Event(NamedTuple):
    """Something that happens at one moment.

    `label` is its name, such as ``"Foot Strike"``; `context` what it happens to, such as
    ``"Left"``, or an empty text; `seconds` count from the first frame of the clip.
    """

    label: str
    context: str
    seconds: float


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
