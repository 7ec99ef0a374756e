# SPDX-License-Identifier: BSD-3-Clause
"""The sets that were recorded, in ../shared/data (or $STLTSA_DATA) and ../shared/cases."""

import csv
import json
import subprocess
import sys

import measuring
import numpy as np

from .run import counted, cyclic, kinds, near
from .synthetic import phase_error

# Seconds from strike to strike, from the ankles (measure/clips).
WALKS = {"walk_from_standing_1.bvh": 1.114, "walk_from_standing_2.bvh": 1.210, "35_01.amc": 1.121,
         "02_03.amc": 0.770, "cmu_run_filtered.bvh": 0.771, "86_01.amc:0-500": 1.745,
         "86_01.amc:1144-2024": 1.663, "86_01.amc:2504-3150": 1.889}
# Prints the events of a C3D file, and the answer without them, by the binding of a build.
BINDING = """
import json, sys
sys.path.insert(0, sys.argv[1] + "/measure")
import measuring
stltsa = measuring.binding(sys.argv[2])
clip = stltsa.read_clip(sys.argv[3])
plain = measuring.without_events(stltsa, clip)
print(json.dumps({"events": [(e.context, e.label, e.seconds) for e in clip.events],
                  "answer": json.loads(stltsa.decompose(plain).to_json())}))
"""


def labels(name):
    return list(csv.DictReader((measuring.DATA / "labels" / name).read_text().splitlines()))


def numbers_of(text):
    return np.array(text.split(), float)


def moves(run):
    """Short moves by their labels, walks of the CMU database."""
    rows = [(measuring.DATA / "moves" / row["file"], row["kind"], float(row["period_s"] or 0),
             float(row["swings"] or 0)) for row in labels("moves.csv")]
    rows += [(measuring.DATA / "cmu" / name, "gait", period, 0) for name, period in WALKS.items()]
    for _, (path, kind, period, swings) in run.half(rows):
        for build, answer in run.ask(path):
            cycles, good = len(answer["cycles"]), True
            if kind == "gait" and period:
                good = near(answer["period_s"], period)
                run.row("gait: period", 1).add(build, good, 1)
                fit = sum(near(c["end_s"] - c["begin_s"], period, 0.2) for c in answer["cycles"])
                run.row("gait: cycles as long as the period", "before").add(build, fit, cycles)
                run.row("gait: number of cycles", "before", "sum").add(build, cycles)
            elif swings:
                good = abs(counted(answer) - swings) <= 1
                run.row("waves: count within one", 0.9).add(build, good, 1)
                run.row("waves: swings counted", "before").add(build, cycles, swings)
                run.row("waves: period", "before").add(build, near(answer["period_s"], period), 1)
            elif "walk-back" in path.name:
                good = cycles == 1
                run.row("closed stride: one cycle", 1).add(build, good, 1)
            elif kind.startswith(("bow", "raise")):
                good = not cyclic(answer)
                run.row("bows, raises: clips with cycles", 0, "of", True).add(build, not good, 1)
            elif kind in ("kick", "punch", "slash"):
                good = counted(answer) >= 2
                run.row("kicks, punches, slashes: counted", 1).add(build, good, 1)
            run.note(build, good, path, f"{period:.2f} s {swings}: {kinds(answer)}")


def hands(run):
    """Hands against the marks that a person set."""
    for _, row in run.half(labels("hands.csv")):
        marks = numbers_of(row["begins"])
        source = measuring.DATA / "hands" / f"{row['file']}.csv"
        columns = np.genfromtxt(source, delimiter=",", skip_header=1)  # some cells are empty
        names, options = source.read_text().split("\n")[0].split(","), ["--fps", 100]
        others = [[counted(a) for _, a in run.ask(run.table("hand", moved, None, names), *options)]
                  for moved in (columns / 1000, columns + (5000, -3000, 800))]
        for build, answer in run.ask(source, *options):
            count, turns = sum(s["count"] for s in cyclic(answer)), len(marks) - 1
            period = (marks[-1] - marks[0]) / turns
            further = [m for m in (marks[0] - period, *marks, marks[-1] + period) if 0 <= m < len(columns)]
            run.judge(build, answer, [(np.array(further) / 100, np.arange(len(further)))])
            good = turns - 1 <= count <= len(marks) + 1 and near(answer["period_s"], period / 100)
            same = all(other[build] == counted(answer) for other in others)
            run.row("count within one, and period", 1).add(build, good, 1)
            run.row("the same in meters and elsewhere", 1).add(build, same, 1)
            error = 50
            if good:
                error = phase_error(run, build, source, options, marks / 100, np.arange(len(marks)))
            run.row("phase within 1 % at the median: files", "before").add(build, error <= 1, 1)
            if good:
                run.row("phase: mean of the medians", 1, "mean", True, " %").add(build, error)
            run.note(build, good and same and error <= 1, source,
                     f"{turns} of {period / 100:.2f} s: {kinds(answer)}; "
                     f"{error:.2f} %; others {[other[build] for other in others]}")


