# SPDX-License-Identifier: BSD-3-Clause
"""Colors that color-blind readers can tell apart too.

From the palette of Okabe and Ito, "Color Universal Design" (2008); the command `stltsa` has the
same. A kind of unit has the color of its place among the kinds.
"""

from ._native import lib
from ._text import names, string

_PALETTE = ("#56B4E9", "#E69F00", "#0072B2", "#D55E00", "#CC79A7", "#009E73")
UNIT_COLORS = {
    string(lib.stltsa_unit_name(kind)): _PALETTE[place % len(_PALETTE)]
    for place, kind in enumerate(sorted(names("STLTSA_UNIT_")))
}
UNIT_COLORS["cycle"] = UNIT_COLORS["cyclic"]
POINTS = "#D55E00"
CURVE = "#0072B2"
INK = "#222222"
FAINT = "#999999"
