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
                    "--ramp": rng.choice([0, 0.2]), "--turn": rng.choice([0, 30]),
                    "--stand": rng.uniform(0, 2)}
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
        for build, answer in run.ask(path):
            right = run.judge(build, answer, truth, limit="before", wrong_limit=0.001)
            long = truth[0][1][-1] - truth[0][1][0] >= 1.5
            run.row("1.5 turns and more: clips without cycles", 0, "of", True).add(
                build, long and not answer["cycles"], long)
            run.note(build, right, path, f"{whole(truth)}: {kinds(answer)}")


def crops(run):
    """Borders stay where they are, in the time of the whole, if a clip is cropped."""
    for i, rng in run.cases(8):
        period, fps, named = rng.uniform(0.9, 1.3), 60, i % 8 < 4
        times, turns = made.clock(rng, rng.uniform(5, 9) * period, fps, period, 0.02)
        if i % 4 < 2:
            points, names = made.walk(run.body, turns, treadmill=bool(rng.integers(2)))
            points = points + 0.002 * rng.normal(size=points.shape)
            path = run.table("crop", points, fps, names if named else [f"m{k}" for k in range(len(names))])
            cropped(run, "markers" if named else "markers without sides", path, period, times, turns)
        else:
            path = run.path("crop", ".bvh")
            rows = run.body.stand + run.body.walking(turns)
            rows[:, 3:] += 0.5 * rng.normal(size=rows[:, 3:].shape)
            run.body.write(path, rows, fps)
            cropped(run, "skeleton", path, period, times, turns)
    walks = [("walk_normal_007", 1.069), ("walk_feminine_007", 1.091), ("run_normal_007", 0.774),
             ("walk_active_007", 0.953)]
    for _, (name, period) in run.half(walks):
        path = measuring.DATA / "moves" / f"dataset-2_{name}.bvh"
        if path.exists():
            frames = len(measuring.ClipFile(path).frames)
            cropped(run, "recorded", path, period, np.arange(frames) / 30, np.arange(frames) / 30 / period)


def cropped(run, what, path, period, times, turns):
    """A border may have to move for the crop to keep all whole cycles, but not farther."""
    borders = [[t for c in a["cycles"] for t in (c["begin_s"], c["end_s"])] for _, a in run.ask(path)]
    for share in (0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9):
        for ends in ((1, 0), (0, 1), (1, 1)):
            first, last = (round(share * period / times[1] * e) for e in ends)
            last = len(times) - last
            for build, answer in run.ask(f"{path}:{first}-{last}"):
                if not borders[build]:
                    continue
                found = {t + times[first] for c in answer["cycles"] for t in (c["begin_s"], c["end_s"])}
                moved = max((min(abs(t - b) for b in borders[build]) / period for t in found), default=0)
                apart = (np.interp(borders[build][0], times, turns) - turns[first]) % 1
                spare = (turns[last - 1] - turns[first]) % 1
                needed = 0 if apart <= spare else min(apart - spare, 1 - apart)
                lost = whole([(times[first:last], turns[first:last])]) - counted(answer)
                run.row(f"{what}: crops that move a border by a tenth", None).add(build, moved > 0.1, 1)
                run.row(f"{what}: the same, more than the count needs", 0, "of", True).add(
                    build, moved > 0.1 + needed, 1)
                limit = "before" if what == "recorded" else 0.02
                run.row(f"{what}: crops that lose a whole cycle", limit, "of", True).add(build, lost > 0, 1)
                run.note(build, lost <= 0 and moved <= 0.1 + needed, path,
                         f"{first}-{last}: {kinds(answer)}; moved {100 * moved:.0f} %, needed "
                         f"{100 * needed:.0f} %, lost {lost}")


def waves(run):
    """Hands that wave and clap, a foot that taps, while the body sways; a walk that slows to a stop."""
    made_up = [(name, lambda seed, name=name: recordings.one_part(run.body, seed, name, 10))
               for name in recordings.CARRIED]
    for name, record in [*made_up, ("slowing to a stop", lambda seed: recordings.slowing(run.body, seed))]:
        for i, _ in run.cases(8, name):
            recording = record(100 + i)
            path = run.path(name, ".bvh")
            run.body.write(path, recording.rows, recording.fps)
            truth = [piece for part in recording.parts for piece in part.pieces]
            for build, answer in run.ask(path):
                right = run.judge(build, answer, truth, f"{name}: ", "before", 0.05)
                run.note(build, right, path, f"{whole(truth)}: {kinds(answer)}")


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
                fine = np.linspace(0, len(turns) / 60, 100)  # with the time of the last frame
                right = run.judge(build, answer, [(fine, turns[0] + share * fine / fine[-1])],
                                  f"{share} periods: ", 0.95 if share in (1, 1.5) else "before")
                run.note(build, right, path, kinds(answer))


