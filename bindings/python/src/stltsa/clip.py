# SPDX-License-Identifier: BSD-3-Clause
"""Clips of motion: reading, properties, writing."""

from __future__ import annotations

import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _html
from ._arrays import FloatArray, IntArray, as_matrix, columns, read_from, write_to
from ._call import Call, check, owned
from ._clips import call_on_clips, refuse_groups
from ._facts import Described
from ._given import wrong
from ._native import ffi, lib
from ._options import rate_given, working_rate
from ._text import c_path, names, string

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import Auto, Features, UpAxis
    from ._options import Options

_FORMATS = names("STLTSA_FORMAT_")


class Clip(Described):
    """A motion clip: poses over time, of a skeleton or as plain numbers.

    Made by :func:`read_clip`, :meth:`from_array`, :func:`stltsa.synthesize` and
    :meth:`stltsa.Model.poses`. A clip does not change. Frames are counted from 0 in the source
    file; lengths are in the file's unit.
    """

    _kind = "clip"

    def __init__(self, handle: Any, path: str | None = None, owner: object = None) -> None:
        self._handle = handle
        self._owner = owner  # owner of the handle, if that is not the clip itself
        self.path = path

    @classmethod
    def from_array(cls, frames: npt.ArrayLike, fps: float) -> Clip:
        """Return a clip of plain numbers, which are copied.

        Parameters
        ----------
        frames : array-like of shape (frames, channels)
            Finite numbers, one row per frame.
        fps : float
            Frames per second, above 0.

        Raises
        ------
        stltsa.NotFiniteError
            The numbers contain a NaN or an infinity.

        Examples
        --------
        >>> import numpy as np
        >>> import stltsa
        >>> stltsa.Clip.from_array(np.zeros((120, 3)), fps=60)
        <Clip: 120 frames, 2.00 s at 60 fps, 3 channels>
        """
        array = as_matrix(frames, "frames")
        out = ffi.new("stltsa_clip **")
        check(lib.stltsa_clip_from_matrix(read_from(array), float(fps), out))
        return cls(owned("clip", out))

    def __len__(self) -> int:
        return int(lib.stltsa_clip_frames(self._handle))

    @property
    def fps(self) -> float:
        """Frames per second; 0 if unknown."""
        return float(lib.stltsa_clip_fps(self._handle))

    @property
    def duration(self) -> float:
        """Seconds; NaN if the frame rate is unknown."""
        return len(self) / self.fps if self.fps else float("nan")

    @property
    def format(self) -> str:
        """``"bvh"``, ``"amc"``, ``"csv"``, ``"npy"`` or ``"matrix"``."""
        return _FORMATS.get(lib.stltsa_clip_format(self._handle), "unknown")

    @property
    def channels(self) -> int:
        """Numbers per frame in the file."""
        return int(lib.stltsa_clip_channels(self._handle))

    def _joint(self, index: int) -> tuple[str, int, bool]:
        name, parent, end = ffi.new("char const **"), ffi.new("int64_t *"), ffi.new("int32_t *")
        check(lib.stltsa_clip_joint(self._handle, index, name, parent, end))
        return string(name[0]), int(parent[0]), bool(end[0])

    @cached_property
    def _joints(self) -> tuple[tuple[str, int, bool], ...]:
        return tuple(map(self._joint, range(lib.stltsa_clip_joints(self._handle))))

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of joints and end sites in file order, parents first; empty without a skeleton."""
        return tuple(name for name, _, _ in self._joints)

    @property
    def parents(self) -> IntArray:
        """Index of the parent of each joint, -1 for the root; shape (joints,)."""
        return np.array([parent for _, parent, _ in self._joints], dtype=np.int64)

    @property
    def end_sites(self) -> npt.NDArray[np.bool_]:
        """Which of the joints are end sites; shape (joints,)."""
        return np.array([end for _, _, end in self._joints], dtype=np.bool_)

    def _per_joint(self, function: Any, numbers: int) -> FloatArray:
        result = columns(len(self), numbers * len(self._joints))
        check(function(self._handle, write_to(result)))
        result = result.reshape(len(self), len(self._joints), numbers)
        result.flags.writeable = False
        return result

    @cached_property
    def positions(self) -> FloatArray:
        """World positions x y z of all joints, by forward kinematics; (frames, joints, 3).

        In the file's unit of length. Read-only, computed once.

        Raises
        ------
        stltsa.UnsupportedError
            The clip has no skeleton.
        """
        return self._per_joint(lib.stltsa_clip_positions, 3)

    @cached_property
    def rotations(self) -> FloatArray:
        """Local rotations of all joints as quaternions w x y z; (frames, joints, 4).

        Their signs are continuous over time. Read-only, computed once.

        Raises
        ------
        stltsa.UnsupportedError
            The clip has no skeleton.
        """
        return self._per_joint(lib.stltsa_clip_rotations, 4)

    def features(
        self,
        kind: Features | Auto | None = None,
        *,
        features: Features | Auto | None = None,
        up_axis: UpAxis | Auto | None = "auto",
    ) -> FloatArray:
        """Return the features of all poses; shape (frames, features), unsmoothed.

        Parameters
        ----------
        kind : {"auto", "positions", "rotations6d", "euler", "raw", "points"}
            ``"positions"``: joint positions without the root's position and yaw; ``"rotations6d"``:
            two columns of each rotation matrix; ``"euler"``: the angles below the root in radians,
            as in the paper; ``"raw"``: the file's numbers; ``"points"``: points such as markers,
            three columns each, gaps filled, without path and heading. ``"auto"``: positions if
            there is a skeleton, points if the columns are named so (heel_x, heel_y, heel_z, ...),
            otherwise raw.
        features
            The same as `kind`; the keyword of the other functions.
        up_axis : {"auto", "x", "y", "z"}
            The axis that points up.
        """
        if kind is not None and features is not None:
            raise TypeError("features() is given both kind and features=, which mean the same")
        with Call({"features": kind or features, "up_axis": up_axis}) as call:
            count = ffi.new("int64_t *")
            call.check(lib.stltsa_clip_feature_count(self._handle, call.options, count))
            result = columns(len(self), count[0])
            call.check(lib.stltsa_clip_features(self._handle, call.options, write_to(result)))
        return result

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the clip, completely or not at all; the suffix determines the format.

        ``.bvh``: any skeleton; ``.amc``: clips read from AMC; ``.csv`` and ``.npy``: the numbers of
        any clip. Numbers read back to the same bits.

        Raises
        ------
        stltsa.ArgumentError
            The suffix is none of these.
        stltsa.UnsupportedError
            The clip has no skeleton, or no frame rate although the format needs one.
        stltsa.FileError
            The file cannot be written.
        """
        check(lib.stltsa_clip_save(self._handle, c_path(path)))

    def __repr__(self) -> str:
        seconds = f", {self.duration:.2f} s at {self.fps:g} fps" if self.fps else ""
        joints = f"{len(self._joints)} joints, " if self._joints else ""
        name = f" {Path(self.path).name}" if self.path else ""
        return f"<Clip{name}: {len(self)} frames{seconds}, {joints}{self.channels} channels>"

    def _repr_html_(self) -> str:
        return _html.clip(self)


