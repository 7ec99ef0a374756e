# SPDX-License-Identifier: BSD-3-Clause
"""Colors that color-blind readers can distinguish.

From the palette of Okabe and Ito, "Color Universal Design" (2008), as in the command `stltsa`. The
position of a unit kind among the kinds determines its color.
"""

from ._native import lib
from ._text import names, string

_PALETTE = (
    "#56B4E9",
    "#E69F00",
    "#0072B2",
    "#D55E00",
    "#CC79A7",
    "#009E73",
    "#0072B2",
    "#F0E442",
)
UNIT_COLORS = {
    string(lib.stltsa_unit_name(kind)): _PALETTE[place % len(_PALETTE)]
    for place, kind in enumerate(sorted(names("STLTSA_UNIT_")))
}
UNIT_COLORS["cycle"] = UNIT_COLORS["cyclic"]
INK = "#222222"
