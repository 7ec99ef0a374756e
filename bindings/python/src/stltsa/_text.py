# SPDX-License-Identifier: BSD-3-Clause
"""Texts from the library, paths for it, and tables."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ._given import wrong
from ._native import ffi, lib

if TYPE_CHECKING:
    from collections.abc import Iterable


def string(text: Any) -> str:
    """Return a text that the library owns."""
    return str(ffi.string(text).decode("utf-8", "replace"))


def names(prefix: str) -> dict[int, str]:
    """Return the names of the header's constants with a prefix, by value: ``{1: "bvh", ...}``."""
    return {getattr(lib, n): n[len(prefix) :].lower() for n in dir(lib) if n.startswith(prefix)}


def csv_text(head: Iterable[str], lines: Iterable[Iterable[Any]]) -> str:
    """Return a CSV table with the cells of the command's tables.

    A text that a spreadsheet would evaluate gets an apostrophe before it, and one with a separator
    of any country is quoted.
    """

    def cell(value: Any) -> str:
        text = str(value)
        if isinstance(value, str) and text.lstrip("'").startswith(tuple("=+-@\t\r")):
            text = f"'{text}"
        quoted = text.replace('"', '""')
        return f'"{quoted}"' if any(c in text for c in ',;\t"\n\r') else text

    return "".join(",".join(map(cell, line)) + "\n" for line in (head, *lines))


def c_text(text: Any, what: str) -> Any:
    """Return a text for C, which must be kept while C uses it; `what` names it in errors."""
    if not isinstance(text, str):
        raise wrong(what, text, "a string")
    if "\0" in text:
        raise ValueError(f"{what} is {text!r}: there is a zero in it")
    return ffi.new("char[]", text.encode())


def c_path(path: str | os.PathLike[str]) -> bytes:
    """Return a path for C; refuse one with a zero byte, which would name another file."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise ValueError(f"{path!r} is not a path: there is a zero in it")
    return name
