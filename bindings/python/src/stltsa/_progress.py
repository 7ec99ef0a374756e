# SPDX-License-Identifier: BSD-3-Clause
"""What is said while the library works, and how a call is stopped.

The library calls back a few times a second at least. Python looks for Ctrl-C whenever its code
runs, so the callback is where a long call notices it: whatever is raised there, KeyboardInterrupt
or an exception of the user's own, cancels the call and comes out of it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol, TypeAlias

from ._native import ffi
from ._text import names

Progress: TypeAlias = bool | Callable[[str, float], object] | None


_STAGES = names("STLTSA_STAGE_")


class Reporter(Protocol):
    """Takes stages and fractions of them, and is closed at the end."""

    def report(self, stage: str, fraction: float) -> None:
        """Say that `fraction` of `stage` is done."""

    def close(self) -> None:
        """Leave nothing behind."""


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
    """A bar of tqdm that starts anew with each stage and goes when the work is done."""

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
    """Return what the keyword `progress` asks for; no bar where tqdm is not installed."""
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
    """Stands between one call and its reporter, and keeps what the latter raised."""

    def __init__(self, progress: Progress) -> None:
        self.reporter = reporter(progress)
        self.raised: BaseException | None = None
        self.handle: Any = ffi.new_handle(self)

    def close(self) -> None:
        """End the reports; the handle refers back to here, and would keep what they hold alive."""
        self.reporter.close()
        self.handle = ffi.NULL


def _keep(_kind: object, value: BaseException, traceback: Any) -> None:
    watch = ffi.from_handle(traceback.tb_frame.f_locals["user"])
    watch.raised = value


@ffi.def_extern(error=1, onerror=_keep)  # type: ignore[untyped-decorator]
def on_progress(user: Any, stage: int, fraction: float) -> int:
    """Pass on what the library reports, on the thread that made the call."""
    ffi.from_handle(user).reporter.report(_STAGES.get(stage, "working"), fraction)
    return 0
