#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a C++ source file from a page of HTML and the files that it includes.

Usage: embed.py FUNCTION page.html template.cpp template.d

A line <!-- include FILE --> is replaced by that file, which may include others; the data come at the line
<!-- data -->. The last file lists what was read, for Ninja.
"""

import re
import sys
from pathlib import Path

PIECE = 32000  # characters of a string literal, about; compilers must accept 65536 bytes


def literals(text):
    """Return C++ string literals of whole lines, each followed by a comma, that together are the text."""
    pieces = [""]
    for line in text.splitlines(keepends=True):
        if len(pieces[-1]) + len(line) > PIECE:
            pieces.append("")
        pieces[-1] += line
    return "\n".join(f'    R"stltsa({piece})stltsa",' for piece in pieces)


def main(function, page, source, depfile):
    page = Path(page)
    read = []

    def whole(path):
        read.append(path)
        text = path.read_text(encoding="utf-8")
        return re.sub(r"<!-- include (\S+) -->\n", lambda match: whole(path.parent / match[1]), text)

    before, after = whole(page).split("<!-- data -->\n")
    Path(source).write_text(
        '#include "report/template.hpp"\n\n'
        "namespace stltsa::report {\nnamespace {\n\n"
        f"constexpr std::string_view before[] = {{\n{literals(before)}\n}};\n"
        f"constexpr std::string_view after[] = {{\n{literals(after)}\n}};\n\n"
        "} // namespace\n\n"
        f"Template {function}() {{\n    return {{before, after}};\n}}\n\n"
        "} // namespace stltsa::report\n",
        encoding="utf-8",
    )
    Path(depfile).write_text(f"{source}: {' '.join(map(str, read))}\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
