# SPDX-License-Identifier: BSD-3-Clause
"""The phase of a stream, frame by frame."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._arrays import read_from
from ._call import check, owned, texts
from ._native import ffi, lib
from ._text import string

if TYPE_CHECKING:
    from .model import Model


class LiveFrame(NamedTuple):
    """What a frame of a stream is.

    `phase` in [0, 1) is that of the kept clip; `rate_hz` turns a second; `cycles` turns since the
    first frame; `distance` from the mean cycle, above 1 another motion; `confidence` 0 to 1;
    `known` whether this is the kept motion; `kind` ``"cyclic"``, ``"action"`` or ``"rest"``;
    `events` the names of the marks that were passed since the frame before.
    """

    phase: float
    rate_hz: float
    cycles: float
    distance: float
    confidence: float
    known: bool
    kind: str
    events: tuple[str, ...]


class Live:
    """Follow one stream of frames with a model that keeps a mean cycle.

    Parameters
    ----------
    model : Model
        Of a clip; :meth:`Model.keep_cycle` gave it the mean cycle.

    Raises
    ------
    stltsa.UnsupportedError
        The model keeps no mean cycle.

    Examples
    --------
    >>> import stltsa
    >>> result = stltsa.decompose("walker.bvh")
    >>> model = stltsa.fit(result.clip)
    >>> model.keep_cycle(result.phase(), {"strike": 250})
    >>> live = stltsa.Live(model)
    >>> frames = result.clip.features()
    >>> seen = [live.push(row, i / result.clip.fps) for i, row in enumerate(frames)]
    >>> sum("strike" in frame.events for frame in seen)
    4
    """

    def __init__(self, model: Model) -> None:
        out = ffi.new("stltsa_live **")
        check(lib.stltsa_live_new(model._handle, out))
        self._handle = owned("live", out)
        self._frame = ffi.new("stltsa_live_frame *", {"size": ffi.sizeof("stltsa_live_frame")})
        self.marks: tuple[str, ...] = texts(
            lib.stltsa_live_mark_count, lib.stltsa_live_mark_name, self._handle
        )

    def push(self, features: Any, seconds: float) -> LiveFrame:
        """Take the next frame; there is no delay.

        Parameters
        ----------
        features : array-like of shape (features,)
            As a row of :meth:`Clip.features`. If one is NaN, the frame is missing, and the phase
            goes on as before.
        seconds : float
            Time of the frame; rises from call to call.
        """
        row = np.ascontiguousarray(features, dtype=np.float64).reshape(1, -1)
        check(lib.stltsa_live_push(self._handle, seconds, read_from(row), self._frame))
        raw = self._frame
        passed = tuple(name for i, name in enumerate(self.marks) if raw.passed >> i & 1)
        return LiveFrame(
            raw.phase,
            raw.rate_hz,
            raw.cycles,
            raw.distance,
            raw.confidence,
            bool(raw.known),
            string(lib.stltsa_segment_name(raw.kind)),
            passed,
        )
