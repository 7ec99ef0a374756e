# SPDX-License-Identifier: BSD-3-Clause
"""Tables of results: pandas DataFrames if pandas is installed, else NumPy record arrays."""

from __future__ import annotations

import shutil
import textwrap
from html import escape
from itertools import zip_longest
from typing import TYPE_CHECKING, Any, NamedTuple, cast, get_type_hints

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from pandas import DataFrame  # without pandas a table is a NumPy record array


def table(
    rows: Sequence[Any], kind: type[NamedTuple], marks: Mapping[str, Iterable[bool]] | None = None
) -> DataFrame:
    """Return a DataFrame with a column per field of `kind`, or a record array without pandas.

    ``table["begin"]`` and ``table.begin`` read a column of both. Rows within the rows have columns
    such as ``speed_mean``. Intervals have a column with their length in seconds, too. `marks` are
    more columns, by name.
    """
    fields = dict(_columns(rows, kind))
    if hasattr(kind, "duration_s"):
        fields["duration_s"] = "f8", [row.duration_s for row in rows]
    fields |= {name: ("?", list(values)) for name, values in (marks or {}).items()}
    try:
        import pandas as pd
    except ImportError:
        return cast("DataFrame", _records(fields))
    frame = pd.DataFrame({name: values for name, (_, values) in fields.items()})
    return frame.astype({name: code for name, (code, _) in fields.items() if code not in "UO"})


def frame(rows: Sequence[Any], kind: type[NamedTuple]) -> DataFrame:
    """Return a DataFrame; raise ImportError without pandas."""
    from .readers import extra

    extra("pandas", "tables")
    return table(rows, kind)


def aligned(rows: Sequence[Sequence[str]], widest: int = 28) -> str:
    """Return rows of texts as lines of the terminal's width, with texts wrapped in their column."""
    *columns, _ = zip(*rows, strict=True)
    widths = [min(widest, max(map(len, column))) for column in columns]
    room = shutil.get_terminal_size().columns - sum(widths) - 2 * len(widths)
    widths.append(max(30, room))
    lines = []
    for row in rows:
        cells = [textwrap.wrap(cell, width) for cell, width in zip(row, widths, strict=True)]
        for parts in zip_longest(*cells, fillvalue=""):
            padded = (part.ljust(width) for part, width in zip(parts, widths, strict=True))
            lines.append("  ".join(padded).rstrip())
    return "\n".join(lines)


def html_table(rows: Sequence[Sequence[str]]) -> str:
    """Return rows of texts as a table; the first is the head."""
    lines = [
        "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in row) + "</tr>"
        for row, tag in zip(rows, ["th", *["td"] * len(rows)], strict=False)
    ]
    return f"<table><thead>{lines[0]}</thead><tbody>{''.join(lines[1:])}</tbody></table>"


def _columns(
    rows: Sequence[Any], kind: type[Any], before: str = ""
) -> Iterator[tuple[str, tuple[str, list[Any]]]]:
    """Return name, dtype and values of each column."""
    codes = {int: "i8", float: "f8", str: "U", bool: "?"}
    for name, hint in get_type_hints(kind).items():
        values = [getattr(row, name) for row in rows]
        if hasattr(hint, "_fields"):
            yield from _columns(values, hint, f"{before}{name}_")
        else:
            full = before[:-1] if name == "value" else before + name
            yield full, (codes.get(hint, "O"), values)


def _records(fields: dict[str, tuple[str, list[Any]]]) -> Any:
    arrays = [_array(values, code) for code, values in fields.values()]
    dtype = [(name, array.dtype) for name, array in zip(fields, arrays, strict=True)]
    return np.rec.fromarrays(arrays, dtype=np.dtype(dtype))


def _array(values: list[Any], code: str) -> Any:
    if code != "O":
        return np.array(values, dtype=code)
    array = np.empty(len(values), dtype=object)  # np.array would make tuples a second dimension
    array[:] = values
    return array