def imu(run):
    """Angular velocities: strides of two walks, placed against the strikes of one foot."""
    for _, row in run.half(labels("imu.csv")):
        walks = [("walk_begin", "turn_begin"), ("turn_end", "walk_end")]
        feet = []
        for foot in ("left", "right"):
            strikes = numbers_of(row[f"{foot}_strikes"])
            parts = [strikes[(strikes >= int(row[a]) - 10) & (strikes <= int(row[b]) + 10)] / 100
                     for a, b in walks]
            feet.append([(part, np.arange(len(part))) for part in parts if len(part) > 1])
        path = measuring.DATA / "imu" / f"{row['file']}.csv"
        for build, answer in run.ask(path, "--fps", 100):
            right = run.judge(build, answer, feet[0], "", "before", 0.02)
            starts = [c["begin_s"] for c in answer["cycles"]]
            spread = [scatter(starts, pieces) for pieces in feet]
            for pieces in zip(*feet):
                within = min(scatter(starts, [piece]) for piece in pieces)
                if not np.isnan(within):
                    run.row("SD of the starts in one walk: mean", 20, "mean", True, " ms").add(build, within)
            if answer["cycles"]:
                run.row("SD of the starts: mean", 20, "mean", True, " ms").add(build, min(spread))
                run.row("SD of the starts: worst", "before", "worst", True, " ms").add(build, min(spread))
            run.note(build, min(spread) <= 20 and right, path, f"{kinds(answer)}; SD {min(spread):.0f} ms")


def scatter(starts, pieces):
    """Milliseconds by which starts vary around the strikes, without the best constant."""
    off = []
    for times, _ in pieces:
        inside = [s for s in starts if times[0] <= s < times[-1]]
        i = np.searchsorted(times, inside, "right") - 1
        off += list(zip((inside - times[i]) / (times[i + 1] - times[i]), times[i + 1] - times[i]))
    if len(off) < 2:
        return np.nan
    share, stride = np.array(off).T
    mean = np.angle(np.exp(2j * np.pi * share).mean()) / 2 / np.pi
    return 1000 * float(np.std(((share - mean + 0.5) % 1 - 0.5) * stride, ddof=1))


def cases(run):
    """Small inputs that were once answered wrongly."""
    folder = measuring.DATA / ".." / "cases"
    for name, right in (("five_squats", lambda a: counted(a) == 5),
                        ("static_2mm", lambda a: all(s["kind"] == "rest" for s in a["segments"]))):
        for build, answer in run.ask(folder / f"{name}.csv"):
            run.row(name, 1).add(build, right(answer) and bool(answer["segments"]), 1)
            run.note(build, right(answer), folder / name, kinds(answer))
    for build, answer in run.ask(folder / "steps_sym.csv"):
        lengths = [s["end_s"] - s["begin_s"] for s in answer["steps"]]
        run.row("steps_sym: steps", None, "sum").add(build, len(lengths))
        if lengths:
            run.row("steps_sym: longest less shortest", 2, "worst", True, " ms").add(
                build, 1000 * np.ptp(lengths))


def steps(run):
    """Steps of markers against the heel strikes stored with them, which the library does not see."""
    for _, path in run.half(sorted((measuring.DATA / "markers").glob("*.c3d"))):
        for build, folder in enumerate(run.builds):
            done = subprocess.run([sys.executable, "-c", BINDING, folder.parent, folder, path],
                                  check=False, capture_output=True, text=True)
            if done.returncode:
                print(f"    {path.name}: {done.stderr[-300:]}")
                continue
            found = json.loads(done.stdout)
            answer = found["answer"]
            strikes = sorted((s, foot) for foot, s in map(heel_strike, found["events"]) if foot)
            name = path.stem[:12]
            sides = {"L": [], "R": []}
            for step in answer["steps"]:
                add_step(sides, step["begin_s"], step["end_s"], strikes)
            run.row(f"{name}: steps", None, "sum").add(build, len(answer["steps"]))
            if sides["L"] and sides["R"]:
                (left, true_left), (right, true_right) = (np.mean(sides[s], 0) for s in "LR")
                said = 200 * (right - left) / (right + left)
                true = 200 * (true_right - true_left) / (true_right + true_left)
                run.row(f"{name}: asymmetry", None, "mean", False, " %").add(build, said)
                run.row(f"{name}: true asymmetry of these steps", None, "mean", False, " %").add(
                    build, true)
                run.row(f"{name}: asymmetry off by", 2, "mean", True, " %").add(build, abs(said - true))
                run.row(f"{name}: step times off by", 10, "worst", True, " ms").add(
                    build, 1000 * max(abs(left - true_left), abs(right - true_right)))


def heel_strike(event):
    """The foot of a heel strike and its time, or None."""
    context, label, seconds = event
    for foot, side in (("L", "left"), ("R", "right")):
        if f"{foot}HS" in (context, label) or (context.lower() == side and "strike" in label.lower()):
            return foot, seconds
    return None, seconds


def add_step(sides, begin, end, strikes):
    """A step is that of the foot that strikes first in it, up to the next strike of the other foot."""
    early = 0.1 * (end - begin)
    for (at, foot), (following, other) in zip(strikes[:-1], strikes[1:]):
        if begin - early <= at < end - early and foot != other:
            sides[foot].append((end - begin, following - at))
            return
