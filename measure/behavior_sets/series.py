# SPDX-License-Identifier: BSD-3-Clause
"""The Time Series Segmentation Benchmark: univariate series, scored by covering."""

import numpy as np


RATE = 30  # the library decimates only above


def benchmark(run):
    folder = run.options.series
    if folder is None:
        print("    no benchmark of single series (give --series DIR)")
        return
    lines = (folder / "desc.txt").read_text().splitlines()
    for _, line in run.half(lines):
        name, _, *borders = line.split(",")
        borders = [int(float(b)) for b in borders]
        values = np.loadtxt(folder / f"{name}.txt")
        path = run.table(name, values[:, None])
        for build, answer in run.ask(path, "--fps", RATE):
            found = [s["begin"] for s in answer["segments"][1:]]
            run.row("covering", 0.8).add(build, covering(borders, found, len(values)), 1)
            run.note(build, False, path, f"{found} for {borders} of {len(values)}")


def covering(true, found, length):
    """The best overlap of each true segment, weighted by its length (Arbelaez et al. 2010)."""
    def intervals(borders):
        ends = [0, *borders, length]
        return list(zip(ends[:-1], ends[1:]))

    def overlap(a, b):
        both = max(0, min(a[1], b[1]) - max(a[0], b[0]))
        return both / (a[1] - a[0] + b[1] - b[0] - both)
    found = [f for f in intervals(found) if f[1] > f[0]]
    return sum((t[1] - t[0]) * max(overlap(t, f) for f in found) for t in intervals(true)) / length
