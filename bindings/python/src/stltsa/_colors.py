# SPDX-License-Identifier: BSD-3-Clause
"""Colors that color-blind readers can tell apart too.

From the palette of Okabe and Ito, "Color Universal Design" (2008).
"""

UNIT_COLORS = {
    "preparing": "#999999",
    "initial": "#E69F00",
    "cyclic": "#0072B2",
    "final": "#CC79A7",
    "wind-up": "#56B4E9",
    "action": "#009E73",
    "cycle": "#0072B2",
}

CURVE = "#000000"
POINTS = "#D55E00"
