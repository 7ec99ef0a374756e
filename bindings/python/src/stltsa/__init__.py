# SPDX-License-Identifier: BSD-3-Clause
"""Motion clips as low-dimensional curves, motion units and cycles.

In short::

    import stltsa

    result = stltsa.decompose("walk.bvh")
    print(result.units)
    stltsa.plot.units(result)

The method is spatio-temporal local tangent space alignment: H. Li, J. Niu, L. Zhang, B. Hu,
"Spatio-temporal LTSA and Its Application to Motion Decomposition", ICONIP 2012 ("the paper").
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from . import _rows, errors
from ._batch import BatchRow, batch
from ._native import lib as _lib
from ._options import Option, Options, OptionTable, options
from ._rows import *  # noqa: F403
from ._statistics import PartStatistics
from ._text import names as _names
from ._text import string as _string
from .clip import Clip, read_clip
from .comparison import Comparison
from .decomposition import Decomposition, decompose, report
from .denoising import Denoising, denoise
from .dimensions import Dimension, dimension
from .errors import *  # noqa: F403
from .events import side_of_name
from .live import Live, LiveFrame
from .model import Mapped, Model, fit
from .phase import Cycles, FoundEvents, Phase, cycles_between
from .synthesis import Piece, Synthesis, synthesize, synthesize_loop

if TYPE_CHECKING:
    from . import plot, readers
    from .estimator import STLTSA

_PARTS = {name: part for part, name in _names("STLTSA_HAS_").items()}


def has(part: str) -> bool:
    """Return whether this build of the library has an optional part.

    Parameters
    ----------
    part : str
        ``"openblas"``, whose threads a fit limits, or ``"cholmod"``, which makes the modes
        spatial and recurrent faster.

    Examples
    --------
    >>> import stltsa
    >>> stltsa.has("cholmod") in (True, False)
    True
    """
    if part not in _PARTS:
        raise ValueError(f"part is {part!r}, and must be one of: {', '.join(_PARTS)}")
    return bool(_lib.stltsa_has(_PARTS[part]))


__version__: str = _string(_lib.stltsa_version())

__all__ = [  # noqa: PLE0604
    "STLTSA",
    "BatchRow",
    "Clip",
    "Comparison",
    "Cycles",
    "Decomposition",
    "Denoising",
    "Dimension",
    "FoundEvents",
    "Live",
    "LiveFrame",
    "Mapped",
    "Model",
    "Option",
    "OptionTable",
    "Options",
    "PartStatistics",
    "Phase",
    "Piece",
    "Synthesis",
    "__version__",
    "batch",
    "cycles_between",
    "decompose",
    "denoise",
    "dimension",
    "errors",
    "fit",
    "has",
    "options",
    "plot",
    "read_clip",
    "readers",
    "report",
    "side_of_name",
    "synthesize",
    "synthesize_loop",
    *(name for name in errors.__all__ if name != "error_for"),
    *_rows.__all__,
]

# Loads the modules that import a large package when they are first used.
_LAZY = {"STLTSA": "estimator", "plot": "", "readers": ""}


def __getattr__(name: str) -> Any:
    if name not in _LAZY:
        raise AttributeError(f"module 'stltsa' has no attribute {name!r}")
    if not _LAZY[name]:
        return importlib.import_module(f".{name}", __name__)
    value = getattr(importlib.import_module(f".{_LAZY[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*__all__, *(name for name in globals() if name.startswith("__"))})
