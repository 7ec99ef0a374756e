# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of the command: running it, and clips."""

import functools
import json
import math
import os
import pathlib
import random
import signal
import subprocess
import tempfile
import unittest

STLTSA = os.environ["STLTSA"]
WALKER = os.environ["STLTSA_WALKER"]
SCHEMAS = pathlib.Path(os.environ["STLTSA_SCHEMAS"])
MANUAL = pathlib.Path(os.environ["STLTSA_MANUAL"])

COMMANDS = ("info", "fit", "map", "unmap", "dimension", "decompose", "denoise", "synthesize", "batch",
            "compare", "events", "live")

_folder = tempfile.TemporaryDirectory(prefix="stltsa-cli-")
CLIPS = pathlib.Path(_folder.name)


def plain_environment(**changes):
    """The caller's environment without variables that turn colors on or off."""
    environment = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "TERM")}
    return {**environment, **changes}


def default_signals():
    """Background jobs of scripts ignore SIGINT, and child processes inherit that."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def run(*arguments, **settings):
    """Runs the command; returns output as bytes."""
    settings.setdefault("stdin", subprocess.DEVNULL)
    if "input" in settings:
        del settings["stdin"]
    return subprocess.run(
        [STLTSA, *map(os.fspath, arguments)],
        stdout=settings.pop("stdout", subprocess.PIPE),
        stderr=subprocess.PIPE,
        env=settings.pop("env", plain_environment()),
        timeout=120,
        check=False,
        **settings,
    )


class CommandTest(unittest.TestCase):
    """Adds checks of a run, and a separate folder for each test."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="stltsa-cli-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def done(self, *arguments, **settings):
        """Standard output of a run that must succeed."""
        result = run(*arguments, **settings)
        self.assertEqual(result.returncode, 0, result.stderr.decode(errors="replace"))
        return result.stdout

    def json(self, *arguments, **settings):
        return json.loads(self.done(*arguments, "--json", **settings))

    def fails(self, status, *arguments, **settings):
        """Message of a run that must fail with this status and write no result."""
        result = run(*arguments, **settings)
        message = result.stderr.decode(errors="replace")
        self.assertEqual(result.returncode, status, message)
        self.assertTrue(message.startswith("stltsa: "), message)
        if result.stdout is not None:
            self.assertEqual(result.stdout, b"")
        return message

    def assert_empty(self, folder):
        self.assertEqual(sorted(p.name for p in folder.iterdir()), [])


# ---- Clips. Each is made once per test program. ----


@functools.cache
def walk(fps=120):
    """A synthetic walk: standing, three cycles, standing."""
    path = CLIPS / f"walk{fps}.bvh"
    subprocess.run(
        [WALKER, "-o", path, "--borders", CLIPS / f"walk{fps}.json", "--fps", str(fps)], check=True
    )
    return path


@functools.cache
def walk_below_a_joint():
    """The same body; its root hangs from a joint that does not move, as some exporters write it."""
    hierarchy, motion = walk().read_text().split("MOTION\n")
    body = hierarchy.removeprefix("HIERARCHY\nROOT")
    head, times, *rows = motion.splitlines()
    path = walk().with_name("below.bvh")
    path.write_text("HIERARCHY\nROOT world\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nJOINT"
                    + body + "}\nMOTION\n" + "\n".join([head, times, *("0 0 0 " + row for row in rows)]) + "\n")
    return path


def write_csv(name, rows, heading=""):
    path = CLIPS / name
    lines = [",".join(f"{value:.6g}" for value in row) for row in rows]
    path.write_text(heading + "\n".join(lines) + "\n", encoding="ascii")
    return path


@functools.cache
def circle():
    """Plain numbers, three turns of a noisy loop; no frame rate in the file."""
    noise = random.Random(1)
    turns = [2 * math.pi * i / 60 for i in range(180)]
    return write_csv(
        "circle.csv",
        [
            [math.cos(t), math.sin(t), 0.3 * math.sin(2 * t) + 0.01 * noise.random()]
            for t in turns
        ],
    )


@functools.cache
def noisy_circle():
    """Thirty seconds of a loop, beside columns of noise that hold most of the variance."""
    noise = random.Random(5)
    rows = []
    for i in range(1500):
        turn = 2 * math.pi * i / 50
        rows.append([i / 50, 2 * math.cos(turn), 2 * math.sin(turn),
                     *(noise.gauss(0, 1) for _ in range(6))])
    return write_csv("noisy.csv", rows, "time,a,b,c,d,e,f,g,h\n")


