#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the project's rules that a compiler cannot check; prints each breach as file:line.

Includes in src/ go down the list of rooms and of their sub-rooms, never up; the command uses only the public headers.
The library does not print, exit, read the environment or depend on the locale. Files are short and
have a license line, and none contains a directory of a developer's machine.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Each room and the rooms that it may include.
ROOMS = {
    "base": {"base"},
    "linalg": {"base", "linalg"},
    "ltsa": {"base", "linalg", "ltsa"},
    "clip": {"base", "linalg", "clip"},
    "motion": {"base", "linalg", "ltsa", "motion"},
    "phase": {"base", "linalg", "motion", "phase"},
    "synthesis": {"base", "linalg", "clip", "motion", "synthesis"},
    "results": {"base", "linalg", "ltsa", "clip", "motion", "phase", "synthesis",
                "results", "stltsa.h"},
    "report": {"base", "linalg", "clip", "phase", "results", "report", "stltsa.h"},
    "capi": {"base", "linalg", "ltsa", "clip", "motion", "phase", "synthesis",
             "results", "report", "capi", "stltsa.h"},
}
# Within a room: what may include only what is named before it or with it. A name is a sub-folder,
# or sources of the room itself.
SUBROOMS = {
    "ltsa": ["parameters model", "frames", "search", "neighbors", "tangents", "alignment",
             "spectrum", "mapping", "graph", "warnings", "embed", "fit dimension"],
    "clip": ["clip foot_strikes", "text", "files", "body", "features", "arrays", "bvh", "acclaim", "csv", "opensim", "npy",
             "c3d", "gltf", "formats", "read write stretch"],
    "motion": ["curve", "period", "cycles", "behaviors", "recording"],
    "results": ["facts live texts source_frames", "postures samples parameters summary", "fitted", "denoised decomposed phased events strikes placed",
                "synthesized stretches turning", "mirror_image",
                "keep_cycle", "compared_columns", "compared comparison_warnings",
                "model_file"],
    "capi": ["boundary", "info", "handles", "options", "compared_rows", "json", "facts facts_of_results", "batch",
             "clip clip_arrays fit map dimension decompose denoise synthesize model_io phase compare events live report"],
}
MATHEMATICS = {"base", "linalg", "ltsa", "motion", "phase"}  # knows nothing of files

LONGEST_FILE = 500
# Files of src/ that the command is compiled with as well (src/meson.build).
SHARED = {"base/checkpoint.hpp", "base/formula.hpp", "base/json.hpp", "base/names.hpp", "base/npy_bytes.hpp", "base/side_name.hpp", "base/utf8.hpp", "clip/files/descriptor.hpp", "clip/files/replace_file.hpp"}
PUBLIC = ROOT / "include"  # one header for each language, of any length

# Code that has no place in a library, and why.
BANNED = [
    (r"#\s*include\s*<(iostream|print)>", "the library never prints"),
    (r"\b(f|v|vf)?(printf|puts|putchar)\s*\(|\bfmt::print|\bstd::c(out|err|log)\b",
     "the library never prints"),
    (r"\b(exit|_Exit|_exit|quick_exit|abort|terminate)\s*\(", "the library never ends the process"),
    (r"(?<!static_)\bassert\s*\(", "input is checked by code that stays in release builds"),
    (r"\b(secure_)?(getenv|setenv|putenv)\s*\(", "the library does not read the environment"),
    (r"\b(strto(d|f|ld|l|ul|ll|ull)|ato[fil]|setlocale)\s*\(|\bstd::sto[a-z]+\s*\(",
     "depends on the locale or hides errors: use std::from_chars"),
    (r"\b(s?rand|drand48)\s*\(|\brandom_device\b", "results are the same on every run"),
    (r"\b(signal|sigaction|setjmp|longjmp|fesetround|feenableexcept)\s*\(",
     "signals, jumps and the floating-point mode belong to the caller"),
    (r"^\s*(static|inline)\s+(?!.*\b(const|constexpr|constinit|thread_local)\b)[\w:<>, *&]+"
     r"(=.*|\{.*\}|\[.*\])?;", "no mutable statics"),
]
FILE_ACCESS = r"#\s*include\s*<(cstdio|fstream|filesystem|fcntl\.h|unistd\.h)>"

SOURCES = {".c", ".cpp", ".h", ".hpp"}
TEXTS = SOURCES | {"", ".py", ".build", ".txt", ".json", ".md", ".rs", ".toml"}
LICENSE_LINE = SOURCES | {".py", ".rs"}
SOMEBODYS_MACHINE = re.compile(r"(?<![\w.])/(?:home|root|Users|work|var/tmp)/\w")


