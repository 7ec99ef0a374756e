# SPDX-License-Identifier: BSD-3-Clause
"""The command ``stltsa`` that pip installs."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def main() -> None:
    """Run the command inside the package."""
    command = Path(__file__).parent / "bin" / "stltsa"
    if not command.is_file():
        sys.exit(
            "stltsa: this package was built against an installed libstltsa and does not carry the "
            "command: install it beside the library"
        )
    os.execv(command, ["stltsa", *sys.argv[1:]])
