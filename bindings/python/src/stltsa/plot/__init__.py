# SPDX-License-Identifier: BSD-3-Clause
"""The paper's figures, each from one call; needs Matplotlib.

:func:`loop`
    Fig. 1: the motion as a loop in two coordinates, with frame numbers.
:func:`denoising`
    Fig. 2: coordinates before and after cleaning.
:func:`units`
    Fig. 3: the coordinate over time, cut into units and cycles, with postures.

Each function draws into `ax`, or into a new figure that is legible in a column of a paper (88 mm
wide). Color-blind readers can distinguish the colors, and no information is in colors alone.

Examples
--------
>>> import stltsa
>>> result = stltsa.decompose("walker.bvh")
>>> ax = stltsa.plot.units(result)
>>> ax.get_xlabel()
'time in seconds'
"""

from ._denoising import denoising
from ._loop import loop
from ._units import units

__all__ = ["denoising", "loop", "units"]
