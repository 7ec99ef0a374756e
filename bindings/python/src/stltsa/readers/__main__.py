# SPDX-License-Identifier: BSD-3-Clause
"""Read a file for the command ``stltsa``: ``python -m stltsa.readers FILE FPS``.

The first line of standard output is ``fps`` and the frame rate; the bytes of a BVH or CSV file
follow. If FILE cannot be read, it is a sentence that says why, and the exit status is 3. FPS may be
empty.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from stltsa import StltsaError, read_clip


def main() -> int:
    """Read the file that the arguments name."""
    name, rate = sys.argv[1:]
    try:
        clip = read_clip(name, fps=float(rate)) if rate else read_clip(name)
        with tempfile.TemporaryDirectory(prefix="stltsa-") as folder:
            file = Path(folder) / ("clip.bvh" if clip.joints else "clip.csv")
            clip.save(file)
            content = file.read_bytes()
    except (StltsaError, ImportError, OSError, ValueError) as error:
        sys.stdout.write(str(error))
        return 3
    sys.stdout.buffer.write(f"fps {clip.fps!r}\n".encode())
    sys.stdout.buffer.write(content)
    return 0


if __name__ == "__main__":
    sys.exit(main())
