# SPDX-License-Identifier: BSD-3-Clause
"""Read a file for the command ``stltsa``: ``python -m stltsa.readers FILE FPS``, or its events.

Standard output contains the arrays from which the command makes the same clip, to the bit. The
first line is ``KIND SPACE ITEMS COLUMNS FRAMES RATE``, where the kind is ``points`` (in `space`
dimensions), ``skeleton`` or ``matrix``. Each item has a line: the name of a point, or for a joint
its parent, 1 for an end site, offset, channels and name, separated by tabs. Then frames x columns
numbers follow (float64). If FILE cannot be read, the output is a message with the reason, and the
exit status is 3. FPS may be empty.

``python -m stltsa.readers --events FILE [FPS]`` writes the events of a C3D file instead, with the
columns onset (seconds) and trial_type, separated by tabs, as in BIDS.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from stltsa import Clip, StltsaError, read_clip


def _joints(clip: Clip) -> list[str]:
    rows = zip(clip.parents, clip.end_sites, clip.offsets, clip.joint_channels, clip.joints,
               strict=True)  # fmt: skip
    return [
        "\t".join([str(parent), str(int(end)), *map(repr, offset.tolist()), channels or "", name])
        for parent, end, offset, channels, name in rows
    ]


def _positions(clip: Clip) -> Any:
    """Return frames x points x space, with NaN for missing points (features would fill them)."""
    with tempfile.TemporaryDirectory(prefix="stltsa-") as folder:
        file = Path(folder) / "clip.npy"
        clip.save(file)
        return np.load(file)


def _written(clip: Clip) -> bytes:
    """Return the arrays of a clip in the format described above."""
    space, items, kind = 0, [], "matrix"
    if clip.format == "points":
        kind, values = "points", _positions(clip)
        space = values.shape[2]
        items = [name[: -len("_x")] for name in clip.facts["channel"][::space]]
        values = values.reshape(len(values), -1)
    else:
        values = clip.features("raw")
    if clip.joints:
        kind, items = "skeleton", _joints(clip)
    head = f"{kind} {space} {len(items)} {values.shape[1]} {len(values)} {clip.fps!r}"
    lines = [head, *(item.replace("\n", " ") for item in items), ""]
    return "\n".join(lines).encode() + np.ascontiguousarray(values, dtype=np.float64).tobytes()


def events_of(name: str, rate: str = "") -> str:
    """Return the table of the events of a file, or of a stretch of it."""
    if ".c3d" not in name.lower():
        raise ValueError(f"{name}: only C3D files have event labels")
    lines = ["onset\ttrial_type"]
    clip = read_clip(name, fps=float(rate)) if rate else read_clip(name)
    for event in clip.events:
        label = " ".join(f"{event.context} {event.label}".split())
        lines.append(f"{event.seconds!r}\t{label}")
    return "\n".join(lines) + "\n"


def main() -> int:
    """Read the file that the arguments name."""
    name, rate, *more = sys.argv[1:]
    try:
        if name == "--events":
            sys.stdout.write(events_of(rate, *more))
            return 0
        content = _written(read_clip(name, fps=float(rate)) if rate else read_clip(name))
    except (StltsaError, ImportError, OSError, ValueError) as error:
        sys.stdout.write(str(error))
        return 3
    sys.stdout.buffer.write(content)
    return 0


if __name__ == "__main__":
    sys.exit(main())
