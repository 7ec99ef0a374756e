# SPDX-License-Identifier: BSD-3-Clause
"""Clips of motion: reading, properties, writing."""

from __future__ import annotations

import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _exports, _html
from ._arrays import FloatArray, IntArray, as_matrix, columns, read_from, write_to
from ._call import Call, check, made, new
from ._facts import Described
from ._from_arrays import points_handle, skeleton_handle
from ._given import wrong
from ._native import ffi, lib
from ._options import rate_given, working_rate
from ._text import c_path, c_text
from .errors import UnsupportedError
from .readers import is_dataset, is_points, reader

if TYPE_CHECKING:
    from collections.abc import Sequence

    from typing_extensions import Unpack

    from ._keywords import Auto, Features, UpAxis
    from ._options import Options
    from ._progress import Progress
    from ._rows import FileEvent, Joint


class Clip(Described):
    """A motion clip: poses over time, of a skeleton or as plain numbers.

    Made by :func:`read_clip`, :meth:`from_array`, :func:`stltsa.synthesize` and
    :meth:`stltsa.Model.poses`. A clip does not change. Frames are counted from 0 in the source
    file; lengths are in the file's unit.
    """

    _kind = "clip"

    def __init__(self, handle: Any, path: str | None = None, owner: object = None) -> None:
        if not isinstance(handle, ffi.CData):
            raise wrong("the argument of Clip", handle, "a handle: call read_clip or from_array")
        super().__init__(handle)
        self._owner = owner  # owner of the handle, if that is not the clip itself
        self.path = path

    @classmethod
    def from_points(
        cls,
        positions: npt.ArrayLike,
        fps: float | None = None,
        *,
        names: Sequence[str] | None = None,
        confidence: npt.ArrayLike | None = None,
        times: npt.ArrayLike | None = None,
        min_confidence: float | None = None,
    ) -> Clip:
        """Return a clip of points in space or in a plane, such as markers; they are copied.

        Parameters
        ----------
        positions : array-like of shape (frames, points, 2 or 3)
            NaN, and 0 in all coordinates, is a missing point: see the option `gaps`.
        fps : float, optional
            Frames per second; by default given by `times`.
        names : sequence of str, optional
            One for each point.
        confidence : array-like of shape (frames, points), optional
            0: missing, and so are points below `min_confidence`.
        times : array-like of shape (frames,), optional
            Seconds, increasing. If they are uneven, the clip is resampled to the rate of the usual
            step, and a note says so. If `fps` is given too, both must agree within 1 %.
        min_confidence : float, optional
            As the option of that name: by default 0.6.

        Examples
        --------
        >>> import numpy as np
        >>> import stltsa
        >>> stltsa.Clip.from_points(np.ones((120, 5, 3)), fps=60)
        <Clip: 120 frames, 2.00 s at 60 fps, 15 channels>
        """
        return cls(
            points_handle(
                positions,
                fps=fps,
                names=names,
                confidence=confidence,
                times=times,
                min_confidence=min_confidence,
            )
        )

    @classmethod
    def from_skeleton(
        cls,
        names: Sequence[str],
        parents: Sequence[int],
        offsets: npt.ArrayLike,
        rotations: npt.ArrayLike,
        fps: float,
        *,
        root_positions: npt.ArrayLike | None = None,
        channels: Sequence[str | None] | None = None,
        end_sites: Sequence[bool] | None = None,
    ) -> Clip:
        """Return a clip of a skeleton; all is copied.

        Parameters
        ----------
        names, parents, offsets
            Of each joint: its name, the index of its parent (an earlier joint; -1: the root, which
            is joint 0), and its offset from the parent in the parent's axes; shape (joints, 3).
        rotations : array-like
            Of shape (frames, joints, 4): quaternions w x y z, child axes to parent axes; (frames,
            joints, 3, 3): rotation matrices; (frames, channels): a value for each channel. Joints
            below the root that move against their parents need channels: rotations alone leave
            them at their offsets.
        fps : float
            Frames per second.
        root_positions : array-like of shape (frames, 3), optional
            Of the root; by default it stays at its offset, or the channels say where it is.
        channels : sequence of str, optional
            The values of each joint in a file, such as ``"tx ty tz rz rx ry"``: positions, and
            angles in degrees about moving axes. By default ``"rz rx ry"``, with positions before
            them for the root; none for end sites.
        end_sites : sequence of bool, optional
            Which joints are ends of chains, without rotation.

        Examples
        --------
        >>> import stltsa
        >>> clip = stltsa.read_clip("walker.bvh")
        >>> again = stltsa.Clip.from_skeleton(
        ...     clip.joints, clip.parents, clip.offsets, clip.features("raw"), clip.fps,
        ...     channels=clip.joint_channels, end_sites=clip.end_sites,
        ... )
        >>> bool((again.positions == clip.positions).all())
        True
        """
        return cls(
            skeleton_handle(
                names,
                parents=parents,
                offsets=offsets,
                rotations=rotations,
                fps=fps,
                root_positions=root_positions,
                channels=channels,
                end_sites=end_sites,
            )
        )

    @classmethod
    def from_array(cls, frames: npt.ArrayLike, fps: float) -> Clip:
        """Return a clip of plain numbers, which are copied.

        Parameters
        ----------
        frames : array-like of shape (frames, channels)
            Finite numbers, one row per frame.
        fps : float
            Frames per second, 1e-9 to 1e6.

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
        return cls(new("clip", lib.stltsa_clip_from_matrix, read_from(array), float(fps)))

    def _read_from(self, path: os.PathLike[str]) -> Clip:
        """Set the path of a clip that was just made from arrays, and return the clip."""
        self.path = os.fspath(path)
        check(lib.stltsa_clip_set_path(self._handle, c_path(path)))
        return self

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
        """``"bvh"``, ``"csv"``, ``"c3d"``, ...; of arrays: matrix, points or skeleton."""
        return self._text("format")

    @property
    def channels(self) -> int:
        """Numbers per frame in the file."""
        return self._int("channels")

    @cached_property
    def _joints(self) -> tuple[Joint, ...]:
        return self._list("joint")

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of joints and end sites in file order, parents first; empty without a skeleton."""
        return tuple(joint.name for joint in self._joints)

    @property
    def parents(self) -> IntArray:
        """Index of the parent of each joint, -1 for the root; shape (joints,)."""
        return np.array([joint.parent for joint in self._joints], dtype=np.int64)

    @property
    def end_sites(self) -> npt.NDArray[np.bool_]:
        """Which of the joints are end sites; shape (joints,)."""
        return np.array([joint.is_end_site for joint in self._joints], dtype=np.bool_)

    @property
    def offsets(self) -> FloatArray:
        """Offset of each joint from its parent, in the parent's axes; shape (joints, 3)."""
        return np.array([joint.offset for joint in self._joints], np.float64).reshape(-1, 3)

    @property
    def joint_channels(self) -> tuple[str | None, ...]:
        """Values of each joint in the file, such as ``"tx ty tz rz rx ry"``.

        None if the skeleton is that of an ASF file, whose axes this does not describe.
        """
        return tuple(joint.channels for joint in self._joints)

    @property
    def events(self) -> tuple[FileEvent, ...]:
        """The events that the file states, in order of time."""
        return self._list("file_event")

    def stretch(self, what: str, **options: Unpack[Options]) -> Clip:
        """Return a stretch of the clip, whose frames count from 0 again.

        Parameters
        ----------
        what : str
            ``"300-900"`` (frames), ``"2.5s-9s"``, ``"cyclic"`` and other kinds of units (the
            longest), ``"cycle3"``, ``"segment2"``, ``"repetition1"`` (counted from 1), ``"best"``,
            ``"representative"``, or a label such as ``"A"`` (all its segments, in order). A path
            may end in the same: ``read_clip("walk.bvh:cyclic")``.
        **options
            As for :func:`stltsa.decompose`, which all but the first two need.

        Raises
        ------
        stltsa.NoSuchPartError
            The clip lacks it.
        """
        text, rate = c_text(what, "what"), working_rate(self.fps, options)
        given = lib.stltsa_clip_stretch, self._handle, text
        handle = made("clip", *given, options=options, rate=rate)
        return Clip(handle, self.path and f"{self.path}:{what}")

    def mirrored(self, **options: Unpack[Options]) -> Clip:
        """Return the mirror image: what the left side did, the right one does.

        Joints or points whose names differ in the side only change places. Events that are marked
        on one side are found on the other in the phase of the mirror image. Used: `up_axis`.
        """
        return Clip(made("clip", lib.stltsa_clip_mirror, self._handle, options=options), self.path)

    def _per_joint(self, name: str) -> FloatArray:
        if not self._joints:
            text = f"a clip of numbers has no skeleton, and so no {name}"
            raise UnsupportedError(text, lib.STLTSA_E_UNSUPPORTED, "STLTSA_E_UNSUPPORTED")
        result = self._array(name).reshape(len(self), len(self._joints), -1)
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
        return self._per_joint("positions")

    @cached_property
    def rotations(self) -> FloatArray:
        """Local rotations of all joints as quaternions w x y z; (frames, joints, 4).

        Their signs are continuous over time. Read-only, computed once.

        Raises
        ------
        stltsa.UnsupportedError
            The clip has no skeleton.
        """
        return self._per_joint("rotations")

    def features(
        self,
        features: Features | Auto | None = "auto",
        *,
        up_axis: UpAxis | Auto | None = "auto",
    ) -> FloatArray:
        """Return the features of all poses; shape (frames, features), unsmoothed.

        Parameters
        ----------
        features : {"auto", "positions", "rotations6d", "euler", "raw", "points"}
            ``"positions"``: joint positions without the root's position and yaw; ``"rotations6d"``:
            two columns of each rotation matrix; ``"euler"``: the angles below the root in radians,
            as in the paper; ``"raw"``: the file's numbers; ``"points"``: points such as markers,
            without their mean, and without the heading if that is well defined. ``"auto"``:
            positions if there is a skeleton, points if the clip has points (or columns named
            heel_x, heel_y, heel_z, ...), otherwise raw.
        up_axis : {"auto", "x", "y", "z"}
            The axis that points up.
        """
        with Call({"features": features, "up_axis": up_axis}) as call:
            count = ffi.new("int64_t *")
            call.check(lib.stltsa_clip_feature_count(self._handle, call.options, count))
            result = columns(len(self), count[0])
            call.check(lib.stltsa_clip_features(self._handle, call.options, write_to(result)))
        return result

    def save(self, path: str | os.PathLike[str], *, progress: Progress = False) -> None:
        """Write the clip, completely or not at all; the suffix determines the format.

        ``.bvh``: any skeleton; ``.amc``: clips read from AMC, with their ASF file beside it;
        ``.csv`` and ``.npy``: the numbers of any clip. Numbers read back to the same bits.
        ``.glb``: glTF binary, skeleton and animation or moving points, for other programs.
        ``.c3d``: points in space with their events, by ezc3d (``stltsa[c3d]``).

        Parameters
        ----------
        path : path-like
            Of the file, which is replaced if it exists.
        progress : bool or callable
            As for :func:`stltsa.decompose`.

        Raises
        ------
        stltsa.ArgumentError
            The suffix is none of these.
        stltsa.UnsupportedError
            The clip has no skeleton, or no frame rate although the format needs one.
        stltsa.FileError
            The file cannot be written.
        """
        if Path(path).suffix.lower() == ".c3d":
            _exports.save_c3d(self, Path(path))
            return
        with Call({"progress": progress}) as call:
            call.check(lib.stltsa_clip_save(self._handle, c_path(path), call.options))

    def __repr__(self) -> str:
        seconds = f", {self.duration:.2f} s at {self.fps:g} fps" if self.fps else ""
        joints = f"{len(self._joints)} joints, " if self._joints else ""
        name = f" {Path(self.path).name}" if self.path else ""
        return f"<Clip{name}: {len(self)} frames{seconds}, {joints}{self.channels} channels>"

    def _repr_html_(self) -> str:
        return _html.clip(self)


