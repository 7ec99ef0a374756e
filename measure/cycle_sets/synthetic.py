# SPDX-License-Identifier: BSD-3-Clause
"""The sets that are made up."""

import numpy as np
from recording.motions import smooth_noise

from . import made
from .run import counted, cyclic, kinds, near


def repetitions(run):
    """N squats, jumping jacks, bows: counted exactly."""
    for what, pauses, raw in (("back to back", None, False), ("with pauses", (0.3, 1), False),
                              ("raw columns, back to back", None, True),
                              ("raw columns, with pauses", (0.3, 1), True)):
        for kind in made.ACTIONS:
            for i, rng in run.cases(38, what, kind):
                count, rate = 2 + i % 19, float(rng.choice([30, 50, 60, 100]))
                points, begins, ends = made.repetitions(rng, kind, count, pauses, rate)
                options = []
                if raw:
                    flat = points.reshape(len(points), -1)
                    mix = rng.normal(size=(flat.shape[1], 8)) / 6
                    path, options = run.table(f"{kind} raw {count}", 100 * (flat @ mix)), ["--fps", rate]
                else:
                    path = run.table(f"{kind} {count}", points, rate, made.NAMES)
                for build, answer in run.ask(path, *options):
                    right = counted(answer) == count
                    run.row(f"{kind}s {what}: exact", 0.98).add(build, right, 1)
                    run.note(build, right, path, f"{count}: {kinds(answer)}")


def standing(run):
    """Breathing and sway are rest; a jumping point does not hide a walk."""
    for i, rng in run.cases(60):
        times = np.arange(round(rng.uniform(10, 60) * 50)) / 50
        legs = np.zeros(len(times))
        points = made.pose("squat", legs, legs) + made.still(
            rng, times, rng.uniform(0.001, 0.003), rng.uniform(0.001, 0.004), rng.uniform(0.0003, 0.001))
        path = run.table("standing", points * rng.choice([1, 1000]), 50, made.NAMES)
        for build, answer in run.ask(path):
            rest = bool(answer["segments"]) and all(s["kind"] == "rest" for s in answer["segments"])
            run.row("without cycles", 1).add(build, not answer["cycles"], 1)
            run.row("all rest", 1).add(build, rest, 1)
            run.note(build, rest, path, kinds(answer))
    for i, rng in run.cases(30, "bad point"):
        times, turns = made.clock(rng, rng.uniform(5, 10), 50, rng.uniform(0.95, 1.25), 0.02)
        points, names = made.walk(run.body, turns, treadmill=bool(rng.integers(2)))
        points += 0.002 * rng.normal(size=points.shape)
        bad = rng.integers(len(names))
        jumps = rng.uniform(size=len(times)) < rng.uniform(0.01, 0.1)
        points[jumps, bad] += rng.normal(size=(jumps.sum(), 3)) * rng.uniform(0.3, 3)
        path = run.table("bad point", points, 50, names)
        for build, answer in run.ask(path):
            right = run.judge(build, answer, [(times, turns)], "walk beside a point that jumps: ", 0.95)
            run.note(build, right, path, f"{turns[-1] - turns[0]:.1f}: {kinds(answer)}")


def exact(run):
    """15 cycles of 1.07 s with white noise."""
    for noise in (0.02, 0.1, 0.3):
        for i, rng in run.cases(12, noise):
            turns = rng.uniform() + np.arange(round(107 * rng.uniform(15.2, 15.8))) / 107
            rows = made.columns(rng, turns)
            path = run.table(f"exact {noise}", rows + noise * rng.normal(size=rows.shape))
            means = [np.nan] * len(run.builds)
            for build, answer in run.ask(path, "--fps", 100):
                right = run.judge(build, answer, [(np.arange(len(turns)) / 100, turns)], limit=0.99)
                lengths = [c["end_s"] - c["begin_s"] for c in answer["cycles"]]
                if len(lengths) > 1:
                    means[build] = np.mean(lengths)
                    run.row(f"SD by decompose, noise {noise}", "before", "median", True, " ms").add(
                        build, 1000 * np.std(lengths, ddof=1))
                    run.row("mean: largest error", 0.1, "worst", True, " %").add(
                        build, 100 * abs(means[build] / 1.07 - 1))
                run.note(build, right, path, kinds(answer))
            for build, answer in run.ask(path, path, "--fps", 100, command="compare"):
                time = answer.get("cycle_time_s", {})
                if time.get("first_sd") is not None:
                    run.row(f"SD by compare, noise {noise}", "before", "median", True, " ms").add(
                        build, 1000 * time["first_sd"])
                    run.row("compare has another mean: by at most", 1e-9, "worst", True, " ms").add(
                        build, 1000 * abs(time["first"] - means[build]))


