# SPDX-License-Identifier: BSD-3-Clause
"""Sets of the synthetic walker, and single cycles; time."""

import json
import resource
import statistics
import subprocess

import measuring
import numpy as np
from recording import synthetic as recordings

from . import made
from .run import counted, cyclic, kinds, near, numbers, whole


def gait(run):
    """Walks of many kinds, cropped at random."""
    for i, rng in run.cases(120):
        period, fps = rng.uniform(0.8, 1.5), int(rng.choice([30, 60, 100, 120]))
        settings = {"--fps": fps, "--cycles": rng.integers(2, 10), "--period": period,
                    "--noise": rng.choice([0, 1, 3]), "--seed": i, "--stride": rng.uniform(0.6, 1.2),
                    "--ramp": rng.choice([0, 0.2]), "--turn": rng.choice([0, 30]), "--stand": rng.uniform(0, 2)}
        path = run.path("walk", ".bvh")
        subprocess.run([run.builds[-1] / "tests" / "walker" / "stltsa-walker", "-o", path,
                        *[str(word) for pair in settings.items() for word in pair]], check=True)
        true = json.loads(path.with_suffix(".json").read_text())
        times = np.array([*[c["begin_s"] for c in true["cycles"]], true["cycles"][-1]["end_s"]])
        clip = measuring.ClipFile(path)
        first, last = 0, len(clip.frames)
        if i % 4 < 2:  # cut within the strides
            first = round((times[0] + rng.uniform(-0.5, 0.7) * period) * fps)
            last = round((times[-1] + rng.uniform(-0.7, 0.5) * period) * fps)
            first, last = max(first, 0), min(last, len(clip.frames))
            clip.write(path, clip.frames[first:last])
        fine = np.arange(max(first / fps, times[0]), min((last - 1) / fps, times[-1]), 0.005)
        truth = [(fine - first / fps, np.interp(fine, times, np.arange(len(times))))]
        count = whole(truth)
        for build, answer in run.ask(path):
            right, wrong = run.judge(build, answer, truth)
            run.row("cycles", "before").add(build, right, count)
            run.row("wrong ones", 0.001, "of", True).add(build, wrong, max(count, 1))
            if truth[0][1][-1] - truth[0][1][0] >= 1.5:
                run.row("1.5 turns and more: clips without cycles", 0, "of", True).add(build, not right, 1)
            run.note(build, right >= count and not wrong, path, f"{count}: {kinds(answer)}")


def crops(run):
    """Borders stay where they are, in the time of the whole, if a clip is cropped."""
    for i, rng in run.cases(8):
        period, fps = rng.uniform(0.9, 1.3), 60
        times, turns = made.clock(rng, rng.uniform(5, 9) * period, fps, period, 0.02)
        markers = i % 4 < 2
        if markers:
            points, names = made.walk(run.body, turns, treadmill=i % 8 < 4)
            points = points + 0.002 * rng.normal(size=points.shape)
            path = run.table("crop", points, fps, names if i % 8 < 4 else [f"m{k}" for k in range(len(names))])
        else:
            path = run.path("crop", ".bvh")
            rows = run.body.stand + run.body.walking(turns)
            run.body.write(path, rows + 0.5 * rng.normal(size=rows.shape) * (np.arange(rows.shape[1]) > 2), fps)
        what = "markers" if markers else "skeleton"
        borders = [[c["begin_s"] for c in a["cycles"]] + [c["end_s"] for c in a["cycles"]][-1:]
                   for _, a in run.ask(path)]
        for share in (0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9):
            for ends in ((1, 0), (0, 1), (1, 1)):
                first, last = (round(share * period * fps * e) for e in ends)
                last = len(times) - last
                inside = [(times[first:last] - times[first], turns[first:last])]
                for build, answer in run.ask(f"{path}:{first}-{last}"):
                    found = sorted({t + times[first] for c in answer["cycles"] for t in (c["begin_s"], c["end_s"])})
                    moved = [min(abs(t - b) for b in borders[build]) / period for t in found if borders[build]]
                    row = run.row(f"{what}: 95 % of the borders move by at most", 2, "p95", True, " %")
                    for m in moved:
                        row.add(build, 100 * m)
                    run.row(f"{what}: a border moves by more than a tenth: crops", 0, "of", True).add(
                        build, max(moved, default=0) > 0.1, 1)
                    enough = counted(answer) >= whole(inside)
                    run.row(f"{what}: no whole cycle lost", 0.98).add(build, enough, 1)
                    run.note(build, enough and max(moved, default=0) < 0.1, path,
                             f"{first}-{last}: {kinds(answer)}; moved {100 * max(moved, default=0):.0f} %")


