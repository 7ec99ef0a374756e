# SPDX-License-Identifier: BSD-3-Clause
"""Formats that the library does not read: each module turns the data of one into a clip.

================ =================================================== ==========================
 module           data                                                needs
================ =================================================== ==========================
 ``amass``        AMASS ``npz`` files: rotations of a SMPL skeleton   nothing more
 ``movement``     datasets of `movement`: SLEAP, DeepLabCut,          ``stltsa[movement]``
                  LightningPose, Anipose, NWB, ...
================ =================================================== ==========================
"""

from __future__ import annotations

import importlib
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from .._native import lib
from ..errors import FormatError

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

# The module that reads a suffix.
READERS = {".npz": "amass"}


def is_dataset(value: object) -> bool:
    """Return whether this is a dataset of poses, such as those of `movement`."""
    return hasattr(value, "data_vars") and "position" in value.data_vars


def is_points(value: Any) -> bool:
    """Return whether this is an array of points: (frames, points, 2 or 3)."""
    return getattr(value, "ndim", 0) == 3 and value.shape[2] in (2, 3)


def bad(what: Path | str, text: str) -> FormatError:
    """Return the error for a file that is not what its suffix says, or for other wrong data."""
    return FormatError(f"{what}: {text}", lib.STLTSA_E_FORMAT, "STLTSA_E_FORMAT")


def rate_of(what: Path | str, name: str, value: Any) -> float:
    """Return the frames per second that a file or a dataset gives."""
    rate = np.asarray(value)
    if rate.size != 1 or rate.dtype.kind not in "fiu" or not 1e-9 <= rate.item() <= 1e6:
        shown = np.array2string(rate, threshold=4)
        raise bad(what, f"{name} is {shown}, and must be one number of frames per second")
    return float(rate.item())


@contextmanager
def said_of(path: Path, *kinds: type[Exception]) -> Iterator[None]:
    """Add the name of the file to errors of another package that reads it."""
    path.open("rb").close()  # says best why a file cannot be opened
    try:
        yield
    except (FileNotFoundError, FormatError):
        raise  # they name the file
    except kinds as error:
        text = str(error).strip() or type(error).__name__
        raise bad(path, f"the file cannot be read: {text}") from error


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
