# SPDX-License-Identifier: BSD-3-Clause
"""Measures tasks: one fit by one program, the second fit of a separate process."""

import dataclasses
import json
import os
import statistics
import subprocess
import sys
import time
from pathlib import Path

DIMENSION = 2

# A fit is repeated for this many seconds, or this many times.
ENOUGH_SECONDS, ENOUGH_RUNS = 1.0, 5


@dataclasses.dataclass(frozen=True)
class Frames:
    """Frames in a file of doubles; a task may use only the first of them."""

    kind: str  # "real" or "made up"
    path: str
    count: int
    features: int


@dataclasses.dataclass(frozen=True)
class Task:
    program: str  # "stltsa", "tapkee" or "scikit-learn"
    frames: Frames
    n: int
    k: int
    mode: str = "spatial"  # or "temporal"
    threads: int = 1
    check: bool = True  # tapkee: check that the neighborhood graph is connected

    @property
    def name(self):
        words = [self.program, self.frames.kind.replace(" ", "-"), self.mode, str(self.n),
                 f"k{self.k}", f"t{self.threads}"]
        return "_".join(words + ([] if self.check else ["unchecked"]))


class Laboratory:
    """Runs tasks and keeps their results."""

    def __init__(self, build, folder, limit):
        self.build = build
        self.folder = folder
        self.limit = limit  # seconds for one fit
        self.runs = {}  # task: list of the results of its processes

    def program(self, *words):
        """The JSON output of a program of the build folder."""
        command = [self.build / words[0], *words[1:]]
        result = subprocess.run([str(word) for word in command], check=True,
                                capture_output=True, text=True)
        return json.loads(result.stdout or "null")

    def coords_path(self, task):
        return self.folder / f"{task.name}.coords"

    def failed(self, task):
        return any("failed" in run for run in self.runs[task])

    def _command(self, task):
        data = [task.frames.path, task.n, task.frames.features]
        if task.program == "stltsa":
            return [self.build / "measure/fit_frames", *data, task.mode, task.k, task.threads,
                    self.coords_path(task)]
        peer = Path(__file__).with_name("peer.py")
        return [sys.executable, peer, task.program, *data, task.k, int(task.check),
                self.coords_path(task)]

    def run_once(self, task):
        environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        started = time.perf_counter()
        try:
            done = subprocess.run([str(word) for word in self._command(task)], env=environment,
                                  capture_output=True, text=True, timeout=2 * self.limit,
                                  check=False)
        except subprocess.TimeoutExpired:
            return {"seconds": self.limit, "failed": f"not done within {self.limit:g} s"}
        if done.returncode != 0:
            reason = (done.stderr.strip() or f"exit status {done.returncode}").splitlines()[-1]
            return {"seconds": time.perf_counter() - started, "failed": reason}
        said = json.loads(done.stdout.splitlines()[-1])
        return said | ({"note": done.stderr.strip()} if done.stderr.strip() else {})

    def measure(self, tasks, rounds=1):
        """Runs round by round, so that a disturbance of the machine affects all programs."""
        for turn in range(rounds):
            for task in tasks:
                runs = self.runs.setdefault(task, [])
                spent = 0.0
                for _ in range(ENOUGH_RUNS):
                    if spent > ENOUGH_SECONDS or self.failed(task):
                        break
                    runs.append(self.run_once(task))
                    spent += runs[-1]["seconds"]
                print(f"  {turn + 1}/{rounds}  {task.name:44} {described(runs)}", flush=True)


def described(runs):
    times = [run["seconds"] for run in runs]
    failed = [run["failed"] for run in runs if "failed" in run]
    text = f"{statistics.median(times):9.4f} s ({min(times):.4f} .. {max(times):.4f})"
    return f"{text}  FAILED: {failed[0]}" if failed else text


def summary(task, runs):
    """A task and its runs, for the JSON."""
    times = [run["seconds"] for run in runs]
    # Stages are those of the median run, so that they add up.
    middle = sorted(runs, key=lambda run: run["seconds"])[(len(runs) - 1) // 2]
    result = {"program": task.program, "frames": task.frames.kind, "n": task.n, "k": task.k,
              "mode": task.mode, "threads": task.threads, "check": task.check,
              "features": task.frames.features,
              "input": 8 * task.n * task.frames.features, "runs": len(runs),
              "seconds": statistics.median(times), "least": min(times), "most": max(times)}
    failed = [run["failed"] for run in runs if "failed" in run]
    if failed:
        return result | {"failed": failed[0]}
    result["processor"] = middle["processor"]
    result["memory"] = max(run["memory"] for run in runs)
    for key in ("stages", "solves", "components", "note"):
        if key in middle:
            result[key] = middle[key]
    return result