def nested(run):
    """A walk there and back: strides; loops within a period: both are named, or it is not sure."""
    for i, rng in run.cases(32, "walk"):
        ways, strides, turn = int(rng.choice([2, 4])), rng.uniform(1.5, 5), rng.uniform(0.5, 1.5)
        period, fps, jitter = rng.uniform(0.95, 1.25), 50, 0.02
        closed = i // 2 % 2
        if closed:  # a whole number of strides, and the last turn leads into the first frame
            ways, turn, jitter = 2, 0.9, 0
            strides = np.ceil(2 * strides) / 2 - turn / period
        times, turns = made.clock(rng, ways * (strides * period + turn), fps, period, jitter)
        heading = np.zeros(len(times))
        for way in range(1 - closed, ways + closed):
            heading += 180 * made.minimum_jerk((times - way * (strides * period + turn)) / turn + 0.5)
        points, names = made.walk(run.body, turns, heading)
        points += 0.003 * rng.normal(size=points.shape)
        if i // 4 % 2:  # columns of no known meaning, whose largest period is the way
            path, options = run.table("way", 100 * points.reshape(len(points), -1)[:, ::2]), ["--fps", fps]
        else:
            path, options = run.table("way", points, fps, names), []
        for build, answer in run.ask(path, *options):
            what = "walk there and back, raw: " if options else "walk there and back: "
            right = near(answer["period_s"], period) or (bool(options) and answer["period_s"] is None)
            claim = "period is the stride, or none" if options else "period is the stride"
            run.row(f"{what}{claim}", 1).add(build, right, 1)
            run.judge(build, answer, [(times, turns)], what, "before", 0.01)
            run.note(build, right, path, f"{period:.2f} s: {kinds(answer)}")
    for i, rng in run.cases(24, "loops"):
        rows, times, turns, loops = made.hand(rng, "spiral", rng.uniform(7, 25))
        path = run.table("loops", rows, None, ["hand_x", "hand_y", "hand_z"])
        large = times[-1] / (turns[-1] - turns[0])
        for build, answer in run.ask(path, "--fps", 100):
            both = all(any(near(n, p, 0.15) for n in numbers(answer)) for p in (large, large / loops))
            unsure = all(s["confidence"] < 0.5 for s in cyclic(answer))
            run.judge(build, answer, [(times, turns)], "loops: ", "before", "before")
            run.row("loops: both named, or below 0.5", 0.95).add(build, both or unsure, 1)
            right = not cyclic(answer) or near(answer["period_s"], large, 0.15)
            run.row("loops: the large period, or no claim", "before").add(build, right, 1)
            run.note(build, both or unsure, path, f"{large:.2f} and {large / loops:.2f} s: {kinds(answer)}")


def timing(run):
    """CPU time of decompose beside the build before, and of other commands beside decompose."""
    rng = np.random.default_rng(1)
    turns = made.clock(rng, 5, 120, 1.1, 0.02)[1]
    points, names = made.walk(run.body, turns)
    walk = run.table("walk", points + 0.002 * rng.normal(size=points.shape), 120, names)
    hand, times = made.hand(rng, "to and fro", 10)[:2]
    skeleton = run.path("walk", ".bvh")
    rows = run.body.stand + run.body.walking(turns)
    rows[:, 3:] += 0.5 * rng.normal(size=rows[:, 3:].shape)
    run.body.write(skeleton, rows, 120)
    squats = run.table("squats", made.repetitions(rng, "squat", 5, None, 50)[0], 50, made.NAMES)
    long = run.path("mixture", ".bvh")
    mixture = recordings.mixture(run.body, 1, 180)
    run.body.write(long, mixture.rows, mixture.fps)
    hand = run.table("hand", hand)

    def cost(commands, repeats):
        """Median CPU seconds of each command and build, in turns, without the start of the program."""
        seconds = [[[] for _ in run.builds] for _ in range(len(commands) + 1)]
        for turn in range(repeats):
            for each, words in zip(seconds, [["--version"], *commands]):
                for build, spent in list(enumerate(each))[::1 - 2 * (turn % 2)]:
                    before = resource.getrusage(resource.RUSAGE_CHILDREN)
                    run.command(build, *words, *(["--threads", 1] * (len(words) > 1)))
                    after = resource.getrusage(resource.RUSAGE_CHILDREN)
                    spent.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
        start, *others = [[statistics.median(spent) for spent in each] for each in seconds]
        return [[s - s0 for s, s0 in zip(each, start)] for each in others]

    short = {"walk": walk, "skeleton": skeleton, "hand": hand, "squats": squats}
    spent = cost([["decompose", path, "--json", *(["--fps", 100] * (path == hand))]
                  for path in short.values()], 24)
    spent += cost([["decompose", long, "--json"]], 6)
    for name, seconds in zip([*short, "recording of 3 min"], spent):
        for build, each in enumerate(seconds):
            run.row(f"decompose: {name}", None, "mean", True, " ms").add(build, 1000 * each)
        what, limit = ("short clips", 0.8) if name in short else ("recordings", 1.0)
        if len(seconds) > 1:
            run.row(f"{what}: share of the time before", limit, "mean", True).add(1, seconds[1] / seconds[0])
    words = [["events", skeleton, "--mark", "200=x", "--json"], ["compare", skeleton, "--json"],
             ["fit", skeleton, "-o", run.path("model", ".stltsa")]]
    base, *others = cost([["decompose", skeleton, "--json"], *words], 24)
    for (name, *_), seconds in zip(words, others):
        for build, each in enumerate(seconds):
            run.row(f"{name} of 5 s: times decompose", 2, "mean", True).add(build, each / base[build])
