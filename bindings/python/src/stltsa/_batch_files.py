# SPDX-License-Identifier: BSD-3-Clause
"""The files of the results of a batch, and what they were made from; as the command writes them."""

from __future__ import annotations

import errno
import json
import os
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._native import lib
from ._options import option_named
from ._text import string
from .errors import FileError

if TYPE_CHECKING:
    from collections.abc import Mapping


def _unusable(text: str) -> FileError:
    return FileError(text, lib.STLTSA_E_IO, "STLTSA_E_IO")


def check_place(path: str, place: Path) -> None:
    """Raise if the name of the result is too long, or is that of a folder or a pipe."""
    have, most = len(os.fsencode(place.name)), os.pathconf(place.parent, "PC_NAME_MAX")
    if have > most > 0:
        text = (
            f"the name of the result, this path with __ for /, would have {have} bytes, and a file "
            f"name has at most {most}: start the batch in a folder nearer to the clip"
        )
        raise OSError(errno.ENAMETOOLONG, text, path)
    if place.exists() and not place.is_file():
        raise _unusable(f"its result, {place}, is not a file: remove it, or give another --out")


def _content(file: Path) -> bytes:
    """Return what is in a file. Reading a pipe would wait for its writer."""
    if file.exists() and not file.is_file():
        raise _unusable(f"{file}: not a file; batch reads only files, because it reads them twice")
    return file.read_bytes()


def _files_in(folder: Path, *endings: str) -> list[Path]:
    """Return the files of a folder that end so, by name."""

    def counts(file: Path) -> bool:
        hidden = file.name.startswith(".")
        return not hidden and file.name.lower().endswith(endings) and file.is_file()

    return sorted(filter(counts, folder.iterdir()))


def _files_beside(clip: Path) -> list[Path]:
    """Return those that the library would look at; which of them it takes shows later."""
    folder, name = clip.parent, clip.name.lower()
    if name.endswith(".amc"):
        return _files_in(folder, ".asf")
    found: list[Path] = []
    inside = name.endswith("_motion.tsv")
    while inside:
        found += _files_in(folder, "channels.tsv", "motion.json")
        # Those above the folders of a subject and a session apply, too.
        inside = folder.name.startswith(("sub-", "ses-")) or folder.name == "motion"
        folder = folder.parent
    return found


def origin_of(path: str, out: Path, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return what the result depends on, and where its clip is, as the command writes it."""
    before, colon, _ = path.rpartition(":")
    is_path = not colon or (Path(path).exists() and not Path(path).is_dir())
    file = Path(path if is_path else before)
    content = _content(file)
    skeleton = options.get("skeleton")
    beside = [Path(skeleton)] if skeleton else _files_beside(file)
    content += b"".join(map(_content, beside))
    flags = {"individual": "subject"}  # where they differ from the keywords
    named = sorted(
        (option_named(n).key, flags.get(n, n), v) for n, v in options.items() if n != "threads"
    )
    source = os.path.relpath(file.parent.resolve() / file.name, out.resolve())
    return {
        "source": os.fsencode(source).decode("utf-8", "replace"),
        "bytes": len(content),
        "crc32": f"{zlib.crc32(content):08x}",
        "options": {name.replace("_", "-"): typed(value) for _, name, value in named},
        "library": string(lib.stltsa_version()),
    }


# No text within the JSON has it: quotes in texts follow a backslash.
_BEGIN, _END = ',"batch":', "}\n"


def with_origin(body: str, origin: Mapping[str, Any]) -> str:
    """Return the file of a result, given without its last brace; it ends with a checksum."""
    text = body + _BEGIN + json.dumps(origin, separators=(",", ":"), ensure_ascii=False)[:-1]
    return f'{text},"checksum":"{zlib.crc32(text.encode()):08x}"}}{_END}'


def _source_in(origin: str) -> str:
    """Return the source that the end of a file names; empty if it is damaged."""
    try:
        source = json.loads(origin.removesuffix(_END))["source"]
    except (ValueError, KeyError, TypeError, RecursionError):
        return ""
    return source if isinstance(source, str) else ""


def kept(place: Path, origin: Mapping[str, Any]) -> Any:
    """Return the result of an earlier run if it is undamaged and was made from the same.

    Raise if it is the result of another clip, which is still there.
    """
    text = place.read_bytes().decode("utf-8", "replace") if place.exists() else ""
    body, _, end = text.rpartition(_BEGIN)
    source = _source_in(end)
    if text == with_origin(body, {**origin, "source": source}):  # the same clip may have moved
        return json.loads(text)
    other = place.parent / source
    if source and source != origin["source"] and other.exists():
        raise _unusable(
            f"its result, {place}, is that of another clip, {os.path.normpath(other)}: give "
            "another --out"
        )
    return None


def typed(value: Any) -> str:
    """Return a value as it would be typed in the command."""
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float) and value.is_integer():
        return str(int(value))
    return str(value)
