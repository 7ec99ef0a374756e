# SPDX-License-Identifier: BSD-3-Clause
"""Models: the curve of a motion, and the mapping between poses and curve."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _html
from ._arrays import (
    FloatArray,
    IntArray,
    as_integers,
    as_matrix,
    columns,
    read_from,
    read_list,
    write_list,
    write_to,
)
from ._call import Call, check, made, new
from ._clips import frames_and_lengths, refuse_groups
from ._facts import Described
from ._native import ffi, lib
from ._options import rate_given, working_rate
from ._text import c_path, c_text
from .clip import Clip, opened
from .errors import ShapeError, UnsupportedError, advice, warn_of_order

if TYPE_CHECKING:
    from collections.abc import Mapping

    from typing_extensions import Unpack

    from ._given import Labels, Matrix, Motions, Path
    from ._options import Options
    from .phase import Phase


class Mapped(NamedTuple):
    """Frames mapped onto the curve, or coordinates mapped back to frames.

    Attributes
    ----------
    values : ndarray of shape (rows, columns)
        Coordinates (:meth:`Model.map`) or frames (:meth:`Model.unmap`).
    distance : ndarray of shape (rows,)
        Distance from the fitted rows, relative to their typical distance: beyond 1 the row is
        unlike them and its values are unreliable.
    nearest : ndarray of shape (rows,)
        The nearest row of the model.
    """

    values: FloatArray
    distance: FloatArray
    nearest: IntArray


def fit(motion: Motions, *, groups: Labels | None = None, **options: Unpack[Options]) -> Model:
    """Fit a model: spatio-temporal local tangent space alignment (the paper, section 2.2).

    Parameters
    ----------
    motion : Clip, path, array-like of shape (frames, features), or list of clips or of arrays
        Rows are frames in temporal order. Arrays are used unchanged; a clip gives its features,
        without a T-pose at the start, smoothed and decimated to `sample_rate`; clips in a
        list have one hierarchy. A C-contiguous float64 array is not copied; others are copied once;
        a list is copied into one array.
    groups : array-like of shape (frames,), optional
        A label for each row of an array with several clips; the rows of a clip are contiguous.
    **options
        Used: `neighbors`, `window`, `dimension`, `mode`, `include_self`, `links`, `exclusion`,
        `threads`, `fps`, `period_min`, `period_max`, `keep_frames`, `progress`; for clips
        `features`, `up_axis`, `keep_start`, `sample_rate` and `smoothing` too. A Clip has its own
        `fps`. See :func:`stltsa.options`.

    Returns
    -------
    Model

    Raises
    ------
    stltsa.ArgumentError, stltsa.ShapeError, stltsa.NotFiniteError, stltsa.TooFewFramesError
        The frames or the options are invalid; the text says what to do.
    stltsa.DegenerateError
        The frames do not vary.

    Warns
    -----
    QualityWarning
        The rows show no order in time; :attr:`Model.warnings` has all warnings.

    Examples
    --------
    >>> import numpy as np
    >>> import stltsa
    >>> t = np.linspace(0, 6 * np.pi, 300)
    >>> model = stltsa.fit(np.column_stack([np.cos(t), np.sin(t), np.sin(t + 1)]), neighbors=110)
    >>> model.coords.shape
    (300, 2)
    """
    model = fitted(motion, groups, options)
    warn_of_order(model.warnings)
    return model


def fitted(motion: Any, groups: Any, options: Options) -> Model:
    """Return the model of :func:`fit`, which raises no warnings."""
    several = isinstance(motion, list | tuple) and len(motion) > 0
    clips = [opened(each, options) for each in (motion if several else [motion])]
    if all(isinstance(clip, Clip) for clip in clips):
        refuse_groups(groups, "every Clip is a clip of its own")
        handles, rate = [clip._handle for clip in clips], working_rate(clips[0].fps, options)
        given = lib.stltsa_fit_clips, handles, len(handles)
    else:
        frames, lengths = frames_and_lengths(motion, groups)
        given, rate = (lib.stltsa_fit, read_from(frames), read_list(lengths)), rate_given(options)
    return Model(made("model", *given, options=options, rate=rate))


_COORDINATES = "it takes coordinates such as .coords and map(...).values; call map for frames"


def _as_hints(hints: Any, rows: int) -> IntArray | None:
    return None if hints is None else as_integers(hints, rows, "hints")


class Model(Described):
    """A fitted model; made by :func:`fit`, :meth:`load` and unpickling.

    Only :meth:`keep_cycle` changes it, at once for all threads that use it.
    """

    _kind = "model"

    def __len__(self) -> int:
        return self._int("rows")

    @property
    def n_features(self) -> int:
        """Number of fitted columns."""
        return self._int("feature_count")

    @property
    def dimension(self) -> int:
        """Number of coordinates (d)."""
        return self._int("dimension")

    @property
    def neighbors(self) -> int:
        """Neighbors of each frame (k)."""
        return self._int("neighbors")

    @property
    def window(self) -> int:
        """Window: frames to each side (w)."""
        return self._int("window")

    @property
    def mode(self) -> str:
        """``"temporal"``, ``"spatial"`` or ``"recurrent"``."""
        return self._text("mode")

    @property
    def n_components(self) -> int:
        """Number of components of the neighborhood graph; each has its own coordinates."""
        return len(self._list("component"))

    @property
    def frames(self) -> IntArray:
        """Source frame of each row, in its clip if there are several; shape (rows,)."""
        first, step = self._list("first_frame"), self._list("frame_step")
        lengths = self._list("length") if len(first) > 1 else (len(self),)
        return np.concatenate(
            [f + s * np.arange(rows) for f, s, rows in zip(first, step, lengths, strict=True)]
        )

    @property
    def fps(self) -> float:
        """Rows per second; 0 if unknown."""
        return self._real("fps")

    @property
    def period(self) -> float:
        """Period in seconds from which `neighbors` follows; 0: none, or the rate is unknown."""
        return self._real("period")

    @property
    def period_frames(self) -> float:
        """Period in rows, also if the frame rate is unknown; 0: none."""
        return self._real("period_rows")

    @property
    def time_correlation(self) -> float:
        """Rank correlation of coordinate 1 with time, 0 to 1; at 1 it only follows time."""
        return self._real("time_correlation")

    @property
    def residual(self) -> float:
        """Largest relative residual of the eigenvectors."""
        return float(max(component.residual for component in self._list("component")))

    @property
    def error_estimate(self) -> float:
        """Estimated angle to the exact embedding of these neighborhoods, in radians."""
        return float(max(each.error_estimate_rad for each in self._list("component")))

    @property
    def coords(self) -> FloatArray:
        """The curve; shape (rows, d). Columns are centered and of norm 1 in each component."""
        return self._array("coords")

    @property
    def eigenvalues(self) -> FloatArray:
        """Smallest eigenvalues of the alignment matrix, ascending; shape (components, d + 2).

        The first is zero; NaN if a component is too small to have as many.
        """
        return self._array("eigenvalues")

    @property
    def components(self) -> IntArray:
        """Component of each row, counted from 0; shape (rows,)."""
        return self._integers("component_of")

    def map(
        self, motion: Motions, *, hints: Labels | None = None, **options: Unpack[Options]
    ) -> Mapped:
        """Map frames onto the curve (the paper, section 2.4).

        Parameters
        ----------
        motion : Clip, path, array-like of shape (rows, features), or list of such arrays
            A clip is prepared like the model's clip, and every frame is mapped. A fitted frame gets
            its own coordinates, to the bit. If equal frames occur more than once, they get the
            coordinates of the first, unless a hint selects another.
        hints : array-like of int of shape (rows,), optional
            The row of the model near which to look for each frame; -1: everywhere. Not for clips.
        **options
            Used: `map_neighbors`, `map_blend`, `hint_window`, `threads`, `progress`.

        Returns
        -------
        Mapped
            Coordinates of shape (rows, d), their distance from the fitted rows, the nearest rows.
        """
        motion = opened(motion, options)
        if isinstance(motion, Clip):
            if hints is not None:
                raise ValueError("hints= is for arrays")
            with advice(UnsupportedError, "call map(clip.features())"):
                return self._mapped(
                    lib.stltsa_map_clip, (motion._handle,), (len(motion), self.dimension), options
                )
        frames, _ = frames_and_lengths(motion)
        wanted = _as_hints(hints, len(frames))
        if frames.shape[1] == self.dimension:
            call = "map takes frames; call unmap for coordinates"
        else:
            call = (
                "map takes the columns that were fitted, in the same order; of a model of clips "
                "call map with a Clip or a path"
            )
        with advice(ShapeError, call):
            return self._mapped(
                lib.stltsa_map,
                (read_from(frames), read_list(wanted)),
                (len(frames), self.dimension),
                options,
            )

    def _mapped(
        self, function: Any, what: tuple[Any, ...], shape: tuple[int, int], options: Any
    ) -> Mapped:
        """Call a mapping, which writes a matrix of a given shape and two numbers for each row."""
        values, distance = columns(*shape), columns(shape[0], 1)
        nearest = np.empty(shape[0], dtype=np.int64)
        places = (write_to(values), write_to(distance), write_list(nearest))
        with Call(options) as call:
            call.check(function(self._handle, *what, call.options, *places))
        return Mapped(values, distance[:, 0], nearest)

    def unmap(
        self, coords: Matrix, *, hints: Labels | None = None, **options: Unpack[Options]
    ) -> Mapped:
        """Map coordinates back to frames (the paper, section 2.4).

        Parameters
        ----------
        coords : array-like of shape (rows, d)
            Points on the curve or near it. One coordinate alone cannot distinguish the forward from
            the backward swing: pass hints, or fit more dimensions.
        hints : array-like of int of shape (rows,), optional
            The row of the model near which to look for each point; -1: everywhere.
        **options
            Used: `map_neighbors`, `map_blend`, `hint_window`, `component`, `threads`, `progress`.

        Returns
        -------
        Mapped
            Frames of shape (rows, features), in the units of the fitted frames.

        Raises
        ------
        stltsa.DisconnectedError
            The model has several components, and the option `component` is missing.
        """
        points = as_matrix(coords, "coords")
        wanted = _as_hints(hints, len(points))
        with advice(ShapeError, _COORDINATES):
            return self._mapped(
                lib.stltsa_unmap,
                (read_from(points), read_list(wanted)),
                (len(points), self.n_features),
                options,
            )

    def poses(
        self, coords: Matrix, *, hints: Labels | None = None, **options: Unpack[Options]
    ) -> Clip:
        """Map coordinates back to poses: a clip with the model's skeleton.

        Parameters and errors are those of :meth:`unmap`, and the option `fps` is the number of
        points per second. For coordinates that :meth:`map` returned for a clip, pass the rate of
        that clip; the default is the rate of the model's rows, which `fit` may have decimated.

        Raises
        ------
        stltsa.UnsupportedError
            The model was fitted to plain numbers.
        """
        points = as_matrix(coords, "coords")
        wanted = _as_hints(hints, len(points))
        given = lib.stltsa_unmap_clip, self._handle, read_from(points), read_list(wanted)
        with advice(ShapeError, _COORDINATES):
            return Clip(made("clip", *given, options=options, outputs=(ffi.NULL, ffi.NULL)))

    def keep_cycle(self, phase: Phase, marks: Mapping[str, float] | None = None) -> None:
        """Keep what a stream is compared with; see :class:`stltsa.Live`.

        Parameters
        ----------
        phase : Phase
            Of a clip with the features of the model. The motion with the most frames in cycles is
            kept, also in model files.
        marks : mapping of str to float, optional
            Names of events and the frame of each in one of the cycles; streams report them as they
            pass.

        Raises
        ------
        stltsa.ArgumentError
            The clip has no cycles, or a mark lies in none.
        stltsa.ShapeError
            The features differ from those of the model.
        stltsa.DegenerateError
            Nothing is left to compare a stream with, because all columns only drift.
        """
        # A copy, because other threads and calls with progress functions may be using the handle.
        changed = Model.from_bytes(self.to_bytes())._handle
        with Call() as call:
            call.check(lib.stltsa_model_keep_cycle(changed, phase._handle, call.options))
        for name, frame in (marks or {}).items():
            text = c_text(name, "the name of a mark")
            check(lib.stltsa_model_keep_mark(changed, phase._handle, frame, text))
        self._handle = changed

    @property
    def has_cycle(self) -> bool:
        """Whether the model keeps a mean cycle."""
        return bool(self._int("has_cycle"))

    def to_bytes(self) -> bytes:
        """Return the model as bytes: versioned, checksummed, the same on every machine."""
        out, size = ffi.new("unsigned char **"), ffi.new("size_t *")
        check(lib.stltsa_model_serialize(self._handle, out, size))
        try:
            return bytes(ffi.buffer(out[0], size[0]))
        finally:
            lib.stltsa_free(out[0])

    @classmethod
    def from_bytes(cls, data: bytes) -> Model:
        """Return the model from the bytes of :meth:`to_bytes`, with the same bits.

        Raises
        ------
        stltsa.FormatError
            The bytes are not a model; the text says what is wrong with them.
        """
        return cls(new("model", lib.stltsa_model_parse, ffi.from_buffer(data), len(data)))

    def save(self, path: Path) -> None:
        """Write the model to a file, completely or not at all; the command `stltsa` can read it."""
        with Call() as call:
            call.check(lib.stltsa_model_save(self._handle, c_path(path), call.options))

    @classmethod
    def load(cls, path: Path) -> Model:
        """Read a model written by :meth:`save` or ``stltsa fit -o``."""
        return cls(made("model", lib.stltsa_model_load, c_path(path)))

    def __reduce__(self) -> tuple[Any, tuple[bytes]]:
        return Model.from_bytes, (self.to_bytes(),)

    def __repr__(self) -> str:
        return (
            f"<Model: {len(self)} rows, {self.n_features} features -> {self.dimension}, "
            f"{self.mode}, k = {self.neighbors}, w = {self.window}>"
        )

    def _repr_html_(self) -> str:
        return _html.model(self)
