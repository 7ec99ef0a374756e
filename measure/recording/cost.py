# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of `stltsa decompose` on one core, from short recordings to ten hours."""

import json
import os
import pathlib
import subprocess
import time

import numpy as np

from . import synthetic
from .score import checked, score

HOURS = 10
SECONDS = 240  # limit of ten hours
BEYOND = 1e9  # limit of its memory beyond the input, bytes


def check(run):
    run.table.title("Cost on one core, joint angles at 30 frames per second; ten hours in four "
                    "minutes and 1 GB beyond the input")
    sizes = (10_000, 100_000) if run.quick else (10_000, 100_000, 1_000_000, HOURS * 3600 * 30)
    for kind, make in (("treadmill", lambda s: synthetic.treadmill(run.body, 4, s / 60)),
                       ("mixture", lambda s: synthetic.mixture(run.body, 4, s))):
        for frames in sizes:
            recording = make(frames / 30).angles()
            seconds, beyond, answer = measured(run, recording.rows)
            right = score(recording, answer)
            ten_hours = frames == sizes[-1] and not run.quick
            checks = [(f"{seconds:.1f} s", seconds <= SECONDS),
                      (f"{beyond / 1e6:.0f} MB beyond the input", beyond <= BEYOND)]
            text = (f"{1e6 * seconds / frames:.1f} us a frame  {checks[0][0]}  {checks[1][0]}  "
                    f"{right.cycles_right} of {right.cycles} cycles, {right.cycles_wrong} wrong")
            passed = all(ok for _, ok in checks) if ten_hours else None
            run.table.figure(f"{kind}, {frames} frames", text, passed)


def measured(run, rows):
    """Seconds of the command, bytes at its peak beyond the numbers, and its answer."""
    path = run.folder / "frames.npy"
    np.save(path, rows)
    core = str(max(os.sched_getaffinity(0)))
    with open(run.folder / "answer.json", "wb") as answer:
        begin = time.perf_counter()
        child = subprocess.Popen(
            ["taskset", "-c", core, run.command, "decompose", path, "--fps", "30", "--json",
             "--quiet"], stdout=answer, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
        peak = 0
        while child.poll() is None:
            peak = max(peak, peak_memory(child.pid))
            time.sleep(0.01)
    if child.returncode != 0:
        raise SystemExit(f"stltsa decompose failed on {len(rows)} frames")
    seconds = time.perf_counter() - begin
    answer = checked(json.loads((run.folder / "answer.json").read_text()))
    return seconds, peak - rows.nbytes, answer


def peak_memory(pid):
    """Bytes; the usage that wait4 gives counts the memory of this process before the exec."""
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except ProcessLookupError:
        return 0
    peak = next((line for line in status.splitlines() if line.startswith("VmHWM")), "VmHWM: 0 kB")
    return int(peak.split()[1]) * 1024
