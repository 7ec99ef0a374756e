# SPDX-License-Identifier: BSD-3-Clause
"""Colors that color-blind readers can tell apart too.

From the palette of Okabe and Ito, "Color Universal Design" (2008); the command `stltsa` has the
same.
"""

UNIT_COLORS = {
    "preparing": "#56B4E9",
    "initial": "#E69F00",
    "cyclic": "#0072B2",
    "final": "#D55E00",
    "wind-up": "#CC79A7",
    "action": "#009E73",
    "cycle": "#0072B2",
}
POINTS = "#D55E00"
CURVE = "#0072B2"
INK = "#222222"
FAINT = "#999999"
