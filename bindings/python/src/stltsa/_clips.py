# SPDX-License-Identifier: BSD-3-Clause
"""Several clips in one matrix, as the library expects them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._arrays import IntArray, as_matrix

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy.typing as npt


def is_sequence_of_clips(values: Any) -> bool:
    """Distinguish a list of matrices, one per clip, from a matrix written as a list."""
    return (
        isinstance(values, list | tuple)
        and len(values) > 0
        and all(getattr(v, "ndim", 0) == 2 for v in values)
    )


def stack_clips(clips: Sequence[Any], groups: Any) -> tuple[npt.NDArray[Any], IntArray]:
    """Return the frames of several clips one after another, and the number of frames of each."""
    refuse_groups(groups, "a list has a clip in each array")
    matrices = [as_matrix(c, f"X[{i}]") for i, c in enumerate(clips)]
    _check_names(clips)
    widths = {m.shape[1] for m in matrices}
    if len(widths) > 1:
        raise ValueError(f"the clips have different numbers of columns: {sorted(widths)}")
    lengths = np.array([len(m) for m in matrices], dtype=np.int64)
    return (matrices[0] if len(matrices) == 1 else np.concatenate(matrices)), lengths


def _check_names(clips: Sequence[Any]) -> None:
    """Refuse DataFrames with different columns, whose numbers would get the names of others."""
    names = {tuple(clip.columns) for clip in clips if hasattr(clip, "columns")}
    if len(names) > 1:
        raise ValueError("the clips have different columns, or the same ones in another order")


def refuse_groups(groups: Any, why: str) -> None:
    """Refuse row labels that would be ignored."""
    if groups is not None:
        raise ValueError(f"groups= is for one array of all rows: {why}")


def group_lengths(groups: Any, rows: int) -> IntArray:
    """Return the number of rows of each clip, from a label for each row.

    The rows of one clip must be contiguous; a label that reappears later is an error.
    """
    labels = np.asarray(groups)
    if labels.shape != (rows,):
        raise ValueError(
            f"groups must have a label for each of the {rows} rows; its shape is {labels.shape}"
        )
    if np.not_equal(labels, labels).any():  # only NaN and NaT differ from themselves
        raise ValueError("groups must have a label for each row; some are NaN")
    if rows == 0:
        return np.zeros(0, dtype=np.int64)
    starts = np.concatenate(([0], np.flatnonzero(labels[1:] != labels[:-1]) + 1, [rows]))
    if len(set(labels[starts[:-1]].tolist())) != len(starts) - 1:
        raise ValueError("the rows of one group must stand together, in order of time")
    return np.diff(starts).astype(np.int64)


def frames_and_lengths(motion: Any, groups: Any = None) -> tuple[npt.NDArray[Any], IntArray | None]:
    """Return all frames, and the number of frames of each clip if there are several."""
    if is_sequence_of_clips(motion):
        return stack_clips(motion, groups)
    frames = as_matrix(motion)
    return frames, None if groups is None else group_lengths(groups, len(frames))
