# SPDX-License-Identifier: BSD-3-Clause
"""New motion from pieces of clips (the paper, section 4)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from ._call import made
from ._facts import Described
from ._given import wrong
from ._native import ffi, lib
from ._rows import Seam
from ._tables import table
from .clip import Clip
from .decomposition import Decomposition, decompose

if TYPE_CHECKING:
    from collections.abc import Iterable

    from pandas import DataFrame
    from typing_extensions import Unpack

    from ._given import Motion
    from ._options import Options
    from ._rows import Part, Segment, Unit


class Piece(NamedTuple):
    """Frames ``[begin, end)`` of a clip, `repeat` times.

    Examples
    --------
    >>> import stltsa
    >>> result = stltsa.decompose("walker.bvh")
    >>> stltsa.Piece.of(result.clip, result.best_cycle, repeat=3).repeat
    3
    """

    clip: Clip
    begin: int
    end: int
    repeat: int = 1

    @classmethod
    def of(cls, clip: Clip, interval: Unit | Segment | Part, repeat: int = 1) -> Piece:
        """Return the frames of a unit or a cycle as a piece."""
        if not isinstance(clip, Clip):
            raise wrong("clip", clip, "a Clip: call read_clip")
        if not hasattr(interval, "begin"):
            raise wrong(
                "interval", interval, "a row such as result.best_cycle or result.unit_list[0]"
            )
        return cls(clip, interval.begin, interval.end, repeat)


_USED = ("crossfade", "cut_range", "posture_limit", "loop", "in_place", "up_axis", "progress")
_Given: TypeAlias = Piece | tuple[Clip, int, int] | tuple[Clip, int, int, int]


def synthesize(pieces: Iterable[_Given], **options: Unpack[Options]) -> Synthesis:
    """Join pieces of clips, in order, into a new clip.

    Cuts move to a common posture and are crossfaded; the body continues from its position and
    heading. Joining the units of a clip in order restores the clip.

    Parameters
    ----------
    pieces : iterable of Piece, or of tuples (clip, begin, end) or (clip, begin, end, repeat)
        All clips need the same hierarchy; the first one gives frame rate and units.
    **options
        Used: `crossfade`, `cut_range` (both in seconds), `posture_limit`, `loop`, `in_place`,
        `up_axis`, `progress`. With `loop` the last frame meets the first; with `in_place` as well,
        the loop ends where it starts.

    Returns
    -------
    Synthesis

    Raises
    ------
    stltsa.NoCommonPostureError
        Two pieces have no common posture; the text says at which seam and by how much.
    stltsa.UnsupportedError
        A clip has plain numbers, a different hierarchy, or no frame rate.

    Examples
    --------
    >>> import stltsa
    >>> result = stltsa.decompose("walker.bvh")
    >>> cycle = result.representative_cycle
    >>> longer = stltsa.synthesize([stltsa.Piece.of(result.clip, cycle, repeat=5)])
    >>> len(longer.clip) > 4 * (cycle.end - cycle.begin)
    True
    """
    wanted = [_as_piece(piece) for piece in pieces]
    raw = ffi.new("stltsa_piece[]", len(wanted))
    for target, piece in zip(raw, wanted, strict=True):
        target.clip = piece.clip._handle
        target.begin, target.end, target.repeat = piece.begin, piece.end, piece.repeat
    given = lib.stltsa_synthesize, raw, len(wanted)
    return Synthesis(made("synthesis", *given, options=options))


def synthesize_loop(motion: Decomposition | Motion, **options: Unpack[Options]) -> Synthesis:
    """Make the loop of a clip: the most of its consecutive cycles whose ends meet.

    Without cycles it is the whole clip. The facts `note`, `coverage` and `travel` say which part of
    the clip it is, and how far it goes.

    Parameters
    ----------
    motion : Decomposition, or what :func:`stltsa.decompose` takes
        Of a clip with a skeleton.
    **options
        Used: those of :func:`stltsa.decompose` if `motion` is not decomposed yet, and those of
        :func:`stltsa.synthesize`.

    Returns
    -------
    Synthesis

    Raises
    ------
    stltsa.NoCommonPostureError
        The ends do not meet; the text says by how much.
    stltsa.UnsupportedError
        The clip has plain numbers.

    Examples
    --------
    >>> import stltsa
    >>> loop = stltsa.synthesize_loop("walker.bvh", in_place=True)
    >>> loop.facts["loop_cycles"], loop.facts["source_cycles"]
    (3, 3)
    >>> loop.seam_list[-1].frame == len(loop.clip)
    True
    """
    found = motion if isinstance(motion, Decomposition) else decompose(motion, **options)
    used = {name: value for name, value in options.items() if name in _USED}
    given = lib.stltsa_synthesize_loop, found.clip._handle, found._handle
    return Synthesis(made("synthesis", *given, options=used))


def _as_piece(values: Any) -> Piece:
    """Return the argument as a piece of a Clip."""
    if isinstance(values, tuple | list) and values and isinstance(values[0], Clip):
        return Piece(*values)
    wanted = "a Piece, such as Piece.of(clip, cycle), or a tuple (Clip, begin, end[, repeat])"
    raise wrong("a piece", values, wanted)


class Synthesis(Described):
    """A new clip and measures of its seams."""

    _kind = "synthesis"

    @property
    def clip(self) -> Clip:
        """The new clip."""
        return Clip(lib.stltsa_synthesis_clip(self._handle), owner=self)

    @property
    def seam_list(self) -> tuple[Seam, ...]:
        """The seams in temporal order."""
        return self._list("seam")

    @property
    def seams(self) -> DataFrame:
        """The seams as a table: a DataFrame with pandas, otherwise a NumPy record array."""
        return table(self.seam_list, Seam)

    def __repr__(self) -> str:
        return f"<Synthesis: {len(self.clip)} frames, {len(self.seam_list)} seams>"