def closed(run):
    """One period exactly, and a little more."""
    for share in (1, 1.2, 1.3, 1.5):
        for i, rng in run.cases(16, share):
            period = rng.uniform(0.8, 1.6)
            turns = rng.uniform() + np.arange(round(period * 60 * share) + i // 2 % 2) / round(period * 60)
            if i // 4 % 2:
                path, options = run.path(f"closed {share}", ".bvh"), []
                run.body.write(path, run.body.stand + run.body.walking(turns), 60)
            else:
                rows = made.columns(rng, turns, 12, 3)
                path = run.table(f"closed {share}", rows + 0.01 * rng.normal(size=rows.shape))
                options = ["--fps", 60]
            for build, answer in run.ask(path, *options):
                right, wrong = run.judge(build, answer, [(np.arange(len(turns)) / 60, turns)])
                limit = 0.95 if share in (1, 1.5) else "before"
                run.row(f"{share} periods: one cycle", limit).add(build, right == 1, 1)
                run.row("wrong ones", 0, "sum", True).add(build, wrong)
                run.note(build, right == 1, path, kinds(answer))


def nested(run):
    """A walk there and back: strides; loops within a period: both are named, or it is not sure."""
    for i, rng in run.cases(24, "walk"):
        ways, strides, turn = int(rng.choice([2, 4])), rng.uniform(1.5, 5), rng.uniform(0.5, 1.5)
        period, fps = rng.uniform(0.95, 1.25), 50
        times, turns = made.clock(rng, ways * (strides * period + turn), fps, period, 0.02)
        heading = np.zeros(len(times))
        for way in range(1, ways):
            heading += 180 * made.minimum_jerk((times - way * (strides * period + turn)) / turn + 0.5)
        points, names = made.walk(run.body, turns, heading)
        path = run.table("there and back", points + 0.003 * rng.normal(size=points.shape), fps, names)
        for build, answer in run.ask(path):
            right, wrong = run.judge(build, answer, [(times, turns)])
            run.row("walk there and back: period is the stride", 1).add(build, near(answer["period_s"], period), 1)
            run.row("walk there and back: cycles", "before").add(build, right, whole([(times, turns)]))
            run.row("walk there and back: wrong ones", 0.01, "of", True).add(build, wrong, right + wrong)
            run.note(build, near(answer["period_s"], period), path, f"{period:.2f} s: {kinds(answer)}")
    for i, rng in run.cases(24, "loops"):
        rows, times, turns, loops = made.hand(rng, "spiral", rng.uniform(7, 25))
        path = run.table("loops", rows, None, ["hand_x", "hand_y", "hand_z"])
        large = times[-1] / (turns[-1] - turns[0])
        for build, answer in run.ask(path, "--fps", 100):
            both = all(any(near(n, p, 0.15) for n in numbers(answer)) for p in (large, large / loops))
            unsure = all(s["confidence"] < 0.5 for s in cyclic(answer))
            run.judge(build, answer, [(times, turns)])
            run.row("loops: both named, or below 0.5", 0.95).add(build, both or unsure, 1)
            right = not cyclic(answer) or near(answer["period_s"], large, 0.15)
            run.row("loops: the large period, or no claim", "before").add(build, right, 1)
            run.note(build, both or unsure, path, f"{large:.2f} and {large / loops:.2f} s: {kinds(answer)}")


def timing(run):
    """CPU time of decompose beside the build before, and of other commands beside decompose."""
    rng = np.random.default_rng(1)
    points, names = made.walk(run.body, np.arange(500) / 110)
    walk = run.table("walk", points, 100, names)
    hand, times = made.hand(rng, "to and fro", 10)[:2]
    skeleton = run.path("walk", ".bvh")
    run.body.write(skeleton, run.body.stand + run.body.walking(np.arange(600) / 132), 120)
    squats = run.table("squats", made.repetitions(rng, "squat", 5, None, 50)[0], 50, made.NAMES)
    long = run.path("mixture", ".bvh")
    mixture = recordings.mixture(run.body, 1, 180)
    run.body.write(long, mixture.rows, mixture.fps)
    hand = run.table("hand", hand)

    def cost(words, repeats=7):
        """Median CPU seconds of each build, without the start of the program."""
        seconds = [[] for _ in run.builds]
        for _ in range(repeats):
            for build, each in enumerate(seconds):
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                run.command(build, *words)
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                each.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        return [statistics.median(each) for each in seconds]

    start = cost(["--version"], 15)
    short = {"walk": walk, "skeleton": skeleton, "hand": hand, "squats": squats}
    for name, path in {**short, "recording of 3 min": long}.items():
        spent = [c - s for c, s in zip(cost(["decompose", path, "--json", *(["--fps", 100] * (path == hand))],
                                            3 if path == long else 9), start)]
        limit = 1.0 if path == long else 0.8
        for build, seconds in enumerate(spent):
            run.row(f"decompose: {name}", None, "mean", True, " ms").add(build, 1000 * seconds)
            if len(spent) > 1 and build:
                what = "recordings" if path == long else "short clips"
                run.row(f"{what}: share of the time before", limit, "mean", True).add(build, seconds / spent[0])
    base = cost(["decompose", skeleton, "--json"], 9)
    for words in (["events", skeleton, "--mark", "200=x", "--json"], ["compare", skeleton, "--json"],
                  ["fit", skeleton, "-o", run.path("model", ".stltsa")]):
        for build, (seconds, one) in enumerate(zip(cost(words, 9), base)):
            run.row(f"{words[0]} of 5 s: times decompose", 2, "mean", True).add(
                build, (seconds - start[build]) / (one - start[build]))
