# SPDX-License-Identifier: BSD-3-Clause
"""Recordings that earlier versions read or answered wrongly, and what is right: the table CASES.

A case is a function that writes its file into a folder, with the decorator `case` and what must come out (`Right`).
The command (test_cases.py) and the Python binding (bindings/python/tests/test_cases.py) are checked with the same table.
"""

import math
from typing import NamedTuple

import numpy as np
from c3d_file import c3d

CASES = {}
SIDED = ("Hip", "Knee", "Ankle", "Toe", "Shoulder", "Wrist")
NAMES = (*(side + name for side in "LR" for name in SIDED), "Head", "Sacrum")


class Right(NamedTuple):
    """What must come out; None: anything may."""

    error: str | None = None  # a part of the text of an error
    fps: float | None = None
    seconds: float | None = None
    cycles: int | None = None
    period: float | None = None
    kinds: tuple | None = None  # of the segments
    channels: tuple | None = None  # names
    features: str | None = None
    up: str | None = None
    step: float | None = None  # seconds of each step, of which sides are known
    note: str | None = None


def case(**right):
    def register(function):
        CASES[function.__name__] = (function, Right(**right))
        return function

    return register


def check(right, found, clip):
    """`found`: a decomposition, as JSON; `clip`: its clip."""
    for what, expected, actual, error in (
        ("fps", right.fps, found["clip"]["fps"], 1e-6),
        ("seconds", right.seconds, found["clip"]["duration_s"], 1e-6),
        ("period", right.period, found["period_s"], 0.01),
    ):
        assert expected is None or (actual is not None and abs(actual - expected) <= error), (what, expected, actual)
    for what, expected, actual in (
        ("cycles", right.cycles, len(found["cycles"])),
        ("kinds", right.kinds, tuple(segment["kind"] for segment in found["segments"])),
        ("channels", right.channels, tuple(clip["channels"]["names"])),
        ("features", right.features, found["clip"]["features"]),
        ("up", right.up, found["samples"]["up_axis"]),
    ):
        assert expected is None or actual == expected, (what, expected, actual)
    if right.period is not None:
        for cycle in found["cycles"]:
            assert abs(cycle["end_s"] - cycle["begin_s"] - right.period) <= 0.03, cycle
    if right.step is not None:
        assert found["steps"], found["segments"]
        for step in found["steps"]:
            assert abs(step["end_s"] - step["begin_s"] - right.step) <= 0.003, step
            assert step["side_name"] in ("left", "right"), step
    notes = " ".join(found["clip"]["notes"])
    assert right.note is None or right.note in notes, notes


# ---- Motions: frames x points x 3, z up, in m ----


def walk(fps, seconds, period=1.1, speed=1.09):
    """Fourteen points of a walker along x."""
    t, points = np.arange(round(seconds * fps)) / fps, []
    for side, sign in ((0.5, 1), (0, -1)):
        phase = 2 * np.pi * (t / period + side)
        swing, lift = np.sin(phase), np.maximum(0, np.cos(phase))
        for name, ahead, across, height in (
            ("Hip", 0, 0.1, 0.94), ("Knee", 0.12 * swing, 0.1, 0.52), ("Ankle", 0.25 * swing, 0.1, 0.1 + 0.1 * lift),
            ("Toe", 0.15 + 0.28 * swing, 0.1, 0.02 + 0.12 * lift), ("Shoulder", 0, 0.2, 1.44),
            ("Wrist", -0.2 * swing, 0.2, 0.89 + 0.03 * swing**2),
        ):  # fmt: skip
            assert name in SIDED
            points.append((ahead, sign * across, height))
    points += [(0, 0, 1.67 + 0.01 * np.cos(4 * np.pi * t / period)), (-0.06, 0, 1.02)]
    rows = np.stack([np.stack([axis + 0 * t for axis in point], 1) for point in points], 1)
    rows[:, :, 0] += speed * t[:, None]
    return rows + np.random.default_rng(3).normal(scale=0.001, size=rows.shape)


