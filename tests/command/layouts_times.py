# SPDX-License-Identifier: BSD-3-Clause
"""The walk of layouts.py with every kind of clock that docs/formats.md lists."""

import math

from layouts import FPS, JOINTS, Case, layout, missing_rows, motive, table, times, upright, walk_points, with_underscore, write
from layouts_formats import trc

HOLE = range(100, 110)  # rows that `missing_rows` lacks


def timed(first, cells, rows=None):
    """Lines with other cells in the first column."""
    lines = table(rows or walk_points(), with_underscore, first=first)
    return [lines[0], *([cell, *line[1:]] for cell, line in zip(cells, lines[1:]))]


def counted(path, count):
    """A file of which a column `packet counter` tells the frames: it ends at `count`, and begins again."""
    lines = timed("packet counter", [(i + 200) % count for i in range(len(walk_points()))])
    return write(path, lines)


@layout("rounded times: 0.000, 0.017, 0.033")
def rounded(folder):
    for digits in (2, 3, 4):
        cells = [f"{float(time):.{digits}f}" for time in times()]
        yield Case(write(folder / "a.csv", timed("time", cells)))
        lines = trc(upright())
        rows = [[line[0], cell, *line[2:]] for cell, line in zip(cells, lines[6:])]
        yield Case(write(folder / "a.trc", lines[:6] + rows, "\t"), "upright")


@layout("other units: `time_ms`, `t [us]`; since 1970")
def units(folder):
    seconds = [i / FPS for i in range(len(walk_points()))]
    for name, unit, origin in (("time_ms", 1e3, 0), ("t [us]", 1e6, 0), ("Time (ns)", 1e9, 0),
                               ("time", 1e3, 0), ("timestamp", 1e3, 1.7e9), ("timestamp", 1, 1.7e9),
                               ("unix time", 1e9, 1.7e9)):  # fmt: skip
        cells = [f"{(origin + second) * unit:.4f}" if unit == 1 else round(origin * unit) + round(second * unit)
                 for second in seconds]  # fmt: skip
        yield Case(write(folder / "a.csv", timed(name, cells)))


@layout("a first column of another name, such as `Zeit` or `elapsed_ms`")
def other_names(folder):
    for name in ("Zeit", "Temps (s)", "elapsed"):
        path = write(folder / "a.csv", timed(name, times()))
        yield Case(path)
        yield Case(path, note=f"column '{name}' increases by equal steps: taken as time, in seconds")
    milliseconds = [f"{1000 * float(time):.0f}" for time in times()]
    yield Case(write(folder / "b.csv", timed("elapsed_ms", milliseconds)))
    since = [1700000000000 + round(1000 * i / FPS) for i in range(len(walk_points()))]
    yield Case(write(folder / "c.csv", timed("host_timestamp", since)))
    for name in ("Time (%)", "percent", "percent_gait_cycle"):
        percent = write(folder / "d.csv", timed(name, times()))
        yield Case(percent, note=f"no coordinates of points, so left out: column '{name}'")


