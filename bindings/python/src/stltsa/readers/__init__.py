# SPDX-License-Identifier: BSD-3-Clause
"""Formats that others read: each module turns the data of one reader into a clip.

================ =================================================== ==========================
 module           data                                                needs
================ =================================================== ==========================
 ``c3d``          C3D files: markers and events                       ``stltsa[c3d]`` (ezc3d)
 ``opensim``      TRC, MOT and STO files                              ``stltsa[trc]`` (pandas)
 ``amass``        AMASS ``npz`` files: rotations of a SMPL skeleton   nothing more
 ``movement``     datasets of `movement`: SLEAP, DeepLabCut,          ``stltsa[movement]``
                  LightningPose, Anipose, NWB, ...
================ =================================================== ==========================
"""

from __future__ import annotations

import importlib
from typing import Any

# The module that reads a suffix.
READERS = {".c3d": "c3d", ".trc": "opensim", ".mot": "opensim", ".sto": "opensim", ".npz": "amass"}


def extra(name: str, of: str) -> Any:
    """Return a package that an extra of this one installs."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"this needs {name}: pip install 'stltsa[{of}]'") from error


def reader(suffix: str) -> Any:
    """Return the function ``read(path, fps)`` for a suffix; None if the library reads it."""
    module = READERS.get(suffix.lower())
    return None if module is None else importlib.import_module(f".{module}", __name__).read
