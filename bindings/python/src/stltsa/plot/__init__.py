# SPDX-License-Identifier: BSD-3-Clause
"""The paper's figures and others, each from one call; needs Matplotlib.

:func:`loop`
    Fig. 1: the motion as a loop in two coordinates, with start, direction and frame numbers.
:func:`denoising`
    Fig. 2: coordinates before and after cleaning, and the residuals.
:func:`units`
    Fig. 3: the coordinate over time, cut into units and cycles, with postures.
:func:`cycles`
    The curves of all cycles on 0 to 100 %, with mean and standard deviation.
:func:`cycle_times`
    How long each cycle lasts.

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

from ._cycles import cycle_times, cycles
from ._denoising import denoising
from ._loop import loop
from ._units import units

__all__ = ["cycle_times", "cycles", "denoising", "loop", "units"]
