# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays as the library's ``stltsa_in`` and ``stltsa_out``, without a copy.

The library works on C-contiguous float64, and converts any other array itself.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from ._given import wrong
from ._native import ffi, lib

FloatArray: TypeAlias = npt.NDArray[np.float64]
IntArray: TypeAlias = npt.NDArray[np.int64]

_NUMBERS = {np.dtype(np.float32): lib.STLTSA_F32, np.dtype(np.float64): lib.STLTSA_F64}
_DTYPES = {**_NUMBERS, np.dtype(np.int64): lib.STLTSA_I64}


def as_matrix(values: Any, what: str = "X") -> npt.NDArray[Any]:
    """Return `values` as a 2-D array that the library can read.

    float32 and float64 with any strides are not copied; other numbers become float64.
    """
    try:
        array = np.asarray(unmasked(values))
    except ValueError as error:  # rows of different lengths, or different things
        several = isinstance(values, list | tuple)
        if several and all(getattr(each, "ndim", 0) == 2 for each in values):
            raise wrong(what, values, "one array: call it for each of them") from None
        raise ValueError(f"{what} must be an array with a row per frame: {error}") from error
    if array.ndim == 0:
        clips = ", a Clip or a path" if what.startswith("X") else ""
        raise wrong(what, values, f"a 2-D array with a row per frame{clips}")
    if np.iscomplexobj(array):
        raise ValueError(f"Complex data not supported: {what} is complex")
    if array.ndim != 2:
        reshaped = "reshape(-1, 1) is one column"
        if array.ndim > 2:
            reshaped = f"reshape(len({what}), -1) keeps a row per frame"
        raise ValueError(
            f"{what} must be 2-D, a row per frame; it is a {type(values).__name__} of the shape "
            f"{array.shape}. Reshape your data: {what}.{reshaped}"
        )
    if array.dtype not in _NUMBERS:
        array = _as_float64(array, what)
    if array.strides == (0, 0):  # a broadcast array; to the library that means packed rows
        array = array.copy()
    return array


def unmasked(values: Any) -> Any:
    """Return a masked array with NaN for masked values; the library reports their position."""
    if np.ma.is_masked(values):
        return values.astype(np.result_type(values.dtype, np.float64)).filled(np.nan)
    return values


def _as_float64(array: npt.NDArray[Any], what: str) -> FloatArray:
    """Convert numbers; refuse texts and dates, which NumPy would convert to numbers."""
    if array.dtype.kind not in "biufO":
        raise ValueError(f"{what} must hold numbers; it holds {array.dtype}")
    try:
        return array.astype(np.float64, order="C")
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(f"{what} must hold numbers: {error}") from error


def _fill(struct: Any, array: npt.NDArray[Any]) -> Any:
    struct.data = ffi.cast("void *", array.__array_interface__["data"][0])
    struct.rows, struct.cols = array.shape
    struct.row_stride, struct.col_stride = array.strides
    struct.dtype = _DTYPES[array.dtype]
    return struct


def read_from(array: npt.NDArray[Any]) -> Any:
    """Return a ``stltsa_in *`` of a matrix; the caller keeps the matrix alive during the call."""
    return _fill(ffi.new("stltsa_in *"), array)


def write_to(array: npt.NDArray[Any]) -> Any:
    """Return a ``stltsa_out *`` of a matrix; the caller keeps the matrix alive during the call."""
    return _fill(ffi.new("stltsa_out *"), array)


def columns(rows: int, cols: int) -> FloatArray:
    """Return an empty matrix for the library to fill."""
    return np.empty((rows, cols), dtype=np.float64)


def read_list(array: IntArray | None) -> Any:
    """Return a ``stltsa_in *`` of a packed list, one entry a row; NULL without one."""
    return ffi.NULL if array is None else read_from(array.reshape(-1, 1))


def write_list(array: npt.NDArray[Any]) -> Any:
    """Return a ``stltsa_out *`` of a packed list, one entry a row."""
    return write_to(array.reshape(-1, 1))


def as_integers(values: Any, rows: int, what: str) -> IntArray:
    """Return `values` as a packed array of `rows` integers."""
    given = np.asarray(values)
    if given.dtype.kind not in "iu" or given.shape != (rows,):
        raise ValueError(
            f"{what} must be {rows} integers, one a row; "
            f"it is {given.dtype} of the shape {given.shape}"
        )
    return np.ascontiguousarray(given, dtype=np.int64)
