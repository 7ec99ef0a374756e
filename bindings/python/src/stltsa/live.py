# SPDX-License-Identifier: BSD-3-Clause
"""The phase of a stream, frame by frame."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._arrays import FloatArray, as_matrix, read_from, unmasked
from ._call import check, new
from ._facts import Described, row_of
from ._native import ffi, lib
from ._rows import SegmentKind  # noqa: TC001 (read at run time)

if TYPE_CHECKING:
    from .clip import Clip
    from .model import Model


class LiveFrame(NamedTuple):
    """What a frame of a stream is.

    `phase` in [0, 1) is that of the kept clip; `rate_hz` turns a second; `cycles` turns since the
    first frame; `distance` is that from the mean cycle, above 1 for another motion, NaN for a
    missing frame; `confidence` is 0 to 1; `known` tells whether this is the kept motion; `kind` is
    ``"cyclic"``, ``"action"`` or ``"rest"``; `events` are the names of the marks that were passed
    since the frame before.
    """

    phase: float
    rate_hz: float
    cycles: float
    distance: float
    confidence: float
    known: bool
    kind: SegmentKind
    events: tuple[str, ...]


class Live(Described):
    """Follow one stream of frames with a model that keeps a mean cycle.

    Push one frame after another, each in the form in which it comes: points, rotations of joints,
    features, or frames of a clip. No answer depends on later frames. Threads may share a stream: a
    lock lets one frame in at a time, so that pushes wait for each other.

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
    >>> seen = [live.push_frame(result.clip, i) for i in range(len(result.clip))]
    >>> sum("strike" in frame.events for frame in seen)
    4
    """

    _kind = "live"

    def __init__(self, model: Model) -> None:
        super().__init__(new("live", lib.stltsa_live_new, model._handle))
        self._one = threading.RLock()  # a signal handler may push during a push
        self.marks: tuple[str, ...] = self._list("mark")

    def push(self, features: Any, seconds: float) -> LiveFrame:
        """Take the next frame as features; there is no delay.

        Parameters
        ----------
        features : array-like of shape (features,)
            With a skeleton a row of :meth:`Clip.features`; otherwise the numbers of the columns of
            the file, NaN if one is lost. If too much is lost, the frame is missing, and the phase
            goes on as before.
        seconds : float
            Time of the frame; rises from call to call. If a frame has the time of the one before,
            or one up to 0.25 s earlier, it is left out. At most 1e12 either way.
        """
        row = _numbers(features, "features").reshape(1, -1)
        return self._answer(lib.stltsa_live_push, seconds, read_from(row))

    def push_points(self, points: Any, seconds: float, confidence: Any = None) -> LiveFrame:
        """Take the next frame as points in space or in a plane, such as markers.

        Parameters
        ----------
        points : array-like of shape (points, 2 or 3)
            In the order and the unit of the model's clip; a point is lost if it is NaN, or if all
            of its coordinates are 0. Where the body is and which way it faces does not count.
        seconds : float
            As for :meth:`push`.
        confidence : array-like of shape (points,), optional
            0 for a lost point.

        Raises
        ------
        stltsa.UnsupportedError
            The model is of a clip without points.
        """
        rows = _numbers(points, "points")
        seen = None
        if confidence is not None:
            seen = _numbers(confidence, "confidence").reshape(-1, 1)
        return self._answer(
            lib.stltsa_live_push_points,
            seconds,
            read_from(as_matrix(rows, "points")),
            ffi.NULL if seen is None else read_from(seen),
        )

    def push_pose(self, rotations: Any, seconds: float, root_position: Any = None) -> LiveFrame:
        """Take the next frame as rotations of the joints of the model's skeleton.

        Parameters
        ----------
        rotations : array-like of shape (joints, 4), (joints, 3, 3) or (channels,)
            Local rotations as quaternions w x y z or matrices, or the channels of a file, in
            degrees; see :meth:`Clip.from_skeleton`. If a number is NaN, the frame is missing.
        seconds : float
            As for :meth:`push`.
        root_position : array-like of shape (3,), optional
            It counts only if a joint above the body's root moves.

        Raises
        ------
        stltsa.UnsupportedError
            The model is of a clip without a skeleton, or its features are numbers of the file.
        """
        numbers = _numbers(rotations, "rotations")
        forms = {
            1: lib.STLTSA_ROTATIONS_CHANNELS,
            2: lib.STLTSA_ROTATIONS_QUATERNION,
            3: lib.STLTSA_ROTATIONS_MATRIX,
        }
        if numbers.ndim not in forms:
            raise ValueError(
                "rotations must be of the shape (joints, 4), (joints, 3, 3) or (channels,); it is "
                f"of the shape {numbers.shape}"
            )
        rows = numbers.reshape(1 if numbers.ndim == 1 else len(numbers), -1)
        root = None
        if root_position is not None:
            root = _numbers(root_position, "root_position").reshape(1, -1)
        return self._answer(
            lib.stltsa_live_push_pose,
            seconds,
            forms[numbers.ndim],
            read_from(rows),
            ffi.NULL if root is None else read_from(root),
        )

    def push_frame(self, clip: Clip, index: int, seconds: float | None = None) -> LiveFrame:
        """Take a frame of a clip; its other frames are not looked at.

        Parameters
        ----------
        clip : Clip
            With the joints, points or columns of the model's clip; bones may have other lengths.
        index : int
            The frame.
        seconds : float, optional
            As for :meth:`push`; ``index / clip.fps`` by default.
        """
        if seconds is None:
            if clip.fps is None:
                raise ValueError("the clip has no frame rate: give seconds")
            seconds = index / clip.fps
        return self._answer(lib.stltsa_live_push_frame, seconds, clip._handle, index)

    def _answer(self, push: Any, seconds: float, *frame: Any) -> LiveFrame:
        raw = ffi.new("stltsa_live_frame *", {"size": ffi.sizeof("stltsa_live_frame")})
        with self._one:
            check(push(self._handle, seconds, *frame, raw))
        passed = tuple(name for i, name in enumerate(self.marks) if raw.passed >> i & 1)
        return row_of(LiveFrame, raw, events=passed)  # type: ignore[no-any-return]


def _numbers(values: Any, what: str) -> FloatArray:
    """Return numbers as packed float64, with NaN for masked ones."""
    try:
        return np.ascontiguousarray(unmasked(values), dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{what} must hold numbers: {error}") from error
