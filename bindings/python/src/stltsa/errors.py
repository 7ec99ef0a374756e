# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong, as exceptions; the text of each is the library's own.

There is one class for each status of the C interface. Each is a :class:`StltsaError` and the
built-in exception that a Python user would expect, so ``except ValueError`` works too.
"""

from __future__ import annotations

__all__ = [
    "ArgumentError",
    "CancelledError",
    "DegenerateError",
    "DisconnectedError",
    "FileError",
    "FormatError",
    "InternalError",
    "NoCommonPostureError",
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
    """An unknown option, a value out of its range, neighbors that do not fit together."""


class ShapeError(StltsaError, ValueError):
    """Rows or columns of an array do not fit."""


class NotFiniteError(StltsaError, ValueError):
    """A NaN or an infinity among the frames; the text says where."""


class TooFewFramesError(StltsaError, ValueError):
    """Fewer (distinct) frames than the neighbors ask for."""


class OutOfMemoryError(StltsaError, MemoryError):
    """Memory did not suffice."""


class FileError(StltsaError, OSError):
    """A file cannot be opened, read or written."""


class FormatError(StltsaError, ValueError):
    """A file is not what its format says; the text has the line."""


class DisconnectedError(StltsaError, ValueError):
    """The neighborhood graph falls apart where one was needed."""


class DegenerateError(StltsaError, ValueError):
    """The frames do not vary, or not in enough directions."""


class NotConvergedError(StltsaError, RuntimeError):
    """The eigensolver gave up."""


class CancelledError(StltsaError, RuntimeError):
    """The call was asked to stop."""


class UnsupportedError(StltsaError, NotImplementedError):
    """Not in this build of the library, or not for this clip."""


class InternalError(StltsaError, RuntimeError):
    """A defect of the library: please report it."""


class NoCommonPostureError(StltsaError, ValueError):
    """Two pieces of motion have no posture at which they could be joined."""


class QualityWarning(UserWarning):
    """What a user should know about a result, as the library words it."""


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
}


def error_for(status: int, name: str, text: str) -> StltsaError:
    """Return the exception for a status; one that this version does not know is an error too."""
    return _CLASSES.get(name, StltsaError)(text, status, name)
