# SPDX-License-Identifier: BSD-3-Clause
"""Progress reports during a call, and cancelling.

The library calls back at least a few times per second. Python checks for Ctrl-C when its own code
runs, so a long call notices it in the callback: any exception raised there, KeyboardInterrupt or
the user's own, cancels the call and propagates from it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol, TypeAlias

from ._native import ffi
from ._text import names

Progress: TypeAlias = bool | Callable[[str, float], object] | None


_STAGES = names("STLTSA_STAGE_")


class Reporter(Protocol):
    """Receives stages and fractions of them; closed at the end."""

    def report(self, stage: str, fraction: float) -> None:
        """Report that `fraction` of `stage` is done."""

    def close(self) -> None:
        """Clean up."""


class _Silent:
    def report(self, stage: str, fraction: float) -> None:
        pass

    def close(self) -> None:
        pass


class _Function(_Silent):
    def __init__(self, function: Callable[[str, float], object]) -> None:
        self._function = function

    def report(self, stage: str, fraction: float) -> None:
        self._function(stage, fraction)


class _Bar(_Silent):
    """A tqdm bar that restarts with each stage and disappears at the end."""

    def __init__(self, tqdm: Callable[..., Any]) -> None:
        self._bar = tqdm(total=1.0, leave=False, bar_format="{desc} {percentage:3.0f}%|{bar}|")
        self._stage = ""

    def report(self, stage: str, fraction: float) -> None:
        if stage != self._stage:
            self._stage = stage
            self._bar.reset()
            self._bar.set_description(f"{stage:<10}")
        self._bar.update(fraction - self._bar.n)

    def close(self) -> None:
        self._bar.close()


def reporter(progress: Progress) -> Reporter:
    """Return the reporter for the keyword `progress`; no bar if tqdm is not installed."""
    if callable(progress):
        return _Function(progress)
    if progress:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            return _Silent()
        return _Bar(tqdm)
    return _Silent()


class Watch:
    """Connects one call with its reporter, and keeps the reporter's exception."""

    def __init__(self, progress: Progress) -> None:
        self.reporter = reporter(progress)
        self.raised: BaseException | None = None
        self.handle: Any = ffi.new_handle(self)

    def close(self) -> None:
        """End the reports; the handle refers to this object and would keep its contents alive."""
        self.reporter.close()
        self.handle = ffi.NULL


def _keep(_kind: object, value: BaseException, traceback: Any) -> None:
    watch = ffi.from_handle(traceback.tb_frame.f_locals["user"])
    watch.raised = value


@ffi.def_extern(error=1, onerror=_keep)  # type: ignore[untyped-decorator]
def on_progress(user: Any, stage: int, fraction: float) -> int:
    """Pass on the library's report, on the thread of the call."""
    ffi.from_handle(user).reporter.report(_STAGES.get(stage, "working"), fraction)
    return 0
