# SPDX-License-Identifier: BSD-3-Clause
"""Tables of results: pandas DataFrames if pandas is installed, else NumPy record arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, get_type_hints

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence


def table(rows: Sequence[NamedTuple], kind: type[NamedTuple]) -> Any:
    """Return a DataFrame with a column per field of `kind`, or a record array without pandas.

    ``table["begin"]`` and ``table.begin`` read a column of both.
    """
    fields = {name: [getattr(row, name) for row in rows] for name in kind._fields}
    try:
        import pandas as pd
    except ImportError:
        return _records(fields, kind)
    dtypes = {n: t for n, t in _dtypes(kind).items() if t not in "UO"}
    return pd.DataFrame(fields).astype(dtypes)


def _dtypes(kind: type[NamedTuple]) -> dict[str, str]:
    codes = {int: "i8", float: "f8", str: "U", bool: "?"}
    return {name: codes.get(type_, "O") for name, type_ in get_type_hints(kind).items()}


def _records(fields: dict[str, list[Any]], kind: type[NamedTuple]) -> Any:
    arrays = [_array(fields[name], code) for name, code in _dtypes(kind).items()]
    dtype = [(name, array.dtype) for name, array in zip(fields, arrays, strict=True)]
    return np.rec.fromarrays(arrays, dtype=np.dtype(dtype))


def _array(values: list[Any], code: str) -> Any:
    if code != "O":
        return np.array(values, dtype=code)
    array = np.empty(len(values), dtype=object)  # np.array would make tuples a second dimension
    array[:] = values
    return array
