# SPDX-License-Identifier: BSD-3-Clause
"""Failures as exceptions, with the library's texts.

There is one class for each status of the C interface. Each derives from :class:`StltsaError` and
from the matching built-in exception, so ``except ValueError`` works too.
"""

from __future__ import annotations

import warnings
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

__all__ = [
    "ArgumentError",
    "CancelledError",
    "DegenerateError",
    "DisconnectedError",
    "FileError",
    "FormatError",
    "InternalError",
    "NoCommonPostureError",
    "NoSuchPartError",
    "NotConvergedError",
    "NotFiniteError",
    "OutOfMemoryError",
    "QualityWarning",
    "ShapeError",
    "StltsaError",
    "TooFewFramesError",
    "UnsupportedError",
    "error_for",
]


class StltsaError(Exception):
    """Any failure of the library.

    Attributes
    ----------
    status : int
        The status of the C interface, a negative number.
    name : str
        Its name there, for example ``"STLTSA_E_SHAPE"``.
    """

    def __init__(self, text: str, status: int = -13, name: str = "STLTSA_E_INTERNAL") -> None:
        super().__init__(text)
        self.status = status
        self.name = name

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (str(self), self.status, self.name)


class ArgumentError(StltsaError, ValueError):
    """An unknown option, a value out of range, or inconsistent neighbors."""


class ShapeError(StltsaError, ValueError):
    """The rows or columns of an array do not match."""


class NotFiniteError(StltsaError, ValueError):
    """A NaN or an infinity among the frames; the text gives its position."""


class TooFewFramesError(StltsaError, ValueError):
    """There are fewer (distinct) frames than the neighbors require."""


class OutOfMemoryError(StltsaError, MemoryError):
    """Out of memory."""


class FileError(StltsaError, OSError):
    """A file cannot be opened, read or written."""


class FormatError(StltsaError, ValueError):
    """The content of a file does not match its format; the text gives the line."""


class DisconnectedError(StltsaError, ValueError):
    """The neighborhood graph is disconnected, but a connected one is required."""


class DegenerateError(StltsaError, ValueError):
    """The frames do not vary, or vary in too few directions."""


class NotConvergedError(StltsaError, RuntimeError):
    """The eigensolver did not converge."""


class CancelledError(StltsaError, RuntimeError):
    """The progress callback cancelled the call."""


class UnsupportedError(StltsaError, NotImplementedError):
    """Not available in this build of the library, or not for this clip."""


class InternalError(StltsaError, RuntimeError):
    """A defect of the library: please report it."""


class NoCommonPostureError(StltsaError, ValueError):
    """Two pieces of motion have no common posture at which to join."""


class NoSuchPartError(StltsaError, LookupError):
    """The clip lacks the stretch that was asked for."""


class QualityWarning(UserWarning):
    """A warning of the library about a result."""


_CLASSES: dict[str, type[StltsaError]] = {
    "STLTSA_E_ARGUMENT": ArgumentError,
    "STLTSA_E_SHAPE": ShapeError,
    "STLTSA_E_NOT_FINITE": NotFiniteError,
    "STLTSA_E_TOO_FEW_FRAMES": TooFewFramesError,
    "STLTSA_E_NO_MEMORY": OutOfMemoryError,
    "STLTSA_E_IO": FileError,
    "STLTSA_E_FORMAT": FormatError,
    "STLTSA_E_DISCONNECTED": DisconnectedError,
    "STLTSA_E_DEGENERATE": DegenerateError,
    "STLTSA_E_NOT_CONVERGED": NotConvergedError,
    "STLTSA_E_CANCELLED": CancelledError,
    "STLTSA_E_UNSUPPORTED": UnsupportedError,
    "STLTSA_E_INTERNAL": InternalError,
    "STLTSA_E_NO_COMMON_POSTURE": NoCommonPostureError,
    "STLTSA_E_NO_SUCH_PART": NoSuchPartError,
}


def error_for(status: int, name: str, text: str) -> StltsaError:
    """Return the exception for a status; an unknown status is an error too."""
    return _CLASSES.get(name, StltsaError)(text, status, name)


# The library's words, and the keywords of :func:`stltsa.fit`.
_UNORDERED = (
    "option mode spatial and option include_self off",
    'mode="spatial", include_self=False',
)


def in_keywords(texts: Iterable[str]) -> tuple[str, ...]:
    """Return the library's warnings with this package's keywords in place of its options."""
    return tuple(text.replace(*_UNORDERED) for text in texts)


def warn_of_order(texts: Iterable[str]) -> None:
    """Raise the warning that rows have no order in time, for the caller of the caller."""
    for text in texts:
        if _UNORDERED[1] in text:
            warnings.warn(text, QualityWarning, stacklevel=3)


@contextmanager
def advice(kind: type[StltsaError], text: str) -> Iterator[None]:
    """Add to the text of an error of a kind what to call instead."""
    try:
        yield
    except kind as error:
        raise type(error)(f"{error}: {text}", error.status, error.name) from None
