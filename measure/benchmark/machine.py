# SPDX-License-Identifier: BSD-3-Clause
"""The machine and the versions used for the measurements."""

import importlib.metadata
import os
import platform
import re
from pathlib import Path


def _first(path, pattern, otherwise):
    try:
        found = re.search(pattern, Path(path).read_text(), flags=re.MULTILINE)
    except OSError:
        return otherwise
    return found[1].strip().strip('"') if found else otherwise


def describe():
    """For example: 2 cores of AMD EPYC, Debian GNU/Linux 12 (bookworm)."""
    processor = _first("/proc/cpuinfo", r"^model name\s*:\s*(.*)$", platform.machine())
    system = _first("/etc/os-release", r"^PRETTY_NAME=(.*)$", platform.system())
    return f"{os.cpu_count()} cores of {processor}, {system}"


def peers():
    """The other installed libraries and their versions."""
    found = {}
    for name in ("tapkee", "scikit-learn"):
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            print(f"{name} is not there: its part of the comparison is left out")
    return found
