# SPDX-License-Identifier: BSD-3-Clause
"""One call of the library: options, progress, and failure as an exception."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import errors
from ._native import ffi, lib
from ._options import set_options
from ._progress import Watch
from ._text import string

if TYPE_CHECKING:
    from collections.abc import Mapping
    from types import TracebackType


def check(status: int) -> None:
    """Raise the exception for a status, with the library's text."""
    if status != lib.STLTSA_OK:
        name = string(lib.stltsa_status_name(status))
        text = string(lib.stltsa_last_error())
        # Its keyword here is that of datasets.
        text = text.replace("option subject", "option individual")
        raise errors.error_for(status, name, text)


def rebuilt(kind: type[Any], values: tuple[Any, ...], attributes: dict[str, Any]) -> Any:
    """Return a copy of a tuple that was made from a handle; for pickle."""
    copy = tuple.__new__(kind, values)
    copy.__dict__.update(attributes)
    return copy


class Call:
    """Options and progress of one call; use it in a ``with`` statement.

    `rate`: frames per second, for options in seconds that count frames; 0: unknown. The progress
    callback is always set, because Ctrl-C relies on it.
    """

    def __init__(self, options: Mapping[str, Any] | None = None, rate: float = 0.0) -> None:
        rest = dict(options or {})
        progress = rest.pop("progress", None)
        out = ffi.new("stltsa_options **")
        check(lib.stltsa_options_new(out))
        self.options = ffi.gc(out[0], lib.stltsa_options_free)
        check(set_options(self.options, rest, rate))
        self._watch = Watch(progress)  # last, because an open bar must be closed if something fails
        check(lib.stltsa_options_set_progress(self.options, lib.on_progress, self._watch.handle))

    def __enter__(self) -> Call:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self._watch.close()

    def check(self, status: int) -> None:
        """Raise the exception of the progress callback, or else the exception for the status."""
        raised, self._watch.raised = self._watch.raised, None
        if raised is None:
            check(status)
            return
        try:
            raise raised
        finally:
            del raised  # its traceback holds this frame, and so the caller's arrays


def owned(kind: str, pointer: Any) -> Any:
    """Return a handle that is freed when it is no longer referenced.

    C calls let other Python threads run, and the library does not lock its handles. So a handle
    that other threads can see is not changed, except that of a Live, which has a lock.

    Parameters
    ----------
    kind : str
        Type of the handle: the middle of ``stltsa_<kind>_free``.
    pointer : cffi pointer
        Location of the handle.
    """
    return ffi.gc(pointer[0], getattr(lib, f"stltsa_{kind}_free"))


def new(kind: str, function: Any, *given: Any) -> Any:
    """Return the new handle of a function whose last argument it is."""
    out = ffi.new(f"stltsa_{kind} **")
    check(function(*given, out))
    return owned(kind, out)


def made(
    kind: str,
    function: Any,
    *given: Any,
    options: Mapping[str, Any] | None = None,
    rate: float = 0.0,
    outputs: tuple[Any, ...] = (),
) -> Any:
    """Return the new handle of a function whose last arguments are options, outputs and it."""
    out = ffi.new(f"stltsa_{kind} **")
    with Call(options, rate) as call:
        call.check(function(*given, call.options, *outputs, out))
    return owned(kind, out)