def ramps(run):
    """The tempo changes evenly."""
    for first, last, seconds in ((1.2, 0.6, 30), (0.6, 1.2, 30), (2.0, 0.5, 30)):
        for i, rng in run.cases(8, first):
            times, turns = made.clock(rng, seconds, 60, lambda t: first + (last - first) * t / t[-1], 0.01)
            if i % 4 < 2:
                rows = made.columns(rng, turns)
                path, options = run.table("ramp", rows + 0.05 * rng.normal(size=rows.shape)), ["--fps", 60]
            else:
                points, names = made.walk(run.body, turns)
                points += 0.003 * rng.normal(size=points.shape)
                path, options = run.table("ramp", points, 60, names), []
            for build, answer in run.ask(path, *options):
                right = run.judge(build, answer, [(times, turns)], f"{first} to {last} s: ", 0.98)
                run.note(build, right, path, f"{turns[-1] - turns[0]:.1f}: {kinds(answer)}")


def phase_error(run, build, path, options, times, turns):
    """Median distance of the phase from the truth without the best constant, % of a cycle."""
    table = run.folder / "phase.csv"
    run.command(build, "decompose", path, *options, "--json", "--phase", table)
    frames = np.genfromtxt(table, delimiter=",", names=True, comments=None)
    apart = np.interp(frames["seconds"], times, turns, np.nan, np.nan) - frames["phase"]
    apart = apart[~np.isnan(apart)]
    if len(apart) == 0:
        return np.nan
    apart = (apart - np.angle(np.exp(2j * np.pi * apart).mean()) / 2 / np.pi + 0.5) % 1 - 0.5
    return 100 * float(np.median(np.abs(apart - np.median(apart))))


def hands(run):
    """Hands that move to and fro, in a circle there and back, in a spiral."""
    for kind in ("to and fro", "there and back", "spiral"):
        for i, rng in run.cases(16, kind):
            rows, times, turns, _ = made.hand(rng, kind)
            names = ["hand_x", "hand_y", "hand_z"]
            path = run.table(kind, rows, None, names)
            metres = run.table(f"{kind} m", rows / 1000, None, names)
            offset = run.table(f"{kind} offset", rows + (5000, -3000, 800), None, names)
            options = ["--fps", 100]
            others = [[counted(a) for _, a in run.ask(p, *options)] for p in (metres, offset)]
            for build, answer in run.ask(path, *options):
                count = sum(s["count"] for s in cyclic(answer))
                run.judge(build, answer, [(times, turns)], "all: ", 0.97, 0.02)
                good = abs(count - (turns[-1] - turns[0])) <= 1.5 and near(
                    answer["period_s"], 30 / (turns[-1] - turns[0]))
                same = all(o[build] == counted(answer) for o in others)
                run.row(f"{kind}: count and period", 0.95).add(build, good, 1)
                run.row("all: the same in meters and elsewhere", 1).add(build, same, 1)
                if good:
                    error = phase_error(run, build, path, options, times, turns)
                    run.row("all: phase, median of clips", 1, "median", True, " %").add(build, error)
                run.note(build, good and same, path, f"{turns[-1] - turns[0]:.1f}: {kinds(answer)}"
                         f"  {[o[build] for o in others]}")


def acyclic(run):
    """No cycle is invented."""
    for i, rng in run.cases(90, "noise"):
        rate, knot = 50, (0.1, 0.2, 0.5, 1, 2, 4)[i // 2 % 6]
        times = np.arange(round(rng.uniform(20, 60) * rate)) / rate
        rows = np.stack([smooth_noise(rng, times, knot) for _ in range(rng.integers(3, 31))], 1)
        path = run.table(f"noise {knot}", rows + rng.choice([0, 0.05]) * rng.normal(size=rows.shape))
        none(run, path, "smooth noise: clips with cycles", "--fps", rate)
    for i, rng in run.cases(60, "single"):
        kind = list(made.ACTIONS)[i // 2 % 3]
        points, _, _ = made.repetitions(rng, kind, 1, None, 60)
        path = run.table(f"single {kind}", points, 60, made.NAMES)
        none(run, path, "a single action: clips with cycles")
        for build, answer in run.ask(path):
            run.row("a single action: counted once", 0.98).add(build, counted(answer) == 1, 1)
    for i, rng in run.cases(30, "sway"):
        times = np.arange(round(rng.uniform(10, 40) * 30)) / 30
        legs = np.maximum(0.3 + 0.12 * smooth_noise(rng, times, 1.5), 0)
        points = made.pose("bow", legs, legs) + made.still(rng, times, 0.03, 0.004, 0.001)
        path = run.table("sway", points, 30, made.NAMES)
        none(run, path, "shifting of weight: clips with cycles", limit=0.05)


def none(run, path, what, *options, limit=0.01):
    for build, answer in run.ask(path, *options):
        found = bool(cyclic(answer))
        run.said[build] += [(c["confidence"], False) for c in answer["cycles"]]
        run.row(what, limit, "of", True).add(build, found, 1)
        run.note(build, not found, path, kinds(answer))