def squats(count, fps=50, period=2.0, stand=1.5):
    """Repetitions back to back, between two stretches of standing."""
    t = np.arange(round((count * period + 2 * stand) * fps)) / fps - stand
    down = np.where((t > 0) & (t < count * period), 0.5 - 0.5 * np.cos(2 * np.pi * t / period), 0)
    points = []
    for sign in (1, -1):
        for ahead, across, height, forward, low in ((0, 0.15, 0.08, 0, 0), (0, 0.15, 0.5, 0.25, 0.08),
                                                    (0, 0.15, 0.95, -0.2, 0.42), (0, 0.2, 1.45, 0.05, 0.45),
                                                    (0.1, 0.22, 0.95, 0.3, 0.1)):  # fmt: skip
            points.append((ahead + forward * down, sign * across + 0 * t, height - low * down))
    points.append((0.06 * down, 0 * t, 1.7 - 0.45 * down))
    rows = np.stack([np.stack(point, 1) for point in points], 1)
    return rows + np.random.default_rng(5).normal(scale=0.001, size=rows.shape)


def columns(names=NAMES, axes="xyz", form="{}_{}"):
    return [form.format(name, axis) for name in names for axis in axes]


def flat(rows, axes=(0, 1, 2)):
    """Cells of each row; a value that is not there is an empty cell."""
    return [["" if math.isnan(x) else f"{x:.4f}" for x in row[:, list(axes)].ravel()] for row in rows]


def write(path, lines, separator=","):
    path.write_text("".join(separator.join(map(str, line)) + "\n" for line in lines))
    return path


def timed(rows, fps, digits=4):
    return [[f"{i / fps:.{digits}f}", *row] for i, row in enumerate(rows)]


# ---- What is present ----


@case(fps=100, seconds=8.4, cycles=3, period=1.05, kinds=("rest", "cyclic", "rest"), note="")
def late_entry(folder):
    rows = walk(100, 8.4, 1.05)
    rows[:320] = rows[691:] = math.nan
    return write(folder / "late.csv", [["time", *columns()], *timed(flat(rows), 100)])


# ---- Clocks ----


@case(fps=100, cycles=5, period=1.1, features="points")
def t10_bracket(folder):
    names = ("C7", "T10", *NAMES)
    body = walk(100, 6.6)
    rows = np.concatenate([body[:, [12, 13]], body], 1)
    return write(folder / "a.csv", [["Time", *columns(names, "012", "{}[{}]")], *timed(flat(rows), 100, 3)])


def mot(path, times, digits):
    rows = [[f"{30 + 20 * math.sin(2 * math.pi * t / 1.1):.3f}", f"{30 - 20 * math.sin(2 * math.pi * t / 1.1):.3f}",
             f"{10 * math.cos(2 * math.pi * t / 1.1):.3f}"] for t in times]  # fmt: skip
    head = [["Coordinates"], ["version=1"], [f"nRows={len(rows)}"], ["nColumns=4"], ["inDegrees=yes"], ["endheader"],
            ["time", "knee_angle_r", "knee_angle_l", "hip_flexion_r"]]  # fmt: skip
    return write(path, [*head, *([f"{t:.{digits}f}", *row] for t, row in zip(times, rows))], "\t")


@case(fps=60, seconds=5, cycles=4, period=1.1, channels=("knee_angle_r", "knee_angle_l", "hip_flexion_r"))
def rounded_time(folder):
    return mot(folder / "a.mot", [i / 60 for i in range(300)], 3)


@case(cycles=10, period=1.1, note="resampled to")
def variable_steps(folder):
    times = [0.0]
    while times[-1] < 12:
        times.append(times[-1] + 0.012 * (1 + 0.9 * math.sin(2 * math.pi * times[-1] / 12)))
    return mot(folder / "a.sto", times, 6)


@case(error="a.sto:308: column 'time' is time, but does not increase")
def backward_time(folder):
    return mot(folder / "a.sto", [i / 60 - (2 if i >= 300 else 0) for i in range(400)], 3)


def trc(path, rows, rate, fps, kept):
    lines = [["PathFileType", 4, "(X/Y/Z)", "x.trc"], ["DataRate", "CameraRate", "NumFrames", "NumMarkers", "Units"],
             [rate, rate, len(kept), len(NAMES), "m"], ["Frame#", "Time", *(c for n in NAMES for c in (n, "", ""))],
             ["", "", *(f"{axis}{i + 1}" for i in range(len(NAMES)) for axis in "XYZ")], [""]]  # fmt: skip
    cells = flat(rows)
    return write(path, [*lines, *([i + 1, f"{i / fps:.5f}", *cells[i]] for i in kept)], "\t")


@case(fps=30, cycles=5, period=1.1, note="say 100 frames a second, but the times 30: the times are used")
def rate_contradicts_time(folder):
    return trc(folder / "a.trc", walk(30, 6.6), 100, 30, range(198))


