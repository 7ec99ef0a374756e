# SPDX-License-Identifier: BSD-3-Clause
"""The example that replays a clip over the Lab Streaming Layer."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).resolve().parents[3] / "examples" / "live_lsl.py"

try:
    import pylsl  # noqa: F401
except (ImportError, RuntimeError) as error:  # RuntimeError: liblsl is missing
    pytest.skip(f"pylsl does not work here: {error}", allow_module_level=True)


@pytest.mark.skipif(not EXAMPLE.is_file(), reason="the examples are in the repository only")
def test_the_stream_has_the_cycles_of_the_walk(walker, result):
    line = [sys.executable, EXAMPLE, walker, "4"]
    done = subprocess.run(line, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    rows = done.stdout.splitlines()
    assert len(rows) >= len(result.clip) // 10
    known = [row for row in rows if re.search(r" phase 0\.\d+ ", row)]
    assert len(known) > len(rows) / 4
    marks = sum(row.endswith("middle") for row in rows)
    assert abs(marks - len(result.cycle_list)) <= 1
