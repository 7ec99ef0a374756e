# SPDX-License-Identifier: BSD-3-Clause
"""The Time Series Segmentation Benchmark: univariate series, scored by covering, beside ClaSP and
change points of ruptures. The two series that aeon ships are read from its package; the others from
the folder of the benchmark."""

import importlib.util
import pathlib

import numpy as np

RATE = 30  # the library decimates only above
SHIPPED = {"ElectricDevices": (1090, 4436, 5712, 7923), "GunPoint": (900,)}  # by aeon


def benchmark(run):
    found = list(series_of(run.options.series))
    if not found:
        print("    no series (give --series DIR, or --peers)")
    for _, (name, values, true) in run.half(found):
        path = run.table(name, values[:, None])
        for build, answer in run.ask(path, "--fps", RATE):
            borders = [s["begin"] for s in answer["segments"][1:]]
            run.row("covering", 0.8).add(build, covering(true, borders, len(values)), 1)
            run.note(build, False, path, f"{borders} for {true} of {len(values)}")
        for peer, segment in PEERS.items():
            if importlib.util.find_spec(peer):
                run.row(f"covering: {peer} alone").add(-1, covering(true, segment(values), len(values)), 1)


def series_of(folder):
    """(name, values, borders) of each series."""
    if folder:
        for line in (folder / "desc.txt").read_text().splitlines():
            name, _, *borders = line.split(",")
            yield name, np.loadtxt(folder / f"{name}.txt"), [int(float(b)) for b in borders]
    elif spec := importlib.util.find_spec("aeon"):
        for name, borders in SHIPPED.items():
            data = pathlib.Path(spec.origin).parent / "datasets" / "data" / "segmentation"
            yield name, np.loadtxt(data / f"{name}.csv", delimiter=",", usecols=-1), list(borders)


def clasp(values):
    from claspy.segmentation import BinaryClaSPSegmentation
    return [int(at) for at in BinaryClaSPSegmentation().fit_predict(values)]


def change_points(values):
    import ruptures
    step = max(1, len(values) // 2000)  # its time is quadratic
    fitted = ruptures.KernelCPD(kernel="rbf", min_size=10).fit(values[::step])
    return [step * at for at in fitted.predict(pen=np.log(len(values)))[:-1]]


PEERS = {"claspy": clasp, "ruptures": change_points}


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
