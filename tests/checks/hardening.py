#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks with readelf how the library and the command are linked, as installed from a build.

Usage: hardening.py BUILD
       hardening.py --debian FOLDER

Always checked: the stack is not executable, there are no text relocations, relocations are read-only
after startup (RELRO), there are no search paths (RPATH, RUNPATH), and the command is
position-independent.
--debian: Debian's packages, unpacked in FOLDER, must also have all symbols bound at startup (BIND_NOW), the
stack protector and checked functions (_FORTIFY_SOURCE).
"""

import pathlib
import re
import subprocess
import sys
import tempfile


def readelf(option, file):
    command = ["readelf", "--wide", option, str(file)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def complaints(file, of_debian):
    headers, dynamic = readelf("--program-headers", file), readelf("--dynamic", file)
    symbols = readelf("--dyn-syms", file)
    stack = re.search(r"GNU_STACK.*\s([R W E]{3})\s+0x", headers)
    if stack is None or "E" in stack[1]:
        yield "the stack is executable"
    if "TEXTREL" in dynamic:
        yield "there are text relocations"
    if "GNU_RELRO" not in headers:
        yield "relocations stay writable (no RELRO)"
    if "DYN" not in readelf("--file-header", file):
        yield "it is not position-independent"
    for path in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", dynamic):
        yield f"libraries are searched in {path}"
    for segment in re.findall(r"^\s+LOAD.*\s([R W E]{3})\s+0x", headers, re.MULTILINE):
        if "W" in segment and "E" in segment:
            yield "a segment is writable and executable"
    if not of_debian:
        return
    if not re.search(r"BIND_NOW|\bNOW\b", dynamic):
        yield "symbols are bound at their first use (no BIND_NOW)"
    if "__stack_chk_fail" not in symbols:
        yield "there is no stack protector"
    if not re.search(r"__\w+_chk\b", symbols.replace("__stack_chk", "")):
        yield "no function is checked (_FORTIFY_SOURCE)"


def install(build, folder):
    subprocess.run(["meson", "install", "-C", build, "--no-rebuild", "--quiet", "--tags", "runtime",
                    "--destdir", folder], check=True, stdout=subprocess.DEVNULL)


def installed(folder):
    """The library and the command below the folder."""
    found = [file for name in ("libstltsa.so.0", "stltsa")
             for file in pathlib.Path(folder).rglob(name) if file.is_file()]
    if [file.name for file in found] != ["libstltsa.so.0", "stltsa"]:
        sys.exit(f"{folder}: the library and the command are not both installed")
    return found


def main(arguments):
    of_debian = "--debian" in arguments
    with tempfile.TemporaryDirectory() as folder:
        if not of_debian:
            install(arguments[0], folder)
        found = [(file.name, text) for file in installed(arguments[-1] if of_debian else folder)
                 for text in complaints(file, of_debian)]
    for name, text in found:
        print(f"{name}: {text}", file=sys.stderr)
    print(f"hardening: library and command{' with Debian flags' if of_debian else ''}, "
          f"{len(found)} complaints")
    return int(bool(found))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
