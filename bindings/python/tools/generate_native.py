#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the C source of stltsa._native: the declarations of stltsa.h, for cffi in API mode.

Usage: generate_native.py stltsa.h OUTPUT.c

The declarations are the header's own, without the parts that only a compiler reads, so they cannot
differ from it; the compiler checks each of them again when it compiles OUTPUT.c.
"""

import pathlib
import re
import sys

from cffi import FFI

CALLBACK = """
extern "Python" int32_t on_progress(void *user, int32_t stage, double fraction);
"""


def declarations(header: str) -> str:
    """Return the header's declarations, without comments, preprocessor lines and decoration."""
    text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    text = re.sub(r"^[ \t]*#(?:.*\\\n)*.*$", "", text, flags=re.MULTILINE)
    text = re.sub(r'extern "C" \{(.*)\}', r"\1", text, flags=re.DOTALL)
    return re.sub(r"\bSTLTSA_(API|NOEXCEPT)\b", "", text)


def main(header: str, output: str) -> None:
    ffi = FFI()
    ffi.cdef(declarations(pathlib.Path(header).read_text(encoding="utf-8")) + CALLBACK)
    ffi.set_source("stltsa._native", "#include <stltsa.h>")
    ffi.emit_c_code(output)


if __name__ == "__main__":
    main(*sys.argv[1:])