def read_clip(path: str | os.PathLike[str], **options: Unpack[Options]) -> Clip:
    """Read a clip: BVH, ASF/AMC, CSV, NPY, C3D, TRC, MOT, STO; by another reader AMASS ``npz``.

    Parameters
    ----------
    path : path
        The suffix determines the format, or else the content. The ASF file of an AMC file is found
        in its folder by subject number; the option `skeleton` names another one. A stretch of the
        clip may follow, as in ``"walk.bvh:2.5s-9s"``: see :meth:`Clip.stretch`.
    **options
        Used: `fps` (replaces the rate of the file, with a note), `skeleton`, `individual` (one of
        several people or animals in the file), `min_confidence`, `progress`.

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
        The file contains an infinity, or a NaN where rotations are.
    ImportError
        The package that reads the format is not installed; the text says how.

    Examples
    --------
    >>> import stltsa
    >>> clip = stltsa.read_clip("walker.bvh")
    >>> clip.positions.shape == (len(clip), len(clip.joints), 3)
    True
    """
    text = os.fspath(path)
    name, _, what = text.rpartition(":")
    whole = not name or Path(text).exists() or not Path(name).exists()
    read = reader(Path(text if whole else name).suffix)
    if read is not None:
        fps = options.get("fps")
        file = Path(text if whole else name)
        clip: Clip = read(file, None if fps == "auto" else fps)._read_from(file)
        return clip if whole else clip.stretch(what, **_without_rate(options))
    return Clip(made("clip", lib.stltsa_clip_open_stretch, c_path(path), options=options), text)


def _without_rate(options: Any) -> Any:
    return {key: value for key, value in options.items() if key != "fps"}


def _some(options: Options, *names: str) -> Any:
    return {key: value for key, value in options.items() if key in names}


def opened(motion: Any, options: Options) -> Any:
    """Return the clip at a path, of points or of a dataset, and anything else unchanged."""
    if is_dataset(motion):
        from .readers.movement import from_dataset  # it needs this module

        used = _some(options, "fps", "min_confidence", "individual")
        return from_dataset(motion, **used)
    is_path = isinstance(motion, str | os.PathLike)
    chosen = options.get("individual", "auto") not in (None, "auto")
    if chosen and not (is_path or isinstance(motion, Clip)):
        raise wrong("X", motion, "a path or a dataset if individual= is given")
    rate = rate_given(options)
    if rate and is_points(motion):
        return Clip.from_points(motion, rate, **_some(options, "min_confidence"))
    if not is_path:
        return motion
    return read_clip(motion, **_some(options, "fps", "skeleton", "individual", "min_confidence"))


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