@functools.cache
def limbs(names, style, legs=0.0, arms=0.0):
    """Named points of both sides for 10 s: legs that walk, steps of 0.57 s (left) and 0.53 s, or stand;
    arms that swing in turn."""
    def chain(x, y, z, angles, lengths):
        for angle, length in zip(angles, lengths, strict=True):
            yield x, y, z
            x, z = x + length * math.sin(angle), z - length * math.cos(angle)
        yield x, y, z

    rows = []
    for i in range(600):
        t, points = i / 60, []
        for y, turn in ((0.1, t / 1.1), (-0.1, (t - 0.57) / 1.1)):
            swing, bend = math.sin(2 * math.pi * turn), (1 - math.cos(2 * math.pi * turn + 0.6)) / 2
            thigh = legs * swing
            shank = thigh - 1.6 * legs * bend
            at = dict(zip(("Hip", "Knee", "Ankle"), chain(0, y, 0.92, (thigh, shank), (0.45, 0.42)), strict=True))
            for name, length, down in (("Heel", 0.085, -math.pi / 4), ("Toe", 0.175, 1.16)):
                at[name] = [*chain(*at["Ankle"], (shank + down,), (length,))][1]
            at.update(zip(("Shoulder", "Elbow", "Wrist"),
                          chain(0, 2 * y, 1.45, (-arms * swing, 0.3 - arms * swing), (0.3, 0.27)), strict=True))
            points += [at[name] for name in names]
        rows.append([t, *(v for x, y, z in points for v in (x + 2.7 * legs * t, y, z))])
    heads = [f"{style(side, name)}_{axis}" for side in ("left", "right") for name in names for axis in "xyz"]
    return write_csv(f"{heads[0]}{len(names)}{legs}{arms}.csv", rows, f"time,{','.join(heads)}\n")


def markers(heading=0.0):
    """Eight markers of a body that walks through the room, ten strides of 1 s; one drops out."""
    names = ",".join(f"m{p}_{axis}" for p in range(8) for axis in "xyz")
    rows = []
    for i in range(600):
        t, row = i / 60, []
        for p in range(8):
            side, level = 2 * (p % 2) - 1, p // 2
            ahead = 1.3 * t + 0.1 * (3 - level) * side * math.sin(2 * math.pi * t)
            across = 0.15 * side + 0.02 * level
            x = ahead * math.cos(heading) - across * math.sin(heading)
            y = ahead * math.sin(heading) + across * math.cos(heading)
            row += [0.0, 0.0, 0.0] if p == 3 and 90 <= i < 100 else [x, y, 0.1 + 0.5 * level]
        rows.append([t, *row])
    return write_csv(f"markers{heading}.csv", rows, f"time,{names}\n")


@functools.cache
def crowd():
    """Many turns of one loop, so that round frame numbers coincide."""
    turns = [2 * math.pi * i / 50 for i in range(1500)]
    return write_csv("crowd.csv", [[math.cos(t), math.sin(t), math.sin(2 * t)] for t in turns])


@functools.cache
def drift():
    """Moves on without repeating: no cycle."""
    return write_csv("drift.csv", [[0.1 * i, (0.02 * i) ** 2, 1.0] for i in range(200)])


@functools.cache
def bursts():
    """Four equal motions with pauses, and then one of another kind."""
    rows = []
    for _ in range(4):
        rows += [[0.0, 0.0, 0.0]] * 30
        rows += [[1 - math.cos(math.pi * i / 20), math.sin(math.pi * i / 20) ** 3, 0.0]
                 for i in range(40)]
    rows += [[0.0, 0.0, 0.0]] * 30
    rows += [[0.0, 0.0, 1 - math.cos(math.pi * i / 30)] for i in range(60)]
    rows += [[0.0, 0.0, 0.0]] * 30
    return write_csv("bursts.csv", rows)


@functools.cache
def two_motions():
    """Twelve seconds of one cyclic motion, then twelve of another."""
    rows = []
    for i in range(720):
        period, sizes = ((36, (3, 1, 2, 0.2, 0.1, 0.3)), (57, (0.2, 0.3, 0.1, 3, 2, 1)))[i >= 360]
        turn = 2 * math.pi * i / period
        rows.append([size * (math.sin(turn + c) + 0.3 * math.cos(2 * turn + 2 * c))
                     for c, size in enumerate(sizes)])
    return write_csv("two motions.csv", rows)


@functools.cache
def still():
    """Nothing moves."""
    return write_csv("still.csv", [[1.0, 2.0, 3.0]] * 100)


@functools.cache
def cut():
    """Two takes far apart in space: with few neighbors, two components."""
    return write_csv(
        "cut.csv",
        [[math.cos(0.1 * i) + (1000 if i >= 60 else 0), math.sin(0.1 * i)] for i in range(120)],
    )


@functools.cache
def long_clip():
    """Long enough that a fit with hundreds of neighbors takes seconds."""
    noise = random.Random(2)
    return write_csv("long.csv", [[noise.gauss(0, 1) for _ in range(8)] for _ in range(20000)])
