# SPDX-License-Identifier: BSD-3-Clause
"""Texts from the library, paths for it, and tables."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ._given import wrong
from ._native import ffi, lib

if TYPE_CHECKING:
    from collections.abc import Iterable

_MOST_LABELS = 2**63 - 1  # their numbers are int64_t


def string(text: Any) -> str:
    """Return a text that the library owns; an empty one for NULL."""
    return str(ffi.string(text).decode("utf-8", "replace")) if text else ""


def names(prefix: str) -> dict[int, str]:
    """Return the names of the header's constants with a prefix, by value: ``{1: "bvh", ...}``."""
    found = (n for n in dir(lib) if n.startswith(prefix))
    return dict(sorted((getattr(lib, n), n[len(prefix) :].lower()) for n in found))


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


def number_of(label: str) -> int:
    """Return the number of a label: 0 for A, 26 for AA."""
    if not (isinstance(label, str) and label.isascii() and label.isalpha() and label.isupper()):
        raise ValueError(f"label is {label!r}, and must be letters such as 'A'")
    number = 0
    for letter in label:
        number = 26 * number + ord(letter) - ord("A") + 1
    if number > _MOST_LABELS:
        raise ValueError(f"label is {label!r}, and no motion has so many labels")
    return number - 1
