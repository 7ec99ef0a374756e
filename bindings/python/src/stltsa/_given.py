# SPDX-License-Identifier: BSD-3-Clause
"""What the functions are given: its types, and errors that name it and say what to call."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, TypeVar, Union

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from .clip import Clip


class HasArray(Protocol):
    """A NumPy array, a DataFrame, a tensor, and so on."""

    def __array__(self) -> npt.NDArray[Any]: ...


# npt.ArrayLike would also take a number.
Matrix: TypeAlias = HasArray | Sequence[Sequence[float]]
Labels: TypeAlias = HasArray | Sequence[int] | Sequence[str]
Path: TypeAlias = str | os.PathLike[str]
Motion: TypeAlias = Union["Clip", Path, Matrix]
Motions: TypeAlias = Motion | Sequence["Clip"] | Sequence[Path] | Sequence[HasArray]

_T = TypeVar("_T")

# What to use of an object that is given in place of a motion.
_INSTEAD = {
    "Decomposition": "its clip is .clip, its coordinates are .coords",
    "Denoising": "its coordinates are .cleaned",
    "Mapped": "its coordinates or frames are .values",
    "Model": "its coordinates are .coords",
    "Piece": "its clip is .clip",
    "Synthesis": "its clip is .clip",
}


def described(value: object) -> str:
    """Return what a value is, in a few words."""
    if value is None:
        return "None"
    if isinstance(value, str | os.PathLike):
        return f"the path {os.fspath(value)!r}"
    if isinstance(value, int | float | np.number):
        return f"the number {value!r}"
    if isinstance(value, np.ndarray):
        return f"an array of the shape {value.shape}"
    name = type(value).__name__
    if isinstance(value, list | tuple) and type(value) in (list, tuple):
        kinds = {type(each).__name__ for each in value}
        name = f"{name} of {len(value)}" + (f" {kinds.pop()}" if len(kinds) == 1 else "")
    return f"{'an' if name[0] in 'AEIOU' else 'a'} {name}"


def wrong(what: str, value: object, wanted: str) -> TypeError:
    """Return the error for an object of the wrong type: what it is, and what to give instead."""
    instead = _INSTEAD.get(type(value).__name__)
    more = f" ({instead})" if instead else ""
    return TypeError(f"{what} is {described(value)}{more}, and must be {wanted}")


def expect(value: object, kind: type[_T], caller: str, maker: str) -> _T:
    """Return the value if it is of a kind; `maker` is the function that returns that kind."""
    if isinstance(value, kind):
        return value
    motion = repr(os.fspath(value)) if isinstance(value, str | os.PathLike) else "clip"
    if maker == "stltsa.denoise" and type(value).__name__ == "Model":
        motion = "model"
    name = kind.__name__
    raise TypeError(
        f"{caller} takes a {name}, the result of {maker}, and is given {described(value)}: "
        f"call {caller}({maker}({motion}))"
    )