@case(fps=100, seconds=6, note="50 of 600 frames have no value")
def trc_dropped(folder):
    kept = [i for i in range(600) if not 200 <= i < 250]
    return trc(folder / "a.trc", walk(100, 6), 100, 100, kept)


@case(fps=30, seconds=6.6, cycles=5, period=1.1)
def iso_time(folder):
    rows = [[f"2024-01-01 12:00:{i / 30:06.3f}", *row] for i, row in enumerate(flat(walk(30, 6.6)))]
    return write(folder / "a.csv", [["timestamp", *columns()], *rows])


def bvh(path, declared, written, frame_time):
    """Two legs that swing below the hips."""
    joint = "  JOINT {0}UpLeg\n {{\n OFFSET {1} -5 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n JOINT {0}Leg\n {{\n" \
            "OFFSET 0 -42 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n End Site\n {{\n OFFSET 0 -42 0\n }}\n }}\n }}\n"
    rows = []
    for i in range(written):
        turn = 2 * math.pi * i / 33
        legs = [f"0 {25 * s * math.sin(turn):.4f} 0 0 {20 - 20 * s * math.cos(turn):.4f} 0" for s in (1, -1)]
        rows.append(f"0 90 {4 * i} 0 0 0 " + " ".join(legs))
    path.write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation "
                    "Xrotation Yrotation\n" + joint.format("Left", 10) + joint.format("Right", -10) +
                    f"}}\nMOTION\nFrames: {declared}\nFrame Time: {frame_time}\n" + "\n".join(rows) + "\n")  # fmt: skip
    return path


@case(error="invalid Frame Time 30 s")
def frame_time_is_fps(folder):
    return bvh(folder / "a.bvh", 120, 120, 30)


@case(cycles=3, period=1.1, note="the file declares 120 frames, but has 121, which are read")
def one_row_more(folder):
    return bvh(folder / "a.bvh", 120, 121, 1 / 30)


# ---- What is decided ----


@case(fps=70, cycles=0, kinds=("rest",))
def static_2mm(folder):
    body = walk(70, 10, speed=0)[:1].repeat(700, 0)
    breath = 0.002 * np.sin(2 * np.pi * np.arange(700) / 70 / 2.8)
    for name in ("LWrist", "RWrist", "Head"):
        body[:, NAMES.index(name), 2] += breath
    body += np.random.default_rng(1).normal(scale=0.0005, size=body.shape)
    return write(folder / "a.csv", [["time", *columns()], *timed(flat(body), 70)])


@case(fps=50, cycles=5, period=2.0, kinds=("rest", "cyclic", "rest"))
def five_squats(folder):
    names = (*(side + name for side in "LR" for name in ("Ankle", "Knee", "Hip", "Shoulder", "Wrist")), "Head")
    return write(folder / "a.csv", [["time", *columns(names)], *timed(flat(squats(5)), 50)])


@case(fps=60, cycles=7, period=1.1, step=0.55)
def steps_sym(folder):
    return write(folder / "a.csv", [["time", *columns()], *timed(flat(walk(60, 8.8)), 60)])


# ---- Columns ----


@case(error="there are 2 subjects, 'one', 'two': choose one with")
def dlc_two_individuals(folder):
    keys = [(who, name, coord) for who in ("one", "two") for name in NAMES for coord in ("x", "y", "likelihood")]
    heads = [["scorer", *["s"] * len(keys)],
             *([title, *(key[k] for key in keys)] for k, title in enumerate(("individuals", "bodyparts", "coords")))]
    body = walk(30, 6)[:, :, [0, 2]]
    sure = np.ones((len(body), len(NAMES), 1))
    rows = np.concatenate([np.concatenate([body + shift, sure], 2) for shift in (0, 3)], 1)
    return write(folder / "a.csv", [*heads, *([i, *cells] for i, cells in enumerate(flat(rows)))])


SPACE = {"fps": 30, "seconds": 6.6, "cycles": 5, "period": 1.1, "features": "points", "up": "z"}


@case(**SPACE, channels=tuple(columns()))
def axes_zxy(folder):
    return write(folder / "a.csv", [["time", *columns(axes="zxy")], *timed(flat(walk(30, 6.6), (2, 0, 1)), 30)])


