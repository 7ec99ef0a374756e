#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the header says of each option and fact what the library's tables say at run time. Of
an option with named values the header names their constants instead."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADER = (ROOT / "include/stltsa.h").read_text(encoding="utf-8")
TABLES = {"STLTSA_OPT_": "src/capi/options/table.cpp", "STLTSA_INFO_": "src/capi/info/keys.cpp"}


def plain(text):
    """A text in one line, without the first capital letter and the last period."""
    text = " ".join(text.split()).rstrip(".")
    return text[:1].lower() + text[1:]


def in_header(prefix):
    """The text of each constant, after its type."""
    comment = re.compile(rf"\b({prefix}\w+) = \d+,?\s*/\* \w+\S*\s+(.*?) \*/", re.DOTALL)
    return {name: plain(text) for name, text in comment.findall(HEADER)}


def in_table(path):
    """The text of each row, and whether the row has named values."""
    rows = re.findall(r'\b(?:whole|real|text|list|array)\((STLTSA_\w+),[^"]*"\w+",\s*((?:"[^"]*"\s*)+)(.*?)\)[,;]\n',
                      (ROOT / path).read_text(encoding="utf-8"), re.DOTALL)  # fmt: skip
    return {name: (plain("".join(re.findall('"([^"]*)"', text))), '"' in rest) for name, text, rest in rows}


def complaints():
    for prefix, path in TABLES.items():
        header, table = in_header(prefix), in_table(path)
        for name in sorted(header.keys() ^ table.keys()):
            yield f"{name} is not in the header and in {path}"
        for name in sorted(header.keys() & table.keys()):
            said, (text, named) = header[name], table[name]
            if said != text and not (named and prefix == "STLTSA_OPT_"):
                yield f"{name}: the header says\n  {said}\nand {path}\n  {text}"


if __name__ == "__main__":
    found = list(complaints())
    print("\n".join(found) or "the header and the tables say the same")
    sys.exit(bool(found))
