# SPDX-License-Identifier: BSD-3-Clause
"""Asks the command of each build, judges its cycles, and keeps the rows of the table."""

import json
import re
import subprocess
import zlib

import numpy as np

EMPTY = {"segments": [], "cycles": [], "steps": [], "repetitions": [], "summary": [],
         "warnings": [], "reason": None, "period_s": None}
WRONG = 0.15  # of a period


class Row:
    """One figure of each build. `kind`: "of" adds pairs (got, possible); "trust" compares confidences
    with the share right; else the name of a function over the values. `limit`: a number, of the share
    if `kind` is "of", or "before"."""

    KINDS = {"median": np.median, "worst": np.max, "mean": np.mean, "sum": np.sum,
             "p95": lambda v: np.quantile(v, 0.95)}

    def __init__(self, builds, what, limit, kind, most, unit):
        self.what, self.limit, self.kind, self.most, self.unit = what, limit, kind, most, unit
        self.values = [[] for _ in range(builds)]

    def add(self, build, *value):
        self.values[build].append(value if self.kind == "of" else value[0])

    def figure(self, build):
        """The number to judge, and its text."""
        values = self.values[build]
        if not values:
            return None, "-"
        if self.kind == "of":
            got, possible = np.sum(values, 0)
            return got / max(possible, 1e-9), f"{got:.4g} of {possible:.4g}"
        if self.kind == "trust":
            said, right = np.mean(values, 0)
            return abs(said - right), f"{right:.3f} {said:.3f} n{len(values)}"
        value = float(self.KINDS[self.kind](values))
        return value, f"{value:.3g}{self.unit}"

    def passed(self):
        now, limit = self.figure(-1)[0], self.limit
        if limit == "before":
            limit = self.figure(0)[0] if len(self.values) > 1 else None
        few = self.kind == "trust" and len(self.values[-1]) < 20
        if now is None or limit is None or few:
            return None
        return bool(now <= limit + 1e-9 if self.most else now >= limit - 1e-9)

    def limit_text(self):
        sign = "at most " if self.most else "at least "
        percent = self.kind == "of" and self.limit not in (None, "before")
        unit = self.unit if self.limit != "before" else ""
        text = f"{100 * self.limit:g} %" if percent else f"{self.limit}{unit}"
        return "" if self.limit is None else sign + text


