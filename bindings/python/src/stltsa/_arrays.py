# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays as the library's ``stltsa_in`` and ``stltsa_out``: seen in place, not copied."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib

if TYPE_CHECKING:
    from collections.abc import Sequence

FloatArray: TypeAlias = npt.NDArray[np.float64]
IntArray: TypeAlias = npt.NDArray[np.int64]

_DTYPES = {np.dtype(np.float32): lib.STLTSA_F32, np.dtype(np.float64): lib.STLTSA_F64}


def as_matrix(values: Any, what: str = "X") -> npt.NDArray[Any]:
    """Return `values` as a 2-D array that the library can read.

    float32 and float64 of any strides stay where they are; other numbers become float64.
    """
    array = np.asarray(values)
    if np.iscomplexobj(array):
        raise ValueError(f"Complex data not supported: {what} is complex")
    if array.dtype not in _DTYPES:
        array = array.astype(np.float64)
    if array.ndim != 2:
        raise ValueError(
            f"{what} must be 2-D, a row per frame; it has the shape {array.shape}. "
            f"Reshape your data: {what}.reshape(-1, 1) is one column"
        )
    if array.strides == (0, 0):  # a broadcast array; to the library that means packed rows
        array = array.copy()
    return array


def _fill(struct: Any, array: npt.NDArray[Any]) -> Any:
    struct.data = ffi.cast("void *", array.__array_interface__["data"][0])
    struct.rows, struct.cols = array.shape
    struct.row_stride, struct.col_stride = array.strides
    struct.dtype = _DTYPES[array.dtype]
    return struct


def read_from(array: npt.NDArray[Any]) -> Any:
    """Return a ``stltsa_in *`` of an array, which the caller keeps alive during the call."""
    return _fill(ffi.new("stltsa_in *"), array)


def write_to(array: FloatArray) -> Any:
    """Return a ``stltsa_out *`` of an array, which the caller keeps alive during the call."""
    return _fill(ffi.new("stltsa_out *"), array)


def columns(rows: int, cols: int) -> FloatArray:
    """Return an empty matrix for the library to fill."""
    return np.empty((rows, cols), dtype=np.float64)


def int64_pointer(array: IntArray | None) -> Any:
    """Return an ``int64_t *`` of an array, NULL for none; the caller keeps the array alive."""
    if array is None:
        return ffi.NULL
    return ffi.cast("int64_t *", array.__array_interface__["data"][0])


def as_integers(values: Any, rows: int, what: str) -> IntArray:
    """Return `values` as a packed array of `rows` integers."""
    given = np.asarray(values)
    if given.dtype.kind not in "iu" or given.shape != (rows,):
        raise ValueError(
            f"{what} must be {rows} integers, one a row; "
            f"it is {given.dtype} of the shape {given.shape}"
        )
    return np.ascontiguousarray(given, dtype=np.int64)


def is_sequence_of_clips(values: Any) -> bool:
    """Tell a list of matrices, one for each clip, from a matrix written as a list."""
    return (
        isinstance(values, list | tuple)
        and len(values) > 0
        and all(getattr(v, "ndim", 0) == 2 for v in values)
    )


def stack_clips(clips: Sequence[Any]) -> tuple[npt.NDArray[Any], IntArray]:
    """Return the frames of several clips one after another, and how many each has."""
    matrices = [as_matrix(c, f"X[{i}]") for i, c in enumerate(clips)]
    widths = {m.shape[1] for m in matrices}
    if len(widths) > 1:
        raise ValueError(f"the clips have different numbers of columns: {sorted(widths)}")
    lengths = np.array([len(m) for m in matrices], dtype=np.int64)
    return (matrices[0] if len(matrices) == 1 else np.concatenate(matrices)), lengths


def group_lengths(groups: Any, rows: int) -> IntArray:
    """Return how many rows each clip has, from a label for each row.

    The rows of one clip stand together; a label that comes back later is an error.
    """
    labels = np.asarray(groups)
    if labels.shape != (rows,):
        raise ValueError(
            f"groups must have a label for each of the {rows} rows; its shape is {labels.shape}"
        )
    if rows == 0:
        return np.zeros(0, dtype=np.int64)
    starts = np.concatenate(([0], np.flatnonzero(labels[1:] != labels[:-1]) + 1, [rows]))
    if len(np.unique(labels)) != len(starts) - 1:
        raise ValueError("the rows of one group must stand together, in order of time")
    return np.diff(starts).astype(np.int64)