@layout("dates and times of day: `2024-01-31 12:00:00.033`")
def dates(folder):
    def stamped(between, zone, comma="."):
        cells = []
        for i in range(len(walk_points())):
            whole, part = divmod(i * 1000000 // FPS, 1000000)
            cells.append(f"2023-12-31{between}23:59:{57 + whole:02}{comma}{part:06}{zone}" if whole < 3 else (
                f"2024-01-01{between}00:00:{whole - 3:02}{comma}{part:06}{zone}"))  # fmt: skip
        return timed("date", cells)
    yield Case(write(folder / "a.csv", stamped(" ", "")))
    yield Case(write(folder / "b.csv", stamped("T", "+01:00")))
    yield Case(write(folder / "c.csv", stamped(" ", ""), "\t"))
    yield Case(write(folder / "d.csv", stamped("T", "Z", ","), ";"))
    seconds = [i / FPS for i in range(len(walk_points()))]
    for form in ("31.12.2023 12:00:{:09.6f}", "12/31/2023 11:59:{:09.6f} PM", "31/12/2023 9:00:{:09.6f}",
                 "00:{:09.6f}", "12:00:{:09.6f}"):  # fmt: skip
        yield Case(write(folder / "e.csv", timed("Datum", [form.format(second) for second in seconds])))


@layout("times of day over midnight: 23:59:59.983, 00:00:00.000")
def over_midnight(folder):
    def of_day(i, form="{:02}:{:02}:{:09.6f}", start=86400 - 2):
        seconds = (start + i / FPS) % 86400
        return form.format(int(seconds // 3600), int(seconds // 60) % 60, seconds % 60)

    cells = [of_day(i) for i in range(len(walk_points()))]
    yield Case(write(folder / "a.csv", timed("time", cells)))
    yield Case(folder / "a.csv", note="column 'time' passes midnight")
    noon = [of_day(i, "12:{1:02}:{2:09.6f} AM" if i / FPS >= 2 else "11:{1:02}:{2:09.6f} PM") for i in range(len(cells))]
    yield Case(write(folder / "b.csv", timed("time", noon)))
    utc = [of_day(i, "{:02}:{:02}:{:09.6f}+02:00") for i in range(len(cells))]
    yield Case(write(folder / "c.csv", timed("time", utc)))
    lines = timed("date", ["2024-01-31"] * len(cells))  # the day on which the recording began
    lines = [[line[0], clock, *line[1:]] for clock, line in zip(["time", *cells], lines)]
    yield Case(write(folder / "d.csv", lines))
    back = [f"2024-01-31 {clock}" for clock in cells]
    yield Case(write(folder / "f.csv", timed("time", back)), error="f.csv:122: column 'time' is time, but does not")
    early = [of_day(i, start=3600 if i < 150 else 1800) for i in range(len(cells))]
    yield Case(write(folder / "e.csv", timed("time", early)), error="e.csv:152: column 'time' is time, but does not")


@layout("counters, such as `frame`, of any range")
def counters(folder):
    fps = ("--fps", str(FPS))
    for name in ("frame", "Frame#", "", "sample"):
        yield Case(write(folder / "a.csv", timed(name, range(7, 7 + len(walk_points())))), options=fps)
    for count in (256, 65536):
        yield Case(counted(folder / "b.csv", count), options=fps)


@layout("`Frame` and `Sub Frame`")
def subframes(folder):
    lines = table(walk_points(), with_underscore, first="Frame")
    rows = [[1 + i // 4, i % 4, *line[1:]] for i, line in enumerate(lines[1:])]
    head = ["Frame", "Sub Frame", *lines[0][1:]]
    yield Case(write(folder / "a.csv", [head, *rows]), options=("--fps", str(FPS)))
    names = [cell for joint in JOINTS for cell in (joint, "", "")]
    nexus = [["Trajectories"], [FPS], ["", "", *names], ["Frame", "Sub Frame", *"XYZ" * len(JOINTS)],
             ["", "", *["mm"] * len(names)], *rows]  # fmt: skip
    yield Case(write(folder / "b.csv", nexus))


@layout("rows that are missing, by the clock or the count")
def holes(folder):
    lines = timed("time", times())
    rows = write(folder / "a.csv", lines[: 1 + HOLE[0]] + lines[1 + HOLE[-1] + 1 :])
    yield Case(rows, "missing rows")
    yield Case(rows, note="rows are missing by the times: 10 of")
    lines = timed("packet counter", [i % 256 for i in range(len(walk_points()))])
    rows = write(folder / "b.csv", lines[: 1 + HOLE[0]] + lines[1 + HOLE[-1] + 1 :])
    yield Case(rows, "missing rows", ("--fps", str(FPS)))
    lines = trc(upright())
    rows = write(folder / "c.trc", lines[: 6 + HOLE[0]] + lines[6 + HOLE[-1] + 1 :], "\t")
    yield Case(rows, note="10 of")


@layout("a rate in the lines before the table: `# fps: 60`, `Frequency,60`")
def stated(folder):
    lines = [line[1:] for line in table(walk_points(), with_underscore)]
    for head in (["# fps: 60"], ["Frame rate = 60 Hz"], ["Frequency", "60"], ["Sampling rate (Hz)", "60"]):
        yield Case(write(folder / "a.csv", [head, ["name", "walk"], *lines]))


@layout("lines before the table that say another rate")
def contradictions(folder):
    said = "the lines before the table say 120 frames a second, but the times 60"
    export = [["120" if cell == str(FPS) else cell for cell in line] for line in motive(None)]
    for path, like in ((write(folder / "a.trc", trc(upright(), 120), "\t"), "upright"),
                       (write(folder / "b.csv", export), "space")):  # fmt: skip
        yield Case(path, like)
        yield Case(path, note=said)


@layout("times that go back; a row without a time")
def backward(folder):
    late = [f"{float(time) - (1 if i >= 150 else 0):.6f}" for i, time in enumerate(times())]
    yield Case(write(folder / "a.csv", timed("time", late)), error="a.csv:152: column 'time' is time, but does not")
    none = ["" if i == 150 else time for i, time in enumerate(times())]
    yield Case(write(folder / "b.csv", timed("time", none)), error="b.csv:152: column 'time' is time, but has no")


@layout("variable steps")
def variable(folder):
    count = len(walk_points())
    steps = [f"{i / FPS + 0.03 * math.sin(4 * math.pi * i / (count - 1)):.6f}" for i in range(count)]
    yield Case(write(folder / "a.csv", timed("time", steps)), note="resampled to 60")