class Run:
    def __init__(self, builds, folder, options):
        self.builds, self.folder, self.options = builds, folder, options
        self.said = [[] for _ in builds]  # (confidence, right) of every cycle with a known truth
        self.missed, self.counted, self.number, self.name = [], 0, 0, ""

    # ---- Rows ----

    def heading(self):
        heads = ["before", "now"][-len(self.builds):]
        print(" | ".join([f"{'set':<12}", f"{'what counts':<58}", *(f"{h:>16}" for h in heads),
                          f"{'limit':>16}", "pass"]))

    def finished(self):
        """Prints the count of limits, and returns the exit status."""
        print(f"\n{self.counted - len(self.missed)} passed, {len(self.missed)} failed")
        return 1 if self.missed else 0

    def begin(self, name):
        self.name, self.rows = name, {}

    def row(self, what, limit=None, kind="of", most=False, unit=""):
        return self.rows.setdefault(what, Row(len(self.builds), what, limit, kind, most, unit))

    def end(self):
        for row in self.rows.values():
            if not any(row.values):
                continue
            figures = [row.figure(b)[1] for b in range(len(self.builds))]
            passed = row.passed()
            verdict = {None: "", True: "pass", False: "FAIL"}[passed]
            self.counted += passed is not None
            if passed is False:
                self.missed.append(f"{self.name}: {row.what}")
            line = [f"{self.name:<12}", f"{row.what:<58}", *(f"{f:>16}" for f in figures),
                    f"{row.limit_text():>16}", verdict]
            print(" | ".join(line).rstrip(" |"), flush=True)

    def note(self, build, ok, path, text):
        """Says with --show which cases are wrong."""
        if self.options.show and not ok:
            print(f"    {['before', 'now'][build - len(self.builds)]}  {path.name}  {text}")

    # ---- Cases ----

    def half(self, items):
        """(index, item) of the chosen half: even ones are for tuning, odd ones for the check."""
        wanted = {"tune": (0,), "check": (1,), "all": (0, 1)}[self.options.half]
        return [(i, item) for i, item in enumerate(items) if i % 2 in wanted]

    def cases(self, count, *key):
        """(index, random numbers) of the chosen half of `count` made-up cases."""
        if self.options.quick:
            count = max(4, count // 5)
        seed = zlib.crc32(" ".join(map(str, (self.name, *key))).encode())
        return [(i, np.random.default_rng([seed, i])) for i, _ in self.half(range(count))]

    def path(self, name, suffix=".csv"):
        self.number += 1
        return self.folder / f"{self.number:04d}-{re.sub('[^a-z0-9]+', '-', name.lower())}{suffix}"

    def table(self, name, rows, rate=None, names=None):
        """Writes columns; those of points with the time, others bare (then pass --fps)."""
        path = self.path(name)
        rows = np.asarray(rows)
        if rows.ndim == 3:
            names = [f"{n}_{axis}" for n in names for axis in "xyz"]
            rows = rows.reshape(len(rows), -1)
        if rate:
            rows = np.column_stack([np.arange(len(rows)) / rate, rows])
            names = ["time", *names]
        with open(path, "w", encoding="ascii") as file:
            file.write(",".join(names) + "\n" if names else "")
            np.savetxt(file, rows, "%.6g", ",")
        return path

    def command(self, build, *words):
        return subprocess.run([self.builds[build] / "tools" / "stltsa", *map(str, words)], check=False,
                              capture_output=True, text=True, stdin=subprocess.DEVNULL)

    def ask(self, path, *options, command="decompose"):
        """(index, answer) of each build. An answer that fails is empty, with the message as reason."""
        for build in range(len(self.builds)):
            done = self.command(build, command, path, *options, "--json")
            try:
                yield build, json.loads(done.stdout)
            except ValueError:
                yield build, {**EMPTY, "reason": f"exit {done.returncode}: {done.stderr.strip()[:200]}"}

    # ---- Cycles ----

    def judge(self, build, answer, pieces, what="", limit=0.97, wrong_limit=0):
        """Adds rows of cycles, right and wrong, and returns whether none is lost or wrong. `pieces`
        are pairs of times and turns. A cycle is right if it lasts one turn within 15 %, lies in a
        piece by half of it, and does not begin before the end of the last one."""
        right, last = 0, -np.inf
        for cycle in answer["cycles"]:
            a, b = cycle["begin_s"], cycle["end_s"]
            ok = a >= last - 0.02 and any(inside(t, p, a, b) for t, p in pieces)
            last = b
            right += ok
            self.said[build].append((cycle["confidence"], ok))
        possible, wrong = whole(pieces), len(answer["cycles"]) - right
        self.row(f"{what}cycles", limit).add(build, right, possible)
        self.row(f"{what}wrong ones", wrong_limit, "of", True).add(build, wrong, max(possible, 1))
        return right >= possible and not wrong


def inside(times, turns, a, b):
    """Whether [a, b] is a turn; half a turn of it may lie outside, where the pace goes on."""
    step = max(1, len(times) // 50)
    first = (turns[step] - turns[0]) / (times[step] - times[0])
    last = (turns[-1] - turns[-1 - step]) / (times[-1] - times[-1 - step])
    ends = np.interp([a, b], times, turns)
    ends += first * np.minimum([a - times[0], b - times[0]], 0)
    ends += last * np.maximum([a - times[-1], b - times[-1]], 0)
    covered = min(b, times[-1]) - max(a, times[0])
    return abs(ends[1] - ends[0] - 1) <= WRONG and covered >= 0.5 * (b - a)


def whole(pieces):
    """Whole turns in the pieces."""
    return sum(int(turns[-1] - turns[0] + 1e-6) for _, turns in pieces)


def counted(answer):
    """What the answer counts: cycles, repetitions, single actions."""
    return sum(s["count"] for s in answer["segments"] if s["kind"] != "rest")


def cyclic(answer):
    return [s for s in answer["segments"] if s["kind"] == "cyclic"]


def near(a, b, share=0.1):
    return a is not None and b is not None and abs(a / b - 1) <= share


def numbers(answer):
    """Periods that an answer names, in figures or in words."""
    words = " ".join([answer["reason"] or "", *(w["text"] for w in answer["warnings"]),
                      *(s["reason"] or "" for s in answer["segments"])])
    found = [s[key] for s in answer["segments"] for key in ("period_s", "candidate_period_s")]
    return [*found, *map(float, re.findall(r"([0-9]+\.?[0-9]*) s", words))]


def kinds(answer):
    return ", ".join(f"{s['kind']} {s['count']}" + (f" of {s['period_s']:.2f} s" if s["period_s"] else "")
                     + f" ({s['confidence']:.2f})" for s in answer["segments"]) or answer["reason"]