def repository_files():
    """Tracked and new files, without ignored ones; without git, all files outside builds."""
    command = ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        paths = [ROOT / name for name in listed.split("\0") if name]
    except (OSError, subprocess.CalledProcessError):
        outside = {"out", ".git"} | {path.parent.name for path in ROOT.glob("*/meson-private")}
        paths = [path for path in ROOT.rglob("*") if path.relative_to(ROOT).parts[0] not in outside]
    return sorted(path for path in paths if path.is_file() and not path.is_symlink())


def without_comments(text):
    """The code with comments and string literals blanked and line numbers kept."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''

    def blank(match):
        return re.sub(r"[^\n]", " ", match[0])

    # An include's name is a string that must stay.
    lines = re.sub(r'^(\s*#\s*include\s*)"([^"]*)"', r"\1<<\2>>", text, flags=re.MULTILINE)
    return re.sub(pattern, blank, lines, flags=re.DOTALL)


def place(room, inside):
    """The place of a source, given by its path inside the room, among the room's sub-rooms."""
    name = inside.split("/")[0].split(".")[0]
    return next((i for i, names in enumerate(SUBROOMS[room]) if name in names.split()), None)


def room_breaches(path, code):
    """Rules of src/: allowed includes and banned code."""
    room = path.relative_to(ROOT / "src").parts[0]
    inside = str(path.relative_to(ROOT / "src" / room))
    if room not in ROOMS:
        yield 1, f"{room} is not a room of src/"
        return
    if room in SUBROOMS and place(room, inside) is None:
        yield 1, f"{inside} has no place among the sub-rooms of {room} (SUBROOMS)"
        return
    for number, line in enumerate(code.splitlines(), 1):
        include = re.match(r"\s*#\s*include\s*<<([^>]*)>>", line)
        if include and include[1].split("/")[0] not in ROOMS[room]:
            yield number, f'{room} must not include "{include[1]}"'
        elif include and room in SUBROOMS and include[1].startswith(room + "/"):
            below = place(room, include[1].removeprefix(room + "/"))
            if below is None or below > place(room, inside):
                yield number, f'{inside} must not include "{include[1]}", a sub-room above it'
        if room in MATHEMATICS and re.search(FILE_ACCESS, line):
            yield number, f"{room} takes matrices and knows nothing of files"
        for pattern, reason in BANNED:
            if re.search(pattern, line):
                yield number, f"{reason}: {line.strip()}"


def tool_breaches(code):
    for number, line in enumerate(code.splitlines(), 1):
        include = re.match(r"\s*#\s*include\s*<<([^>]*)>>", line)
        if include and include[1].split("/")[0] in ROOMS and include[1] not in SHARED:
            yield number, f'the command uses stltsa.hpp alone, not "{include[1]}"'


def text_breaches(path, text):
    lines = text.splitlines()
    # The public headers are the manual; tests/abi has those of earlier versions.
    manual = path.parent == PUBLIC or path.name == "stltsa.h"
    if path.suffix in SOURCES and len(lines) > LONGEST_FILE and not manual:
        yield len(lines), f"longer than {LONGEST_FILE} lines"
    script = path.suffix == "" and text.startswith("#!")
    if (path.suffix in LICENSE_LINE or script) and not any(
            "SPDX-License-Identifier: BSD-3-Clause" in line for line in lines[:3]):
        yield 1, "no SPDX-License-Identifier in the first lines"
    for number, line in enumerate(lines, 1):
        if SOMEBODYS_MACHINE.search(line):
            yield number, f"names a directory of somebody's machine: {line.strip()}"


def breaches(path):
    text = path.read_text(encoding="utf-8", errors="replace")
    yield from text_breaches(path, text)
    top = path.relative_to(ROOT).parts[0]
    if path.suffix in SOURCES and top == "src":
        yield from room_breaches(path, without_comments(text))
    elif path.suffix in SOURCES and top == "tools":
        yield from tool_breaches(without_comments(text))


def main():
    files = [path for path in repository_files() if path.suffix in TEXTS]
    found = 0
    for path in files:
        for number, reason in breaches(path):
            found += 1
            print(f"{path.relative_to(ROOT)}:{number}: {reason}", file=sys.stderr)
    print(f"{len(files)} files read, {found} breaches")
    return int(found > 0 or not files)


if __name__ == "__main__":
    sys.exit(main())