def motive(path, *more):
    count = 3 * len(NAMES)
    names = [f"S:{name}" for name in NAMES for _ in range(3)]
    lines = [["Format Version", "1.23", "Take Name", "x", "Capture Frame Rate", "30.000000", "Export Frame Rate",
              "30.000000", "Total Exported Frames", 198, "Length Units", "Meters"], [""],
             ["", "Type", *["Marker"] * count], ["", "Name", *names], ["", "ID", *range(count)], *more,
             ["", "", *["Position"] * count], ["Frame", "Time (Seconds)", *"XYZ" * len(NAMES)]]  # fmt: skip
    return write(path, [*lines, *([i, *row] for i, row in enumerate(timed(flat(walk(30, 6.6)), 30, 6)))])


OF_S = tuple(columns([f"S:{name}" for name in NAMES], "XYZ"))


@case(**SPACE, channels=OF_S)
def motive_markers(folder):
    return motive(folder / "a.csv")


@case(**SPACE, channels=OF_S)
def motive_parent(folder):
    return motive(folder / "a.csv", ["", "Parent", *[""] * (3 * len(NAMES))])


@case(**SPACE, channels=tuple(columns()))
def qualisys_no_column_header(folder):
    head = [["NO_OF_FRAMES", 198], ["NO_OF_CAMERAS", 8], ["NO_OF_MARKERS", 14], ["FREQUENCY", 30], ["NO_OF_ANALOG", 0],
            ["ANALOG_FREQUENCY", 0], ["DESCRIPTION", "--"], ["TIME_STAMP", "2024-01-01, 10:00:00.000", "1.0"],
            ["DATA_INCLUDED", "3D"], ["MARKER_NAMES", *NAMES]]  # fmt: skip
    return write(folder / "a.tsv", [*head, *flat(walk(30, 6.6))], "\t")


@case(fps=1000, seconds=3, channels=("EMG_E1 (V)", "EMG_E2 (V)", "EMG_E3 (V)"))
def vicon_devices_subframe(folder):
    head = [["Devices"], [1000], ["", "", "EMG", "", ""], ["Frame", "Sub Frame", "E1", "E2", "E3"],
            ["", "", "V", "V", "V"]]  # fmt: skip
    noise = np.random.default_rng(2).normal(scale=2e-5, size=(3000, 3))
    return write(folder / "a.csv", [*head, *([1 + i // 10, i % 10, *row] for i, row in enumerate(noise))])


# ---- C3D ----


def c3d_of(path, rows, names, fps=30.0, **settings):
    path.write_bytes(c3d([list(map(float, row.ravel())) for row in rows], names, fps, **settings))
    return path


@case(fps=30, channels=tuple(columns([f"m{p}" for p in range(260)])))
def points_260(folder):
    names = [f"m{p}" for p in range(260)]
    turn = np.arange(30)[:, None, None] / 5 + np.arange(260)[:, None] / 40
    rows = np.sin(turn + np.arange(3)) + np.arange(260)[:, None] / 50
    return c3d_of(folder / "a.c3d", rows, names[:255], parameters={"POINT": {"LABELS2": names[255:]}})


def reaching():
    """Somebody sits and reaches to both sides: the body is wider than it is tall."""
    t = np.arange(198)[:, None] / 30
    reach = 0.25 * np.sin(2 * np.pi * t / 1.5)
    still = np.zeros_like(t)
    points = [(sign * (0.5 + 0.3 * far) + reach, still + 0.1, 0.3 * far + 0.1 * reach**2)
              for sign in (1, -1) for far in (1, 0.5)]  # fmt: skip
    points += [(still, still, still + 0.35), (still, still, still)]
    return np.stack([np.concatenate(point, 1) for point in points], 1)


@case(up="z", cycles=4, period=1.5)
def y_screen_up_z(folder):
    names = ("LHand", "LElbow", "RHand", "RElbow", "Sternum", "Pelvis")
    screen = {"X_SCREEN": ["+X"], "Y_SCREEN": ["+Z"]}
    return c3d_of(folder / "a.c3d", reaching(), names, parameters={"POINT": screen})


@case(error="has no points; it holds 2 analog channels: 'EMG1', 'EMG2'")
def analog_only(folder):
    parameters = {"ANALOG": {"USED": [2], "LABELS": ["EMG1", "EMG2"]}}
    return c3d_of(folder / "a.c3d", np.zeros((30, 0, 3)), (), parameters=parameters, analog=2)


@case(error="it was cut off, get the whole file")
def c3d_cut(folder):
    path = c3d_of(folder / "a.c3d", walk(100, 4), NAMES, 100.0)
    path.write_bytes(path.read_bytes()[:-60000])
    return path
