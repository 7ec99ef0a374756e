#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the overhead of the binding over C; measure/python runs it.

Time: processor time of the thread, the least of several runs. C and Python calls alternate; on a
busy machine their difference is larger than the overhead. The overhead is therefore measured
directly: the time outside stltsa_fit, and the time of the progress callbacks inside, which Ctrl-C
relies on. "C" is stltsa_fit with all arguments prepared and no callback.

Memory: rise of the peak resident memory during the call, in a fresh process each.
"""

import pathlib
import subprocess
import sys
import time

import numpy as np

import stltsa
from stltsa._arrays import read_from
from stltsa._native import ffi, lib
from stltsa._progress import Watch

FRAMES = 100_000
ROUNDS = 5
MOST_TIME = 0.02
MOST_MEMORY = 0.02  # relative to the frames


def motion(columns):
    """Return a periodic motion with noise (frames x columns)."""
    t = np.arange(FRAMES)[:, None] / 120
    random = np.random.default_rng(1)
    frames = np.sin(2 * np.pi * t + random.uniform(0, 6, columns))
    frames += random.normal(scale=0.01, size=frames.shape)
    return frames


def c_options(**values):
    out = ffi.new("stltsa_options **")
    assert lib.stltsa_options_new(out) == 0
    for name, value in values.items():
        key = getattr(lib, f"STLTSA_OPT_{name.upper()}")
        assert lib.stltsa_options_set_int(out[0], key, value) == 0
    return out[0]


def c_call(frames, **values):
    """Return a function that fits in C and frees the model."""
    view, options, out = read_from(frames), c_options(**values), ffi.new("stltsa_model **")

    def call():
        assert lib.stltsa_fit(view, ffi.NULL, options, out) == 0
        lib.stltsa_model_free(out[0])

    return call


def seconds(call):
    start = time.thread_time()
    call()
    return time.thread_time() - start


class Stopwatch:
    """Replaces the extension's library and times the calls of stltsa_fit."""

    def __init__(self):
        self.inside = 0.0

    def __getattr__(self, name):
        return getattr(lib, name)

    def stltsa_fit(self, *arguments):
        start = time.thread_time()
        status = lib.stltsa_fit(*arguments)
        self.inside += time.thread_time() - start
        return status


def outside(call):
    """Return the time of a call outside stltsa_fit."""
    watch = stltsa.model.lib = Stopwatch()
    try:
        return seconds(call) - watch.inside
    finally:
        stltsa.model.lib = lib


def reports(frames, settings):
    """Return the number of progress reports of a fit, and the time of one report.

    Measured from Python and back, which is one call more than the library makes.
    """
    seen = []
    stltsa.fit(frames, **settings, progress=lambda *report: seen.append(report))
    watch, many = Watch(None), 20_000
    report = ffi.cast("stltsa_progress_fn", lib.on_progress)

    def repeat():
        for _ in range(many):
            report(watch.handle, 2, 0.5)

    return len(seen), min(seconds(repeat) for _ in range(5)) / many


def measure_time():
    frames = motion(20)
    settings = {"neighbors": 25, "window": 25, "dimension": 2, "threads": 1}
    estimator = stltsa.STLTSA(n_neighbors=25, window=25, n_components=2)
    calls = {
        "C": c_call(frames, **settings),
        "stltsa.fit": lambda: stltsa.fit(frames, **settings),
        "STLTSA.fit": lambda: estimator.fit(frames),
    }
    best = {name: min(seconds(call) for _ in range(2)) for name, call in calls.items()}
    for _ in range(ROUNDS):
        for name, call in calls.items():
            best[name] = min(best[name], seconds(call))
    count, each = reports(frames, settings)
    print(f"{FRAMES} frames x 20, k = 25, one thread, the least of {ROUNDS + 2} runs")
    print(f"      C            {best.pop('C'):8.3f} s")
    print(
        f"      progress     {count} reports of {1e6 * each:.1f} us = {1e3 * count * each:.2f} ms"
    )
    passed = True
    for name, value in best.items():
        around = min(outside(calls[name]) for _ in range(5))
        added = (around + count * each) / (value - around)
        ok = added < MOST_TIME
        passed &= ok
        print(
            f"{'pass' if ok else 'FAIL'}  {name:<12} {value:8.3f} s, {1e3 * around:.2f} ms outside "
            f"stltsa_fit; with the reports {100 * added:.2f} % (limit {100 * MOST_TIME:.0f} %)",
            flush=True,
        )
    return passed


def peak():
    """Return the peak of resident memory in bytes."""
    for line in pathlib.Path("/proc/self/status").read_text().splitlines():
        if line.startswith("VmHWM:"):
            return 1024 * int(line.split()[1])
    raise RuntimeError("no VmHWM in /proc/self/status")


def rise(way):
    """Print the rise of the peak during a call, relative to the size of the frames."""
    settings = {"neighbors": 8, "window": 8, "dimension": 2, "threads": 1, "keep_frames": 0}
    frames = motion(300)
    if way == "converted":
        frames = frames.astype(">f8")
    estimator = stltsa.STLTSA(n_neighbors=8, window=8)
    calls = {
        "C": c_call(frames, **settings) if way == "C" else None,
        "C, kept": c_call(frames, **{**settings, "keep_frames": 1}) if way == "C, kept" else None,
        "stltsa.fit": lambda: stltsa.fit(frames, **settings),
        "STLTSA.fit": lambda: estimator.fit(frames),
        "converted": lambda: stltsa.fit(frames, **settings),
    }
    pathlib.Path("/proc/self/clear_refs").write_text("5")  # resets the peak
    before = peak()
    calls[way]()
    print((peak() - before) / frames.nbytes)


def measure_memory():
    def of(way):
        command = [sys.executable, "-W", "ignore", __file__, way]
        return float(subprocess.run(command, capture_output=True, text=True, check=True).stdout)

    print(
        f"\n{FRAMES} frames x 300, float64, C-contiguous; rise of the peak, in sizes of that array"
    )
    plain, kept = of("C"), of("C, kept")
    rows = (
        ("stltsa.fit", plain, lambda over: abs(over) < MOST_MEMORY, "no copy"),
        ("STLTSA.fit", kept, lambda over: abs(over) < MOST_MEMORY, "no copy"),
        ("converted", plain, lambda over: 0.9 < over < 1.1, "big-endian: one copy, which is seen"),
    )
    print(f"      {'C':<12} {plain:6.3f}  (keeping the frames in the model: {kept:.3f})")
    passed = True
    for way, reference, check, said in rows:
        value = of(way)
        ok = check(value - reference)
        passed &= ok
        print(
            f"{'pass' if ok else 'FAIL'}  {way:<12} {value:6.3f}  {value - reference:+.3f}: {said}",
            flush=True,
        )
    return passed


if __name__ == "__main__":
    if len(sys.argv) > 1:
        rise(sys.argv[1])
    else:
        sys.exit(not all([measure_time(), measure_memory()]))