def read_clip(
    path: str | os.PathLike[str], *, gaps: str = "refuse", **options: Unpack[Options]
) -> Clip:
    """Read a clip from a file: BVH, ASF/AMC, CSV, NPY; with extras also C3D, TRC and MOT.

    Parameters
    ----------
    path : path
        The suffix determines the format, or else the content. The ASF file of an AMC file is found
        in its folder by subject number; the option `skeleton` names another one.
    gaps : {"refuse", "fill"}
        How to treat gaps of markers in C3D, TRC and MOT files: raise an exception that gives their
        positions, or fill them linearly with a :class:`stltsa.QualityWarning`. See
        :mod:`stltsa.markers`.
    **options
        Used: `fps` (overrides the file), `skeleton`, `progress`.

    Returns
    -------
    Clip

    Raises
    ------
    stltsa.FileError
        The file cannot be read.
    stltsa.FormatError
        The content does not match the format; the text gives the line and what to do.
    stltsa.NotFiniteError
        The file contains a NaN or an infinity.

    Examples
    --------
    >>> import stltsa
    >>> clip = stltsa.read_clip("walker.bvh")
    >>> clip.positions.shape == (len(clip), len(clip.joints), 3)
    True
    """
    if Path(path).suffix.lower() in (".c3d", ".trc", ".mot", ".sto"):
        from .markers import read_markers

        return read_markers(path).to_clip(gaps=gaps, fps=options.get("fps"))
    out = ffi.new("stltsa_clip **")
    with Call(options) as call:
        call.check(lib.stltsa_clip_open(c_path(path), call.options, out))
    return Clip(owned("clip", out), os.fspath(path))


def opened(motion: Any, options: Options) -> Any:
    """Return the clip at a path, and anything else unchanged."""
    if not isinstance(motion, str | os.PathLike):
        return motion
    used: Any = {k: v for k, v in options.items() if k in ("fps", "skeleton")}
    return read_clip(motion, **used)


def call_on_motion(kind: str, motion: Any, groups: Any, options: Options, out: Any) -> None:
    """Call a function on frames or clips: one, or a list; `kind` is the middle of its name."""
    of_frames = getattr(lib, f"stltsa_{kind}")
    of_clips = getattr(lib, f"stltsa_{kind}_clips")
    several = isinstance(motion, list | tuple) and len(motion) > 0
    clips = [opened(each, options) for each in (motion if several else [motion])]
    are_clips = all(isinstance(clip, Clip) for clip in clips)
    rate = working_rate(clips[0].fps, options) if are_clips else rate_given(options)
    with Call(options, rate) as call:
        if are_clips:
            refuse_groups(groups, "every Clip is a clip of its own")
            handles = [clip._handle for clip in clips]
            call.check(of_clips(handles, len(handles), call.options, out))
        else:
            call_on_clips(of_frames, motion, groups, call, out)


def _check_rate(clip: Clip, fps: Any) -> None:
    """Refuse a rate other than the clip's, which would be ignored."""
    if fps not in (None, "auto", clip.fps):
        raise ValueError(
            f"fps is {fps!r}, but a Clip has its own, {clip.fps:g} (0: unknown): give fps= to "
            "read_clip or Clip.from_array"
        )


def holds_clips(motion: Any) -> bool:
    """Return whether a motion is a clip or a path, or a list of them, and not numbers."""
    several = isinstance(motion, list | tuple) and len(motion) > 0
    each = motion if several else [motion]
    return all(isinstance(m, Clip | str | os.PathLike) for m in each)


def one_matrix(motion: Any) -> npt.NDArray[Any]:
    """Return an array of frames; refuse several clips."""
    if isinstance(motion, list | tuple) and any(isinstance(each, Clip) for each in motion):
        raise wrong("X", motion, "one Clip, path or array: call it for each of them")
    return as_matrix(motion)


def as_clip(motion: Any, options: Any) -> Clip:
    """Return a clip; make one from an array, with `fps` from the options."""
    motion = opened(motion, options)
    if isinstance(motion, Clip):
        _check_rate(motion, options.pop("fps", None))
        return motion
    fps = options.pop("fps", None)
    frames = one_matrix(motion)
    if fps in (None, "auto"):
        raise ValueError("an array has no frame rate: give fps=...")
    return Clip.from_array(frames, fps)
